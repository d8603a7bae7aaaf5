//! Short runs over the beginning of a scene, to see what its steppers are worth there.

use std::sync::atomic::AtomicBool;

use hooke::StabilityBound;

use super::attempt::MARGIN;
use super::cost::step_cost;
use crate::bench::{Probe, Probed, State, probe};
use crate::model::Model;
use crate::scene::{CollisionForm, Precision, Settings, StepperName};
use crate::simulate::{AnyStepper, RunError, largest_stable_step};

/// The part of the duration that pilots run.
const PREFIX: f64 = 1.0 / 48.0;
/// They run so many steps of the method of highest order at least, and at most.
const STEPS: (f64, f64) = (4.0, 20_000.0);
/// Times at which pilots are compared.
const CHECKPOINTS: u64 = 4;
/// Where nothing limits steps they are this part of the duration.
pub(super) const UNLIMITED: f64 = 1.0 / 16.0;
/// What `f32` loses of the size of a scene that bounces around for a while.
pub(super) const FLIGHT_ROUNDING: f64 = 1e-5;

/// The method of highest order that can step a scene.
pub(super) fn highest(model: &Model) -> StepperName {
    if model.damped_springs() == 0 { StepperName::DormandPrinceRkn8 } else { StepperName::Dop853 }
}

/// Runs over a prefix.
pub(super) struct Pilots<'a> {
    pub(super) model: &'a Model,
    /// Of the prefix.
    pub(super) settings: Settings,
    /// Of the whole run, s.
    pub(super) duration: f64,
    /// What they have cost so far.
    pub(super) cost: f64,
    bound: Option<StabilityBound>,
    interrupted: &'a AtomicBool,
}

/// What became of one.
pub(super) enum Flown {
    /// Its states at the checkpoints, and its steps, s.
    Finished(Vec<State>, f64),
    /// It left the finite numbers, or its precision cannot hold the scene.
    Diverged,
    /// It was ended from outside.
    Interrupted,
}

impl<'a> Pilots<'a> {
    pub(super) fn new(
        model: &'a Model,
        settings: Settings,
        bound: Option<StabilityBound>,
        interrupted: &'a AtomicBool,
    ) -> Self {
        let duration = settings.duration;
        let step = bound.map_or(duration, |bound| MARGIN * largest_stable_step(highest(model), &bound));
        let prefix = (PREFIX * duration).clamp(STEPS.0 * step, (STEPS.1 * step).max(STEPS.0 * step)).min(duration);
        let settings = Settings { duration: prefix, ..settings };
        Self { model, settings, duration, cost: 0.0, bound, interrupted }
    }

    /// How many times longer the whole run is.
    pub(super) fn longer(&self) -> f64 {
        self.duration / self.settings.duration
    }

    /// The largest step at which a stepper is stable, s; a part of the duration where nothing limits it.
    pub(super) fn limit(&self, stepper: StepperName) -> f64 {
        let limit = self.bound.map_or(f64::INFINITY, |bound| match stepper {
            // Where it has none, growth is slow at least.
            StepperName::ExplicitEuler if bound.explicit_euler <= 0.0 => 0.01 / bound.frequency,
            stepper => MARGIN * largest_stable_step(stepper, &bound),
        });
        if limit.is_finite() { limit } else { UNLIMITED * self.duration }
    }

    /// The order of a stepper, as far as collisions let it be.
    pub(super) fn order(&self, stepper: StepperName) -> u32 {
        // Other forms answer hits at the end of steps, wherever they were.
        if !self.model.planes.is_empty() && self.settings.collision != CollisionForm::TimeOfImpact {
            return 1;
        }
        AnyStepper::<f64>::named(stepper, self.settings.tolerance).any().order()
    }

    /// One of them, in steps of at most `time_step` seconds.
    pub(super) fn fly(
        &mut self,
        stepper: StepperName,
        precision: Precision,
        time_step: f64,
    ) -> Result<Flown, RunError> {
        let settings = Settings { stepper, precision, ..self.settings.clone() };
        let each = (settings.duration / CHECKPOINTS as f64 / time_step).ceil().max(1.0);
        let steps = CHECKPOINTS * each as u64;
        self.cost += steps as f64 * step_cost(stepper, precision, self.model);
        Ok(match probe(self.model, &settings, steps, CHECKPOINTS, self.interrupted) {
            Ok(Probed::Finished(Probe { states, .. })) => Flown::Finished(states, settings.duration / steps as f64),
            Ok(Probed::Diverged { .. }) => Flown::Diverged,
            Ok(Probed::Interrupted) => Flown::Interrupted,
            Err(RunError::Build(_)) if precision != Precision::F64 => Flown::Diverged,
            Err(error) => return Err(error),
        })
    }
}
