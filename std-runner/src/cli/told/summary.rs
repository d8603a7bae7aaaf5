//! What a run did, in a page.

use super::accuracy::accuracy;
use super::ledger::ledger;
use crate::accuracy::Attained;
use crate::advice::skipped;
use crate::cli::table::rows;
use crate::scene::Settings;
use crate::simulate::{Ending, Summary, chooses_steps};
use crate::units::{count, counted, seconds};

/// All of it, for standard error.
pub(in crate::cli) fn summary(
    settings: &Settings,
    summary: &Summary,
    attained: Option<&Attained>,
    files: &[String],
) -> String {
    let mut facts = vec![fact("reached", reached(settings, summary))];
    match attained {
        Some(attained) => {
            facts.push(fact("steps", steps_within(settings, summary, attained)));
            facts.extend(accuracy(attained));
        }
        None => facts.push(fact("steps", steps(settings, summary))),
    }
    facts.extend(summary.choices.iter().map(|choice| fact("auto chose", choice.to_string())));
    facts.push(fact("frames", frames(summary, files)));
    facts.push(fact("wall time", wall_time(summary)));
    facts.extend(summary.digest.map(|digest| fact("digest", format!("{digest:016x}"))));
    facts.extend(solver(settings, summary));
    if summary.plan.planes > 0 {
        facts.push(fact("hits", count(summary.hits)));
    }
    if summary.capped > 0 {
        let what = "times a particle was stopped on a plane, its bounces being too many to follow";
        facts.push(fact("capped", format!("{} {what}", count(summary.capped))));
    }
    if settings.sleep_speed.is_some() {
        let islands = counted(summary.plan.islands.into(), "island");
        facts.push(fact("asleep", format!("{} of {islands} at the end", count(summary.islands_asleep.into()))));
    }
    if summary.degenerate_springs > 0 {
        let springs = counted(summary.degenerate_springs.into(), "spring");
        facts.push(fact("length 0", format!("up to {springs} at once; without a direction they pull at nothing")));
    }
    facts.extend(skipped(&summary.plan).into_iter().map(|skipped| fact("left out", skipped)));
    let mut lines = vec![settings.name.clone()];
    lines.extend(rows(&facts, 2));
    // Energies of a state about to overflow tell nothing.
    if let Some(balance) = &summary.balance
        && !matches!(summary.ending, Ending::NonFinite { .. })
    {
        lines.extend(ledger(balance));
    }
    lines.join("\n")
}

fn fact(name: &str, value: String) -> [String; 2] {
    [name.to_owned(), value]
}

fn reached(settings: &Settings, summary: &Summary) -> String {
    let duration = seconds(settings.duration);
    if summary.time >= settings.duration {
        format!("{duration}, the whole duration")
    } else {
        format!("{} of {duration}", seconds(summary.time))
    }
}

fn steps(settings: &Settings, summary: &Summary) -> String {
    let precision = settings.precision;
    if chooses_steps(settings) && summary.plan.attached > 0 {
        let Settings { stepper, tolerance, .. } = settings;
        let again = if summary.rejected > 0 {
            format!(", and {} that it took again, shorter", count(summary.rejected))
        } else {
            String::new()
        };
        return format!(
            "{} chosen by {stepper} to a tolerance of {tolerance:e}{again}, {precision}",
            count(summary.parts)
        );
    }
    let Some(time_step) = summary.time_step else {
        return format!("{} from frame to frame, {}, {precision}", count(summary.steps), settings.stepper);
    };
    let last = match summary.schedule.short_step() {
        Some(short) if summary.steps == summary.schedule.steps() => {
            format!("; the last step is {}, since the duration is not a whole number of steps", seconds(short))
        }
        _ => String::new(),
    };
    format!("{} of {}, {}, {precision}{last}", count(summary.steps), seconds(time_step), settings.stepper)
}

fn steps_within(settings: &Settings, summary: &Summary, attained: &Attained) -> String {
    let (shortest, longest) = attained.time_steps;
    let lengths = match [shortest, longest].map(seconds) {
        [shortest, longest] if shortest == longest => shortest,
        [shortest, longest] => format!("{shortest} to {longest}"),
    };
    format!("{} of {lengths}, {}, {}", count(summary.steps), settings.stepper, settings.precision)
}

fn frames(summary: &Summary, files: &[String]) -> String {
    let place =
        if files.is_empty() { "not recorded (no --out)".to_owned() } else { format!("to {}", files.join(", ")) };
    format!("{}, {place}", count(summary.frames))
}

fn wall_time(summary: &Summary) -> String {
    let stepping = seconds(summary.stepping.as_secs_f64());
    let recording = if summary.recording.is_zero() {
        String::new()
    } else {
        let [waiting, recording] = [summary.waiting, summary.recording].map(|time| seconds(time.as_secs_f64()));
        format!(", waiting for frames {waiting}, recording them {recording} meanwhile")
    };
    let each = summary
        .nanoseconds_per_spring_step()
        .map_or_else(String::new, |nanoseconds| format!("; {nanoseconds:.1} ns per spring and step"));
    let threads = if summary.threads > 1 { format!(" on {} threads", summary.threads) } else { String::new() };
    format!("stepping {stepping}{threads}{recording}{each}")
}

/// Of the implicit steppers.
fn solver(settings: &Settings, summary: &Summary) -> Vec<[String; 2]> {
    if summary.iterations == 0 && summary.linear_iterations == 0 {
        return Vec::new();
    }
    let per_step = |number: u64| number as f64 / summary.steps.max(1) as f64;
    let iterations = format!(
        "{} Newton iterations ({:.1} a step), {} of the linear solver ({:.1} a step)",
        count(summary.iterations),
        per_step(summary.iterations),
        count(summary.linear_iterations),
        per_step(summary.linear_iterations),
    );
    let factorisations = match summary.factorisations {
        0 => String::new(),
        number => format!("; {} factorisations", count(number)),
    };
    let iterations = iterations + &factorisations;
    // A step is solved, too, where rounding leaves nothing to improve.
    let allowed = if summary.residual > settings.tolerance && summary.unconverged == 0 {
        format!(", where rounding in {} allows no less", settings.precision)
    } else {
        String::new()
    };
    let residual = format!("{:.1e} at most; the tolerance is {:.1e}{allowed}", summary.residual, settings.tolerance);
    let unconverged = if summary.unconverged == 0 {
        "none".to_owned()
    } else {
        format!("{} of {}", count(summary.unconverged), counted(summary.steps, "step"))
    };
    let mut facts = vec![fact("solver", iterations)];
    facts.extend(summary.linear_solver.map(|solver| fact("linear solver", solver.to_string())));
    facts.extend([fact("residual", residual), fact("unconverged", unconverged)]);
    facts
}
