//! Explicit Euler where nothing takes out the energy that it puts in.

use super::{Advice, Remedy, Subject, Topic};
use crate::scene::StepperName;
use crate::units::seconds;

/// Growth that takes more than so many durations is not worth a word.
const SLOW: f64 = 10.0;

/// Each of its steps multiplies an undamped oscillation of frequency ω by √(1 + ω²dt²), and damping takes out what the
/// least k_d/k of any spring would have added as a time step.
pub(super) fn growing(subject: &Subject<'_>) -> Option<Advice> {
    let Subject { settings, start, .. } = subject;
    if settings.stepper != StepperName::ExplicitEuler {
        return None;
    }
    let (bound, time_step) = (start.bound?, start.time_step?);
    let limit = bound.explicit_euler;
    if time_step <= limit {
        return None;
    }
    let unopposed = (bound.frequency * time_step).powi(2).ln_1p() / (2.0 * time_step);
    let tenfold = 10_f64.ln() / (unopposed * (1.0 - limit / time_step));
    let (message, instead) = if limit > 0.0 {
        if tenfold > SLOW * settings.duration {
            return None;
        }
        let message = format!(
            "explicit-euler adds more energy at a time step of {} than the damping takes out, which it does below {} \
             at best",
            seconds(time_step),
            seconds(limit)
        );
        (message, "")
    } else {
        let message = "explicit-euler adds energy to undamped springs at any time step".to_owned();
        (message, ", or damp every spring")
    };
    let message = format!("{message}: the fastest motion may grow tenfold in {} of simulated time", seconds(tenfold));
    let remedy = format!("use {}{instead}", Remedy::of(settings, start)?.flags(settings));
    Some(Advice { topic: Topic::GrowingEnergy, message, remedy })
}
