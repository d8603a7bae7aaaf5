//! Whether a run is what was asked for, and if not, why and what to do.

use crate::advice::{Remedy, limit_in_words};
use crate::cli::Outcome;
use crate::cli::failure::Failure;
use crate::model::Model;
use crate::scene::{Precision, Settings, StepperName};
use crate::simulate::{Ending, Start, Summary, chooses_steps, largest_stable_step};
use crate::units::{count, counted, seconds, short, times};

/// What the caller and the person are told.
pub(in crate::cli) fn outcome(
    model: &Model,
    settings: &Settings,
    summary: &Summary,
    recorded: bool,
) -> Result<Outcome, Failure> {
    match summary.ending {
        Ending::NonFinite { particle } => Err(non_finite(model, settings, summary, particle, recorded)),
        Ending::Refused(error) => {
            let message = format!("the step after {} could not be taken: {error}", seconds(summary.time));
            Err(Failure::failed(
                message,
                format!("use another time step, or --precision f64{}", readable(summary, recorded)),
            ))
        }
        Ending::Interrupted => Ok(Outcome::Interrupted),
        Ending::Finished if summary.unconverged > 0 => Err(unconverged(settings, summary, recorded)),
        Ending::Finished => Ok(Outcome::Done),
    }
}

fn readable(summary: &Summary, recorded: bool) -> String {
    if recorded {
        format!("; the {} written so far can be read", counted(summary.frames, "frame"))
    } else {
        String::new()
    }
}

fn non_finite(model: &Model, settings: &Settings, summary: &Summary, particle: u32, recorded: bool) -> Failure {
    let start = Start {
        schedule: summary.schedule,
        plan: summary.plan,
        bound: summary.bound,
        time_step: summary.time_step,
        linear_solver: summary.linear_solver,
    };
    let (cause, remedy) = cause(model, settings, &start);
    let message = format!(
        "particle {particle} became infinite or NaN in the step after {}: {cause}{}",
        seconds(summary.time),
        readable(summary, recorded)
    );
    Failure::failed(message, remedy)
}

/// The likely cause, and what to do.
fn cause(model: &Model, settings: &Settings, start: &Start) -> (String, String) {
    let stepper = settings.stepper;
    if chooses_steps(settings) && start.bound.is_some() {
        let cause = format!("in the shortest steps that {stepper} takes its values have outgrown the precision");
        let wider = if settings.precision == Precision::F64 { "" } else { "--precision f64, " };
        return (cause, format!("use {wider}smaller velocities, softer springs, or a shorter duration"));
    }
    let (Some(bound), Some(time_step), Some(remedy)) = (start.bound, start.time_step, Remedy::of(settings, start))
    else {
        let wider = if settings.precision == Precision::F32 { "use --precision f64, or " } else { "" };
        let cause = "no spring pulls at it, so its values have outgrown the precision".to_owned();
        return (cause, format!("{wider}give it a smaller velocity, or a shorter duration"));
    };
    let flags = remedy.flags(settings);
    let limit = largest_stable_step(stepper, &bound);
    // Its bound says where it may be stable, and is often 0: it is not what a time step can be compared with.
    if stepper == StepperName::ExplicitEuler {
        let cause = format!(
            "a time step of {} is too long for {stepper}: the fastest motion, {} rad/s at {}, gains energy in every step",
            seconds(time_step),
            short(bound.frequency),
            limit_in_words(model, &bound)
        );
        return (cause, format!("use {flags}, or --stepper implicit-euler"));
    }
    if time_step > limit {
        let cause = format!(
            "the time step of {} is {} the largest at which {stepper} is sure to be stable, {}, which {} sets",
            seconds(time_step),
            times(time_step / limit),
            seconds(limit),
            limit_in_words(model, &bound)
        );
        return (cause, format!("use {flags}, or --stepper implicit-euler"));
    }
    let cause = format!(
        "at the start the time step of {} was within the bound of {stepper}; since then springs have stretched, or the \
         values have outgrown the precision",
        seconds(time_step)
    );
    let wider = if settings.precision == Precision::F32 { ", or --precision f64" } else { "" };
    (cause, format!("use --time-step {:?}{wider}", time_step / 4.0))
}

fn unconverged(settings: &Settings, summary: &Summary, recorded: bool) -> Failure {
    if chooses_steps(settings) {
        return unmet(settings, summary, recorded);
    }
    let message = format!(
        "{} of {} were not solved to the tolerance of {:e}: the largest residual is {:.1e}{}",
        count(summary.unconverged),
        counted(summary.steps, "step"),
        settings.tolerance,
        summary.residual,
        if recorded { "; all frames were written" } else { "" }
    );
    let floor = if settings.precision == Precision::F32 { ", or --precision f64" } else { "" };
    let step = summary.time_step.map_or_else(String::new, |step| format!(" than {step:?}"));
    Failure::failed(message, format!("use a smaller --time-step{step}, or a looser --tolerance{floor}"))
}

/// Steps that even at their shortest are more wrong than they may be.
fn unmet(settings: &Settings, summary: &Summary, recorded: bool) -> Failure {
    let message = format!(
        "{} cannot keep errors below the tolerance of {:e} in {}, however short its steps: the largest is {:.1e} times that{}",
        settings.stepper,
        settings.tolerance,
        settings.precision,
        summary.residual,
        if recorded { "; all frames were written" } else { "" }
    );
    let wider = if settings.precision == Precision::F64 { "" } else { ", or --precision f64" };
    Failure::failed(message, format!("use a looser --tolerance{wider}"))
}
