//! What errors are measured against: DOP853 in `f64`, with so many steps that more of them change nothing, confirmed by
//! another method.

use std::sync::atomic::AtomicBool;

use hooke::StabilityBound;

use super::bounces::Bounces;
use super::closed_form::ClosedForm;
use super::error::position_error;
use super::probe::{Probed, State, probe, watched};
use crate::model::{Hold, Model};
use crate::scene::{CollisionForm, Precision, Settings, StepperName};
use crate::simulate::{RunError, Start};

/// Evenly spaced times at which its state is known; the last is the end. A power of two, so that every smaller one divides
/// it.
pub const MOMENTS: u64 = 64;

/// Two references that differ by less than this, relative to the size of the scene, are one.
const SETTLED: f64 = 1e-12;
/// How often the steps are doubled to get there.
const MOST_DOUBLINGS: u32 = 8;
/// How far the start is moved to see how such a change grows, relative to the size of the scene.
const PERTURBATION: f64 = 1e-9;

/// A trajectory that is trusted, and how far.
#[derive(Clone, Debug)]
pub struct Reference {
    /// At each of its [`MOMENTS`]; none where there is no reference.
    pub states: Vec<State>,
    /// When particles bounced; nothing without planes.
    pub bounces: Option<Bounces>,
    /// The most kinetic energy at any of its moments, J.
    pub kinetic: f64,
    /// Its steps.
    pub steps: u64,
    /// How far it is from that of half as many steps, m.
    pub settled: f64,
    /// The method of another kind that confirms it, and how far from it that ends up, m; nothing if it does not end.
    pub confirmed: Option<(StepperName, f64)>,
    /// How far from the closed form it is, m; nothing where none is known.
    pub closed_form: Option<f64>,
    /// By how much a small change of the start has grown at most.
    pub growth: f64,
    /// The largest distance of a particle from the middle of the scene, m.
    pub size: f64,
    /// The stability bounds at the start; nothing where no spring pulls at a free particle.
    pub bound: Option<StabilityBound>,
}

impl Reference {
    /// Of a scene as its settings say, but for stepper, precision, time step and collision form; nothing if it was
    /// interrupted. Its cost is that of some ten runs of DOP853 that are as exact as `f64` allows.
    ///
    /// # Errors
    /// If the scene cannot be run at all.
    pub fn of(model: &Model, settings: &Settings, interrupted: &AtomicBool) -> Result<Option<Self>, RunError> {
        let settings = Settings {
            stepper: StepperName::Dop853,
            precision: Precision::F64,
            collision: CollisionForm::TimeOfImpact,
            ..settings.clone()
        };
        let bound = Start::of::<f64>(model, &settings)?.bound;
        let size = model.size();
        let runs = Runs { settings: &settings, interrupted };
        let longest = bound.map_or(f64::INFINITY, |bound| bound.dop853());
        let first = steps_of(settings.duration, longest, MOMENTS);
        let Some(settled) = runs.settle(model, first, size)? else { return Ok(None) };
        let Settled { states, steps, change: settled } = settled;
        let mut reference = Self { settled, steps, ..Self::unknown(bound, size) };
        if states.is_empty() {
            return Ok(Some(reference));
        }
        let (stepper, times) = confirming(model);
        let other = Settings { stepper, ..settings.clone() };
        let Some(other) = (Runs { settings: &other, interrupted }).states(model, times * steps)? else {
            return Ok(None);
        };
        reference.confirmed = other.map(|other| (stepper, position_error(&states, &other)));
        let Some(moved) = runs.states(&moved(model, PERTURBATION * size), steps)? else { return Ok(None) };
        reference.growth = moved.map_or(f64::INFINITY, |moved| position_error(&states, &moved) / (PERTURBATION * size));
        match watched(model, &settings, steps, MOMENTS, interrupted)? {
            Probed::Finished((_, seen)) => (reference.bounces, reference.kinetic) = (seen.bounces, seen.kinetic),
            Probed::Diverged { .. } => {}
            Probed::Interrupted => return Ok(None),
        }
        let closed_form = ClosedForm::of(model, &settings);
        reference.closed_form = closed_form.map(|known| position_error(&states, &known.states(MOMENTS)));
        reference.states = states;
        Ok(Some(reference))
    }

    /// Its states at so many evenly spaced checkpoints, a divisor of [`MOMENTS`].
    #[must_use]
    pub fn at(&self, checkpoints: u64) -> Vec<&State> {
        let every = (MOMENTS / checkpoints.clamp(1, MOMENTS)) as usize;
        self.states.iter().skip(every - 1).step_by(every).collect()
    }

    /// Where no reference could be made: nothing can be claimed.
    fn unknown(bound: Option<StabilityBound>, size: f64) -> Self {
        Self {
            states: Vec::new(),
            bounces: None,
            kinetic: 0.0,
            steps: 0,
            settled: f64::INFINITY,
            confirmed: None,
            closed_form: None,
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

/// Runs that a reference is made of.
struct Runs<'a> {
    settings: &'a Settings,
    interrupted: &'a AtomicBool,
}

/// What more steps do not change.
struct Settled {
    /// None if all runs diverged.
    states: Vec<State>,
    steps: u64,
    /// From half as many steps, m.
    change: f64,
}

impl Runs<'_> {
    /// Nothing if it was interrupted, nothing in it if it diverged.
    fn states(&self, model: &Model, steps: u64) -> Result<Option<Option<Vec<State>>>, RunError> {
        Ok(match probe(model, self.settings, steps, MOMENTS, self.interrupted)? {
            Probed::Finished(probe) => Some(Some(probe.states)),
            Probed::Diverged { .. } => Some(None),
            Probed::Interrupted => None,
        })
    }

    /// Doubles the steps until that changes nothing, or makes it worse; nothing if it was interrupted.
    fn settle(&self, model: &Model, first: u64, size: f64) -> Result<Option<Settled>, RunError> {
        let mut settled = Settled { states: Vec::new(), steps: 0, change: f64::INFINITY };
        for doubling in 0..=MOST_DOUBLINGS {
            let steps = first << doubling;
            let Some(states) = self.states(model, steps)? else { return Ok(None) };
            let Some(states) = states else { continue };
            let change = match settled.states.as_slice() {
                [] => f64::INFINITY,
                before => position_error(before, &states),
            };
            if settled.change.is_finite() && change > 0.5 * settled.change && change > SETTLED * size {
                // Past where rounding takes over more steps make it worse.
                settled.change = settled.change.max(change);
                break;
            }
            settled = Settled { states, steps, change };
            if change <= SETTLED * size {
                break;
            }
        }
        Ok(Some(settled))
    }
}

/// What confirms a reference, and how many times its steps that takes: another method of eighth order where there is one,
/// or one of fourth.
fn confirming(model: &Model) -> (StepperName, u64) {
    if model.damped_springs() == 0 { (StepperName::DormandPrinceRkn8, 2) } else { (StepperName::Rk4, 16) }
}

/// The smallest multiple of `checkpoints` that makes no longer steps than these.
pub fn steps_of(duration: f64, time_step: f64, checkpoints: u64) -> u64 {
    let between = duration / checkpoints as f64;
    checkpoints * ((between / time_step).ceil().max(1.0) as u64)
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
