//! What is known of the motion of a scene: a reference where one can be had, else what the laws of motion keep.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use super::case::{CHECKPOINTS, Case, Known};
use super::distance::{farthest, size};
use crate::bench::{Reference, Vectors};
use crate::model::{CameraChoice, Model};
use crate::scene::{CollisionForm, Precision, Settings, StepperName, TimeStep};
use crate::simulate::{RunError, world};

/// Force evaluations times particles and springs that a reference may cost, as far as can be foreseen.
const MOST_WORK: f64 = 4e7;
/// Evaluations of the steps that a reference takes in all, for each of the longest that it can take.
const EVALUATIONS: f64 = 1500.0;
/// A reference that takes longer is none.
const LONGEST: Duration = Duration::from_secs(5);
/// Between two looks at the clock.
const LOOK: Duration = Duration::from_millis(5);
/// A reference that is less certain than this part of the motion is none.
const CERTAIN: f64 = 1e-4;
/// So many roundings are nothing.
const ROUNDINGS: f64 = 100.0;

/// What is known of a model that moves for so long; nothing if it was interrupted.
///
/// # Errors
/// If it cannot be run in `f64`.
pub fn known(
    model: &Model,
    gravity: [f64; 3],
    duration: f64,
    interrupted: &AtomicBool,
) -> Result<Option<Known>, RunError> {
    let conserved = if is_conservative(model) { Known::Energy } else { Known::NoMoreEnergy };
    if work(model, duration)? > MOST_WORK {
        return Ok(Some(conserved));
    }
    let settings = settings(gravity, duration);
    let reference = within(LONGEST, interrupted, |ended| Reference::of(model, &settings, ended))?;
    let Some(reference) = reference else {
        return Ok((!interrupted.load(Ordering::Relaxed)).then_some(conserved));
    };
    let positions: Vec<Vectors> = reference.at(CHECKPOINTS).iter().map(|state| state.positions.clone()).collect();
    let start: Vectors = model.particles.iter().map(|particle| particle.position).collect();
    let motion = positions.iter().map(|positions| farthest(positions, &start)).fold(0.0, f64::max);
    let uncertainty = reference.floor();
    // Where a change of the start grows too much, or nothing settles, no place can be told.
    let is_certain = !positions.is_empty() && uncertainty <= CERTAIN * motion + ROUNDINGS * f64::EPSILON * size(model);
    Ok(Some(if is_certain { Known::Motion { positions, uncertainty } } else { conserved }))
}

/// Does something that ends early when its flag is set, which happens after so long, or when somebody interrupts.
fn within<T>(longest: Duration, interrupted: &AtomicBool, work: impl FnOnce(&AtomicBool) -> T) -> T {
    let (ended, done) = (AtomicBool::new(false), AtomicBool::new(false));
    let begun = Instant::now();
    thread::scope(|scope| {
        scope.spawn(|| {
            while !done.load(Ordering::Relaxed) {
                let is_over = begun.elapsed() > longest || interrupted.load(Ordering::Relaxed);
                ended.fetch_or(is_over, Ordering::Relaxed);
                thread::sleep(LOOK);
            }
        });
        let result = work(&ended);
        done.store(true, Ordering::Relaxed);
        result
    })
}

/// The same motion somewhere else, or larger.
pub fn elsewhere(known: &Known, scale: f64, shift: [f64; 3]) -> Option<Known> {
    let Known::Motion { positions, uncertainty } = known else { return None };
    let moved = |position: &[f64; 3]| [0, 1, 2].map(|axis| scale * position[axis] + shift[axis]);
    let positions = positions.iter().map(|positions| positions.iter().map(moved).collect()).collect();
    Some(Known::Motion { positions, uncertainty: scale * uncertainty })
}

/// A case's model as it is kept: nothing damped, nothing lost in bounces.
fn is_conservative(model: &Model) -> bool {
    model.damped_springs() == 0 && model.planes.iter().all(|plane| plane.restitution == 1.0)
}

fn work(model: &Model, duration: f64) -> Result<f64, RunError> {
    let bound = world::<f64>(model, [0.0; 3])?.view().stability();
    let steps = bound.map_or(1.0, |bound| (duration / bound.dop853()).max(1.0));
    Ok(steps * EVALUATIONS * (model.particles.len() + model.springs.len()) as f64)
}

fn settings(gravity: [f64; 3], duration: f64) -> Settings {
    Settings {
        name: String::new(),
        gravity,
        duration,
        time_step: TimeStep::Auto,
        frame_rate: 1.0,
        stepper: StepperName::Dop853,
        precision: Precision::F64,
        tolerance: 1e-9,
        collision: CollisionForm::TimeOfImpact,
        sleep_speed: None,
        max_error: None,
        camera: CameraChoice::default(),
    }
}

impl Case {
    /// With what is known of it; nothing if it was interrupted.
    ///
    /// # Errors
    /// If it cannot be run in `f64`.
    pub fn with_known(self, interrupted: &AtomicBool) -> Result<Option<Self>, RunError> {
        let known = known(&self.model, self.gravity, self.duration, interrupted)?;
        Ok(known.map(|known| Self { known, ..self }))
    }
}
