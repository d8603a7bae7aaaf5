//! Explicit Euler where nothing takes out the energy that it puts in.

use super::{Advice, Remedy, Subject, Topic};
use crate::scene::StepperName;
use crate::units::seconds;

/// Each of its steps multiplies an undamped oscillation of frequency ω by √(1 + ω²dt²).
pub(super) fn growing(subject: &Subject<'_>) -> Option<Advice> {
    let Subject { settings, start, .. } = subject;
    if settings.stepper != StepperName::ExplicitEuler {
        return None;
    }
    let (bound, time_step) = (start.bound?, start.time_step?);
    if bound.explicit_euler > 0.0 {
        return None;
    }
    let tenfold = 10_f64.ln() * 2.0 * time_step / (bound.frequency * time_step).powi(2).ln_1p();
    let message = format!(
        "explicit-euler adds energy to undamped springs at any time step: here the fastest motion may grow tenfold in \
         {} of simulated time",
        seconds(tenfold)
    );
    let remedy = Remedy::of(settings, start)?;
    let remedy = format!("use {}, which costs the same, or damp every spring", remedy.flags(settings));
    Some(Advice { topic: Topic::GrowingEnergy, message, remedy })
}
