//! What a measurement tells on the terminal.

use crate::bench::{Bench, Winner, winners};
use crate::cli::table::rows;
use crate::report::{advice, other_machine, reference_facts, rival_rows, run_cells};
use crate::units::metres;

pub(super) fn report(bench: &Bench) -> String {
    let mut lines = vec![bench.name.clone()];
    lines.extend(reference_facts(&bench.reference).into_iter().map(|line| format!("  {line}")));
    let winners = winners(bench);
    if !winners.is_empty() {
        lines.push(String::new());
        lines.push("fastest to reach an error".to_owned());
        let head = ["error", "stepper", "time step", "time", "force evaluations", "iterations", "workspace"];
        let mut table = vec![head.map(str::to_owned)];
        table.extend(winners.iter().map(row));
        lines.extend(rows(&table, 2));
        lines.push(String::new());
        lines.push(advice(&winners));
    }
    if !bench.peers.is_empty() {
        lines.push(String::new());
        lines.extend(rivals(bench, &winners));
    }
    if bench.interrupted {
        lines.push(String::new());
        lines.push("interrupted: not all has been measured".to_owned());
    }
    lines.join("\n") + "\n"
}

fn row(winner: &Winner) -> [String; 7] {
    let nobody = || ["none", "", "", "", "", ""].map(str::to_owned);
    let cells = winner.run.map_or_else(nobody, |(contender, point)| run_cells(contender, &point));
    let [who, time_step, time, force_evaluations, iterations, workspace] = cells;
    [metres(winner.error), who, time_step, time, force_evaluations, iterations, workspace]
}

/// The fastest of others at each error.
fn rivals(bench: &Bench, winners: &[Winner]) -> Vec<String> {
    let mut lines = vec!["fastest of others".to_owned()];
    lines.extend(rows(&rival_rows(bench, winners), 2));
    lines.extend(other_machine(bench).map(|said| format!("  {said}")));
    lines
}
