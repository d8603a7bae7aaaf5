//! Numerical stability: the largest time step at which each stepper is stable on a scene, beside theory; what happens past
//! it; and a battery of scenes that are hard on steppers.

pub mod battery;
mod frequency;
mod frozen;
mod growth;
mod lanczos;
mod limit;
mod map;
mod noise;
mod theory;
mod whole;

use std::sync::atomic::AtomicBool;

use hooke::StabilityBound;

use crate::model::Model;
use crate::scene::StepperName;
use crate::simulate::{BuildError, world};

pub use frequency::Frequency;
pub use frozen::Frozen;
pub use growth::{Growth, Trend, growth};
pub use limit::{Found, Limit};
pub use map::{Fate, Map, Panel};
pub use theory::oscillator_limit;
pub use whole::{Ask, News, Stressed, stress_bodies, stress_scene};

/// What a trial step may cost: a fraction of a second.
pub const WORK: f64 = 3e6;

/// The largest stable time step of every stepper on a scene.
#[derive(Clone, Debug)]
pub struct Limits {
    /// The bounds from the blocks at the start; nothing where no spring pulls at a free particle.
    pub blocks: StabilityBound,
    /// What was measured.
    pub frequency: Frequency,
    /// Springs shorter than their rest length at the start, whose buckling is left out.
    pub compressed: usize,
    /// Of each stepper that can step the scene.
    pub steppers: Vec<Limit>,
    /// Whether it was ended before all had run.
    pub interrupted: bool,
}

/// Finds the limit of every stepper, or of `only` those, and tells of each when it is found; each
/// trial may cost `work` force evaluations times particles and springs, about [`WORK`]. Nothing where no spring pulls at a free particle:
/// then nothing limits time steps.
///
/// # Errors
/// If the scene cannot be stepped in `f64`.
pub fn limits(
    model: &Model,
    only: &[StepperName],
    work: f64,
    interrupted: &AtomicBool,
    mut tell: impl FnMut(&Limit),
) -> Result<Option<Limits>, BuildError> {
    let Some(blocks) = world::<f64>(model, [0.0; 3])?.view().stability() else { return Ok(None) };
    let frozen = Frozen::of(model);
    let Some(frequency) = Frequency::of(&frozen)? else { return Ok(None) };
    let mut limits =
        Limits { blocks, frequency, compressed: frozen.compressed, steppers: Vec::new(), interrupted: false };
    for stepper in steppers(model, only) {
        let Some(limit) = limit::limit(&frozen, stepper, &frequency, &blocks, work, interrupted)? else {
            limits.interrupted = true;
            break;
        };
        tell(&limit);
        limits.steppers.push(limit);
    }
    Ok(Some(limits))
}

/// All that can step a scene, or those of them that are asked for.
fn steppers(model: &Model, only: &[StepperName]) -> impl Iterator<Item = StepperName> {
    let is_damped = model.damped_springs() > 0;
    let is_asked = |stepper: &StepperName| only.is_empty() || only.contains(stepper);
    StepperName::ALL.iter().copied().filter(is_asked).filter(move |stepper| !is_damped || stepper.knows_damping())
}
