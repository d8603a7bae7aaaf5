//! How a run came to the accuracy that was asked for.

use crate::accuracy::{Attained, Choice, Ratio};
use crate::cli::Outcome;
use crate::cli::failure::Failure;
use crate::scene::Settings;
use crate::units::{counted, metres, seconds, times};

/// What is told of it in the summary: names and values.
pub(super) fn accuracy(attained: &Attained) -> Vec<[String; 2]> {
    let fact = |name: &str, value: String| [name.to_owned(), value];
    let mut facts = vec![fact("error", error(attained)), fact("found", found(attained))];
    let again = [(attained.returns, "going back to go on in shorter steps"), (attained.restarts, "beginning anew")];
    let again: Vec<String> = again
        .iter()
        .filter(|(number, _)| *number > 0)
        .map(|(number, what)| format!("{what} {}", counted(u64::from(*number), "time")))
        .collect();
    if !again.is_empty() {
        facts.push(fact("corrected", format!("by {}", again.join(", and by "))));
    }
    facts
}

fn error(attained: &Attained) -> String {
    let Attained { asked, estimate, choice, .. } = attained;
    let beside = match choice.ratio {
        Ratio::One => format!("in {}", choice.companion),
        ratio => format!("in steps {} as long, in {}", times(ratio.value()), choice.companion),
    };
    format!("about {} at most, by a run beside this one {beside}; {} was asked for", metres(*estimate), metres(*asked))
}

fn found(attained: &Attained) -> String {
    let Choice { stepper, precision, cost, .. } = &attained.choice;
    let others: Vec<String> = attained
        .others
        .iter()
        .fold(Vec::new(), |mut told: Vec<(_, f64)>, other| {
            if told.iter().all(|(stepper, _)| *stepper != other.stepper) {
                told.push((other.stepper, other.cost / cost));
            }
            told
        })
        .into_iter()
        .map(|(stepper, ratio)| format!("{stepper} might take {} as long", times(ratio)))
        .collect();
    if attained.choice.ratio == Ratio::One {
        return format!("{stepper} in {precision}: no spring pulls, so flight is exact and only rounding is left");
    }
    if attained.prefix == 0.0 {
        return format!("{stepper} in {precision}, without pilot runs: so few of its steps are over as soon");
    }
    let others = if others.is_empty() { String::new() } else { format!("; {}", others.join(", ")) };
    format!("{stepper} in {precision}, by pilot runs of {}{others}", seconds(attained.prefix))
}

/// Whether what was asked for holds to the end.
pub(in crate::cli) fn held(settings: &Settings, attained: &Attained, outcome: Outcome) -> Result<Outcome, Failure> {
    let Some(until) = attained.held_until else { return Ok(outcome) };
    let message = format!(
        "the error stays below {} until {} only: by {} it may be {}",
        metres(attained.asked),
        seconds(until),
        seconds(settings.duration),
        metres(attained.estimate),
    );
    let remedy = "motion that magnifies every small change, as chaotic motion does, cannot be followed for long: use a \
                  shorter --duration, or a larger --max-error";
    Err(Failure::failed(message, remedy))
}
