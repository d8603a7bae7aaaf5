//! What measurements say, in words.

use crate::bench::{Asked, Bench, Contender, Point, Recommended, Reference, Winner, recommended};
use crate::units::{bytes, count, metres, seconds, short, times};

/// What to use for which error.
#[must_use]
pub fn advice(winners: &[Winner]) -> String {
    let said = recommended(winners).iter().map(take).collect::<Vec<_>>().join("; ");
    let mut letters = said.chars();
    match letters.next() {
        Some(first) => format!("{}{}.", first.to_uppercase(), letters.as_str()),
        None => "No error is known well enough to say what to use.".to_owned(),
    }
}

/// `for 100 µm to 1 nm take dop853 in f64 at 7.812 to 1.953 ms: 12 to 47 ms of computing`
fn take(recommended: &Recommended) -> String {
    let Recommended { contender, loosest, tightest } = recommended;
    let range = |of: &dyn Fn(&(f64, Point)) -> String| {
        let (from, to) = (of(loosest), of(tightest));
        if from == to { from } else { format!("{from} to {to}") }
    };
    let at = match (loosest.1.asked, tightest.1.asked) {
        (Asked::Tolerance(_), Asked::Tolerance(_)) => {
            let tolerance =
                |(_, point): &(f64, Point)| point.asked.tolerance().map_or_else(String::new, |to| format!("{to:e}"));
            format!("a tolerance of {}", range(&tolerance))
        }
        _ => range(&|(_, point)| seconds(point.time_step)),
    };
    let form = contender.collision.map_or_else(String::new, |form| format!(" with {form}"));
    format!(
        "for {} take {} in {}{form} at {}: {} of computing",
        range(&|(error, _)| metres(*error)),
        contender.method(),
        contender.precision,
        at,
        range(&|(_, point)| seconds(point.seconds))
    )
}

/// What peers that were measured elsewhere say of the machine there.
#[must_use]
pub fn other_machine(bench: &Bench) -> Option<String> {
    let ratio = bench.other_machine()?;
    Some(format!("a step of Hooke took {} as long there as here", times(ratio)))
}

/// The fastest of others at each error, and how many times as long as the winner it takes.
#[must_use]
pub fn rival_rows(bench: &Bench, winners: &[Winner]) -> Vec<[String; 4]> {
    let row = |winner: &Winner| match bench.rival(winner.error) {
        Some((peer, run)) => {
            let ratio = winner.run.map_or_else(String::new, |(_, point)| times(run.seconds / point.seconds));
            [metres(winner.error), peer.label.clone(), seconds(run.seconds), ratio]
        }
        None => [metres(winner.error), "none".to_owned(), String::new(), String::new()],
    };
    let head = ["error", "who", "time", "Hooke is faster"].map(str::to_owned);
    std::iter::once(head).chain(winners.iter().map(row)).collect()
}

/// What errors are measured against, and how far that is known: a sentence each.
#[must_use]
pub fn reference_facts(reference: &Reference) -> Vec<String> {
    if reference.states.is_empty() {
        return vec!["no reference: dop853 diverges on this scene".to_owned()];
    }
    let mut facts = vec![format!(
        "reference: dop853 in f64, {} steps; half as many end {} away",
        count(reference.steps),
        metres(reference.settled)
    )];
    match reference.confirmed {
        Some((stepper, distance)) => {
            facts.push(format!("confirmed by {stepper}, which ends {} away", metres(distance)));
        }
        None => facts.push("no other method confirms it".to_owned()),
    }
    if let Some(distance) = reference.closed_form {
        facts.push(format!("closed form: agrees to {}", metres(distance)));
    }
    facts.push(format!(
        "a small change of the start grows {} times at most: no error below {} is claimed",
        growth(reference.growth),
        metres(reference.floor())
    ));
    facts
}

fn growth(growth: f64) -> String {
    if growth < 1e5 { short(growth) } else { format!("{growth:.1e}") }
}

/// A run in a table of winners: who, with which time step or tolerance, and what it took.
pub fn run_cells(contender: Contender, point: &Point) -> [String; 6] {
    [
        contender.to_string(),
        if contender.is_adaptive { point.asked.to_string() } else { seconds(point.time_step) },
        seconds(point.seconds),
        count(point.force_evaluations),
        count(point.iterations),
        bytes(point.workspace as u128),
    ]
}
