//! What a scene that leaves both its stepper and its time step open is stepped with.

use std::sync::atomic::AtomicBool;

use super::cost::step_cost;
use super::pilot::{Pilots, highest};
use super::shown::{Seen, Shown, show};
use crate::model::Model;
use crate::scene::{Precision, Settings, StepperName, TimeStep};
use crate::simulate::{LONGEST, PART_OF_BOUND, RunError, Start, two_digits_below};

/// What is aimed at, as a part of the size of the scene.
const GOAL: f64 = 1e-3;
/// The part of it that steps are to use up: nothing follows how errors really grow.
const USED: f64 = 0.5;
/// Of what is to be reached, what a stepper of eighth order that chooses its steps may be off in each.
const TOLERANCE: f64 = 1e-3;

/// What was found for a scene that leaves its stepper and its time step open.
#[derive(Clone, Debug, PartialEq)]
pub struct Aimed {
    /// The scene's settings with what was found in their place.
    pub settings: Settings,
    /// The error that is aimed at: no run beside this one tells whether it is met, m.
    pub error: f64,
    /// How long pilot runs were, s of simulated time; 0 where the run is too short for them.
    pub prefix: f64,
    /// What rounding alone may come to by the end, m; 0 where the precision is not `f32`.
    pub rounding: f64,
}

/// How an aim came out.
#[derive(Clone, Debug, PartialEq)]
pub enum Aim {
    /// Nothing is open: a stepper or a time step is given, or nothing but flight, which is exact.
    Given,
    /// It was found.
    Found(Box<Aimed>),
    /// Pilot runs left the finite numbers; the stability bound alone is left to go by.
    Lost,
    /// It was ended from outside.
    Interrupted,
}

/// Whether settings leave the stepper and the time step open, with no accuracy asked for.
#[must_use]
pub fn leaves_open(settings: &Settings) -> bool {
    let is_auto = settings.stepper == StepperName::Auto && settings.time_step == TimeStep::Auto;
    is_auto && settings.max_error.is_none()
}

/// The error that is aimed at in a scene, m.
#[must_use]
pub fn aimed_at(model: &Model) -> f64 {
    GOAL * model.size()
}

/// Finds the cheapest stepper and time step that can be expected to keep within a thousandth of the size of a scene, where
/// settings leave both open. Only velocity Verlet, in the hands of `auto`, and the methods of eighth order, which choose their
/// own steps, are looked at.
///
/// # Errors
/// If the scene cannot be run at all.
pub fn aim(model: &Model, settings: &Settings, interrupted: &AtomicBool) -> Result<Aim, RunError> {
    if !leaves_open(settings) {
        return Ok(Aim::Given);
    }
    let start = Start::of::<f64>(model, &Settings { precision: Precision::F64, ..settings.clone() })?;
    if start.plan.attached == 0 {
        return Ok(Aim::Given);
    }
    let mut pilots = Pilots::new(model, settings.clone(), start.bound, interrupted);
    let best = highest(model);
    let steppers = [StepperName::VelocityVerlet, best];
    // Only `auto` flies exactly what no spring pulls at.
    let only = if start.plan.free() > 0 { &steppers[..1] } else { &steppers[..] };
    let shown = match show(&mut pilots, only, model.size())? {
        Seen::Steppers(shown) => shown,
        Seen::Diverged => return Ok(Aim::Lost),
        Seen::Interrupted => return Ok(Aim::Interrupted),
    };
    let allowed = USED * aimed_at(model);
    let found = shown
        .iter()
        .map(|shown| expected(shown, allowed, &pilots))
        .min_by(|one, other| one.cost.total_cmp(&other.cost));
    let Some(Expected { stepper, time_step, .. }) = found else { return Ok(Aim::Lost) };
    let rounding = shown.first().filter(|_| settings.precision == Precision::F32).map_or(0.0, |shown| shown.rounding);
    let settings = if stepper == best {
        Settings { stepper, tolerance: settings.tolerance.min(TOLERANCE * GOAL), ..settings.clone() }
    } else {
        let time_step = two_digits_below(time_step.min(LONGEST).min(settings.duration));
        Settings { time_step: TimeStep::Seconds(time_step), ..settings.clone() }
    };
    let prefix = pilots.settings.duration;
    Ok(Aim::Found(Box::new(Aimed { settings, error: aimed_at(model), prefix, rounding })))
}

/// What a stepper is expected to take.
struct Expected {
    stepper: StepperName,
    /// s
    time_step: f64,
    cost: f64,
}

fn expected(shown: &Shown, allowed: f64, pilots: &Pilots<'_>) -> Expected {
    let stepper = shown.stepper;
    // Pilots over a prefix end before most of what falls on a plane has hit it.
    let longest = if pilots.model.planes.is_empty() { 1.0 } else { PART_OF_BOUND } * pilots.limit(stepper);
    let [time_step, likely] = shown.steps_for(allowed, pilots.order(stepper)).map(|step| step.min(longest));
    let cost = pilots.duration / likely * step_cost(stepper, pilots.settings.precision, pilots.model);
    Expected { stepper, time_step, cost }
}
