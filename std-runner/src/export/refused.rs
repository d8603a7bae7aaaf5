//! What data in a program's source cannot hold.

use crate::model::{Hold, Model};
use crate::scene::{Precision, Settings};
use crate::simulate::chooses_steps;

/// Why a scene was not exported.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {reason}")]
pub struct Refused {
    /// `particle 3`, say.
    pub place: String,
    /// What about it.
    pub reason: String,
    /// What to do instead.
    pub remedy: String,
}

impl Refused {
    fn new(place: impl Into<String>, reason: &str, remedy: &str) -> Self {
        Self { place: place.into(), reason: reason.to_owned(), remedy: remedy.to_owned() }
    }
}

/// Refuses what has no place in the exported source.
pub fn check(model: &Model, settings: &Settings) -> Result<(), Refused> {
    if let Some(number) = model.particles.iter().position(|particle| matches!(particle.hold, Hold::Track(_))) {
        return Err(Refused::new(
            format!("particle {number}"),
            "it follows keyframes, and exported data holds no motion",
            "pin it, and move it in the program: World::set_hold and World::drive",
        ));
    }
    if settings.max_error.is_some() {
        return Err(Refused::new(
            "max_error",
            "the steps that keep to it are found while the scene runs, beside a second run",
            "leave it out, and write the stepper, precision and time step that `hooke run` found into the scene",
        ));
    }
    if chooses_steps(settings) {
        return Err(Refused::new(
            "time_step",
            "the stepper chooses its steps itself, and exported data has steps of one length",
            "say how long they are: --time-step 1e-3",
        ));
    }
    if settings.precision == Precision::F32Compensated {
        return Err(Refused::new(
            "precision",
            "f32-compensated is not exported: its positions are told in another type than its masses",
            "use --precision f32 or --precision f64",
        ));
    }
    Ok(())
}
