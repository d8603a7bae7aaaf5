//! `hooke bench`: run time against error.

use std::fmt::Write as _;
use std::fs;
use std::io::{IsTerminal, stderr};
use std::time::Duration;

use super::Outcome;
use super::arguments::BenchArguments;
use super::failure::Failure;
use super::interrupt;
use super::outputs::{check_place, is_standard_output};
use super::print;
use super::scene::{Loaded, out_of_range};
use super::table::rows;
use crate::bench::{Bench, Contender, Point, Reference, Swept, Winner, bench as measure, winners};
use crate::simulate::RunError;
use crate::units::{count, metres, seconds};

pub(super) fn bench(arguments: &BenchArguments) -> Result<Outcome, Failure> {
    let loaded = Loaded::load(&arguments.scene, &arguments.overrides)?;
    let (to_standard_output, file) = match arguments.out.as_deref() {
        Some(out) if is_standard_output(out) => (true, None),
        out => (false, out),
    };
    if let Some(file) = file {
        check_place(file, "the table's place")?;
    }
    let longest = Duration::try_from_secs_f64(arguments.longest).map_err(|error| {
        let message = format!("--longest {}: {error}", arguments.longest);
        Failure::input(message, "write a number of seconds, such as 1")
    })?;
    let settings = loaded.scene.settings();
    let shown = stderr().is_terminal();
    if shown {
        print::message("making a reference …");
    }
    let tell = |swept: &Swept| {
        if shown {
            print::message(&format!("  {}", told(swept)));
        }
    };
    let measured = measure(&loaded.model, settings, longest, interrupt::watch(), tell);
    let Some(measured) = measured.map_err(|error| refused(&error))? else { return Ok(Outcome::Interrupted) };
    let (report, table) = (report(&settings.name, &measured), csv(&settings.name, &measured));
    if to_standard_output {
        print::message(&report);
        print::data(table)?;
    } else {
        print::data(report)?;
        if let Some(file) = file {
            fs::write(file, table).map_err(|error| {
                let message = format!("cannot write {}: {error}", file.display());
                Failure::failed(message, "make room there, or write to another place")
            })?;
        }
    }
    Ok(if measured.interrupted { Outcome::Interrupted } else { Outcome::Done })
}

fn refused(error: &RunError) -> Failure {
    match error {
        RunError::Build(error) => out_of_range(error),
        other => Failure::failed(other.to_string(), "run it alone first: hooke run SCENE"),
    }
}

/// A contender's best.
fn told(swept: &Swept) -> String {
    let Swept { contender, points } = swept;
    let best = points
        .iter()
        .filter(|point| point.error.is_some())
        .min_by(|left, right| left.error.unwrap_or(f64::INFINITY).total_cmp(&right.error.unwrap_or(f64::INFINITY)));
    let runs = points.len();
    match best {
        Some(Point { error: Some(error), seconds: time, .. }) => {
            format!("{}: {runs} runs, down to {} in {}", name(*contender), metres(*error), seconds(*time))
        }
        _ => format!("{}: {runs} runs, all of which diverged", name(*contender)),
    }
}

fn name(contender: Contender) -> String {
    format!("{} {}", contender.stepper, contender.precision)
}

fn report(name: &str, bench: &Bench) -> String {
    let mut lines = vec![name.to_owned()];
    lines.extend(reference(&bench.reference).into_iter().map(|line| format!("  {line}")));
    lines.push(String::new());
    lines.push("fastest to reach an error".to_owned());
    let mut table = vec![["error", "stepper", "time step", "time", "force evaluations"].map(str::to_owned)];
    table.extend(winners(bench).iter().map(row));
    lines.extend(rows(&table, 2));
    if bench.interrupted {
        lines.push(String::new());
        lines.push("interrupted: not all steppers have run".to_owned());
    }
    lines.join("\n") + "\n"
}

fn reference(reference: &Reference) -> Vec<String> {
    if reference.positions.is_empty() {
        return vec!["no reference: dop853 diverges on this scene".to_owned()];
    }
    let mut lines = vec![format!(
        "reference: dop853 in f64, {} steps; half as many end {} away",
        count(reference.steps),
        metres(reference.settled)
    )];
    match reference.confirmed {
        Some((stepper, distance)) => {
            lines.push(format!("confirmed by {stepper}, which ends {} away", metres(distance)));
        }
        None => lines.push("no other method confirms it".to_owned()),
    }
    lines.push(format!(
        "a small change of the start has grown {:.3} times by the end: no error below {} is claimed",
        reference.growth,
        metres(reference.floor())
    ));
    lines
}

fn row(winner: &Winner) -> [String; 5] {
    let error = metres(winner.error);
    match winner.run {
        Some((contender, point)) => {
            [error, name(contender), seconds(point.time_step), seconds(point.seconds), count(point.force_evaluations)]
        }
        None => [error, "none".to_owned(), String::new(), String::new(), String::new()],
    }
}

fn csv(name: &str, bench: &Bench) -> String {
    let Reference { steps, settled, growth, .. } = &bench.reference;
    let mut text = format!(
        "# {}: errors against dop853 in f64, {steps} steps, settled to {settled:e} m; growth {growth:e}\n",
        name.replace('\n', " ")
    );
    text.push_str("stepper,precision,steps,time_step,error,seconds,force_evaluations,linear_work\n");
    for Swept { contender, points } in &bench.swept {
        for point in points {
            // A run that diverged has no error: a missing point.
            let error = point.error.map_or_else(String::new, |error| format!("{error:e}"));
            let _ = writeln!(
                text,
                "{},{},{},{:e},{error},{:e},{},{}",
                contender.stepper,
                contender.precision,
                point.steps,
                point.time_step,
                point.seconds,
                point.force_evaluations,
                point.linear_work
            );
        }
    }
    text
}
