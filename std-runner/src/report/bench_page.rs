//! The page of a measurement.

use super::over_time::{energy_over_time, error_over_time};
use super::page::{Block, Page, Section};
use super::told::{advice, other_machine, reference_facts, rival_rows, run_cells};
use super::work_precision::{Work, work_precision};
use crate::bench::{Bench, Compared, Winner, machine, winners, yardstick};
use crate::chart::ChartError;
use crate::units::{joules, metres, metres_per_second, seconds};

/// All scenes, one section each.
///
/// # Errors
/// If a diagram cannot be drawn.
pub fn bench_page(benches: &[Bench]) -> Result<Page, ChartError> {
    let names: Vec<&str> = benches.iter().map(|bench| bench.name.as_str()).collect();
    Ok(Page {
        title: format!("Run time against error: {}", names.join(", ")),
        lead: "Every stepper, in every precision, at time steps from the edge of stability down to where shorter ones gain \
               nothing, or at tolerances from 1e-2 on: what it costs, and how far it is from the true motion."
            .to_owned(),
        sections: benches.iter().map(section).collect::<Result<_, _>>()?,
        made_by: format!("hooke {}, one thread of {}", env!("CARGO_PKG_VERSION"), machine()),
    })
}

fn section(bench: &Bench) -> Result<Section, ChartError> {
    let winners = winners(bench);
    let mut blocks = vec![Block::Advice(advice(&winners))];
    if bench.interrupted {
        blocks.push(Block::Text("The measurement was interrupted: not all steppers have run.".to_owned()));
    }
    if !bench.swept.is_empty() {
        blocks.extend(diagrams(bench)?);
        blocks.push(Block::Heading("Fastest to reach an error".to_owned()));
        blocks.push(table(&winners));
        blocks.push(Block::Text(format!(
            "Implicit steppers solve each step to a relative residual of {:e}, which is the scene's tolerance. Tolerances of \
             adaptive ones are the largest error of a step, relative to the scene's size.",
            bench.tolerance
        )));
    }
    if !bench.peers.is_empty() {
        blocks.extend(peers(bench, &winners));
    }
    if !bench.traces.is_empty() {
        blocks.extend(over_time(bench)?);
    }
    blocks.push(Block::Heading("What errors are measured against".to_owned()));
    blocks.extend(reference_facts(&bench.reference).into_iter().map(|fact| Block::Text(sentence(&fact))));
    Ok(Section { heading: bench.name.clone(), blocks })
}

fn diagrams(bench: &Bench) -> Result<[Block; 4], ChartError> {
    let one = std::slice::from_ref(bench);
    Ok([
        Block::Heading("Work and precision".to_owned()),
        Block::figure(
            &work_precision(one, Work::Time),
            "Each mark is a run; from right to left its time step halves, or its tolerance falls to a tenth. Lower is faster, further left is more exact, and \
             the flatter a line, the higher its order, as the triangles show. Runs that diverged are not there. Within the shade \
             the reference itself is not known well enough.",
        )?,
        Block::figure(
            &work_precision(one, Work::ForceEvaluations),
            "The same, counted in evaluations of all forces: what does not depend on the machine. Implicit steppers also solve \
             linear systems, which this leaves out.",
        )?,
        Block::Text(format!(
            "The error is the largest distance of any particle from the reference {}. The time is that of one thread, the shortest \
             of up to twenty runs, without recording.",
            match bench.compared {
                Compared::Throughout => "at sixteen times, the last at the end",
                Compared::AtEnd => "at the end",
            }
        )),
    ])
}

fn table(winners: &[Winner]) -> Block {
    let head = [
        "error",
        "stepper",
        "time step",
        "time",
        "force evaluations",
        "iterations",
        "workspace",
        "velocity error",
        "energy residual",
        "bounce time",
        "depth in planes",
    ];
    let has_planes = winners.iter().filter_map(|winner| winner.run).any(|(_, point)| point.penetration.is_some());
    let columns = if has_planes { head.len() } else { head.len() - 2 };
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(winners.iter().map(row));
    rows.iter_mut().for_each(|row| row.truncate(columns));
    Block::Table {
        rows,
        caption: "The cheapest run of all whose error is no larger, and what else is known of it.".to_owned(),
    }
}

fn row(winner: &Winner) -> Vec<String> {
    let mut cells = vec![metres(winner.error)];
    if let Some((contender, point)) = winner.run {
        let known = |value: Option<f64>, shown: fn(f64) -> String| value.map_or_else(String::new, shown);
        cells.extend(run_cells(contender, &point));
        cells.extend([
            known(point.velocity_error, metres_per_second),
            known(point.energy_residual, joules),
            known(point.bounce_time_error, seconds),
            known(point.penetration, metres),
        ]);
    } else {
        cells.push("nobody".to_owned());
    }
    cells.resize(11, String::new());
    cells
}

fn peers(bench: &Bench, winners: &[Winner]) -> Vec<Block> {
    let rows = rival_rows(bench, winners).into_iter().map(|row| row.to_vec()).collect();
    let caption = "The cheapest run of another engine or solver whose error at the end is no larger.".to_owned();
    let mut blocks = vec![Block::Heading("Others".to_owned()), Block::Table { rows, caption }];
    blocks.extend(
        other_machine(bench).map(|said| Block::Text(sentence(&format!("they were measured in another run: {said}")))),
    );
    blocks
}

fn over_time(bench: &Bench) -> Result<Vec<Block>, ChartError> {
    let Some((contender, point)) = yardstick(&bench.swept, &bench.reference) else { return Ok(Vec::new()) };
    let error = point.error.map_or_else(String::new, metres);
    Ok(vec![
        Block::Heading("For about the same computing time".to_owned()),
        Block::Text(format!(
            "{contender} gets to an error of {error} in {}. Here is every stepper in f64, at the time step at which it takes most \
             nearly as long; who takes less than a third of that at its shortest step, or more than three times at its longest, is \
             not there.",
            seconds(point.seconds)
        )),
        Block::figure(&error_over_time(bench), "How far each run is from the reference as time goes on.")?,
        Block::figure(
            &energy_over_time(bench),
            format!(
                "The size of what is missing from the balance of energy, or too much in it: kinetic, elastic and gravitational, with \
                 what damping and impacts took. The motion has up to {} of kinetic energy. Where springs are damped, what \
                 damping took is summed by the trapezoidal rule over steps: its own error is in the balance too, and methods \
                 of high order do not get below it.",
                joules(bench.reference.kinetic)
            ),
        )?,
    ])
}

/// With a capital letter and a full stop.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| format!("{}{}.", first.to_uppercase(), letters.as_str()))
}
