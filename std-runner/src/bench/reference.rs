//! What errors are measured against: DOP853 in `f64`, with so many steps that more of them change nothing, confirmed by
//! another method.

use std::sync::atomic::AtomicBool;

use hooke::StabilityBound;

use super::probe::{CHECKPOINTS, Positions, Probed, distance, probe};
use crate::model::{Hold, Model};
use crate::scene::{CollisionForm, Precision, Settings, StepperName};
use crate::simulate::{RunError, Start};

/// Two references that differ by less than this, relative to the size of the scene, are one.
const SETTLED: f64 = 1e-12;
/// How often the steps are doubled to get there.
const MOST_DOUBLINGS: u32 = 8;
/// How far the start is moved to see how such a change grows, relative to the size of the scene.
const PERTURBATION: f64 = 1e-9;

/// A trajectory that is trusted, and how far.
#[derive(Clone, Debug)]
pub struct Reference {
    /// At each checkpoint.
    pub positions: Vec<Positions>,
    /// Its steps.
    pub steps: u64,
    /// How far it is from that of half as many steps, m.
    pub settled: f64,
    /// The method of another kind that confirms it, and how far from it that ends up, m; nothing if it does not end.
    pub confirmed: Option<(StepperName, f64)>,
    /// By how much a small change of the start has grown by the end.
    pub growth: f64,
    /// The largest distance of a particle from the middle of the scene, m.
    pub size: f64,
    /// The stability bounds at the start; nothing where no spring pulls at a free particle.
    pub bound: Option<StabilityBound>,
}

impl Reference {
    /// Of a scene; nothing if it was interrupted.
    pub(super) fn of(model: &Model, settings: &Settings, interrupted: &AtomicBool) -> Result<Option<Self>, RunError> {
        let settings = Settings {
            stepper: StepperName::Dop853,
            precision: Precision::F64,
            collision: CollisionForm::TimeOfImpact,
            ..settings.clone()
        };
        let bound = Start::of::<f64>(model, &settings)?.bound;
        let size = size(model);
        let mut steps = steps_of(settings.duration, bound.map_or(f64::INFINITY, |bound| bound.dop853()));
        let mut before: Option<Vec<Positions>> = None;
        let mut settled = f64::INFINITY;
        for _ in 0..=MOST_DOUBLINGS {
            let positions = match probe(model, &settings, steps, interrupted)? {
                Probed::Finished(probe) => Some(probe.positions),
                Probed::Diverged(_) => None,
                Probed::Interrupted => return Ok(None),
            };
            if let (Some(before), Some(now)) = (&before, &positions) {
                let change = distance(before, now);
                // Past where rounding takes over more steps make it worse.
                let ends = change <= SETTLED * size || change > 0.5 * settled;
                settled = change;
                if ends {
                    break;
                }
            }
            before = positions.or(before);
            steps *= 2;
        }
        let Some(positions) = before else { return Ok(Some(Self::unknown(bound, size))) };
        steps /= 2;
        let (stepper, times) = confirming(model);
        let other = Settings { stepper, ..settings.clone() };
        let confirmed = match probe(model, &other, times * steps, interrupted)? {
            Probed::Finished(probe) => Some((stepper, distance(&positions, &probe.positions))),
            Probed::Diverged(_) => None,
            Probed::Interrupted => return Ok(None),
        };
        let growth = match probe(&moved(model, PERTURBATION * size), &settings, steps, interrupted)? {
            Probed::Finished(probe) => distance(&positions, &probe.positions) / (PERTURBATION * size),
            Probed::Diverged(_) => f64::INFINITY,
            Probed::Interrupted => return Ok(None),
        };
        Ok(Some(Self { positions, steps, settled, confirmed, growth, size, bound }))
    }

    /// Where no reference could be made: nothing can be claimed.
    fn unknown(bound: Option<StabilityBound>, size: f64) -> Self {
        Self {
            positions: Vec::new(),
            steps: 0,
            settled: f64::INFINITY,
            confirmed: None,
            growth: f64::INFINITY,
            size,
            bound,
        }
    }

    /// Errors below this are not known, m: of the reference itself, and of what a rounding of the start grows to.
    #[must_use]
    pub fn floor(&self) -> f64 {
        (3.0 * self.settled).max(self.growth * f64::EPSILON * self.size)
    }
}

/// What confirms a reference, and how many times its steps that takes: another method of eighth order where there is one,
/// or one of fourth.
fn confirming(model: &Model) -> (StepperName, u64) {
    if model.damped_springs() == 0 { (StepperName::DormandPrinceRkn8, 2) } else { (StepperName::Rk4, 16) }
}

/// A multiple of the checkpoints, of no longer steps than these.
pub fn steps_of(duration: f64, time_step: f64) -> u64 {
    let between = duration / CHECKPOINTS as f64;
    CHECKPOINTS * ((between / time_step).ceil().max(1.0) as u64)
}

/// The largest distance of a particle from the middle of all, m; 1 where all are at one place.
fn size(model: &Model) -> f64 {
    let count = model.particles.len().max(1) as f64;
    let middle = model
        .particles
        .iter()
        .fold([0.0; 3], |sum, particle| [0, 1, 2].map(|axis| sum[axis] + particle.position[axis] / count));
    let far = model.particles.iter().fold(0.0_f64, |far, particle| {
        let square: f64 = particle.position.iter().zip(middle).map(|(x, m)| (x - m) * (x - m)).sum();
        far.max(square.sqrt())
    });
    if far > 0.0 { far } else { 1.0 }
}

/// With every particle that is free moved a little, to and fro.
fn moved(model: &Model, by: f64) -> Model {
    let mut model = model.clone();
    for (number, particle) in model.particles.iter_mut().enumerate() {
        if particle.hold == Hold::Free {
            let sign = if number % 2 == 0 { 1.0 } else { -1.0 };
            particle.position = particle.position.map(|x| x + sign * by / 3.0_f64.sqrt());
        }
    }
    model
}
