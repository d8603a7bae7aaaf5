//! The time step of a scene that leaves it to the runner.

use hooke::{Plan, StabilityBound};

use crate::scene::{CollisionForm, Settings, StepperName, TimeStep};

/// The part of the largest stable time step that is taken: at the bound itself the stiffest motion is stable but
/// wrong, and springs that stretch and turn on the way may lower it.
pub(crate) const PART_OF_BOUND: f64 = 0.25;

/// How often a run is looked at at least where its stepper chooses its steps: to tell how far it is, and to end it.
const LOOKS: f64 = 32.0;

/// No step that is chosen is longer than this, s: a slow scene is still to be drawn smoothly.
pub(crate) const LONGEST: f64 = 0.01;

/// Whether a run's stepper chooses the lengths of its steps itself, by its error estimate and the tolerance.
#[must_use]
pub fn chooses_steps(settings: &Settings) -> bool {
    settings.time_step == TimeStep::Auto && settings.stepper.estimates_errors()
}

/// Whether frames within steps come from the stepper's dense output, so that no step has to end at one. What no spring pulls
/// at flies on a path of its own, what sleeps is not stepped, and two forms of collision look for hits at ends of steps.
pub(super) fn tells_between(settings: &Settings, plan: &Plan) -> bool {
    let hits_at_ends = plan.planes > 0 && settings.collision != CollisionForm::TimeOfImpact;
    let is_dense = chooses_steps(settings) && settings.stepper == StepperName::Dop853;
    is_dense && plan.attached > 0 && plan.free() == 0 && settings.sleep_speed.is_none() && !hits_at_ends
}

/// What a run is stepped by between looks at it, s: its time step; where frames need not end steps, a part of it that leaves
/// most of them whole; nothing where it is from frame to frame.
pub(super) fn looked_at_every(settings: &Settings, plan: &Plan, time_step: Option<f64>) -> Option<f64> {
    time_step.or_else(|| tells_between(settings, plan).then_some(settings.duration / LOOKS))
}

/// The time step of a run, s; nothing where particles without springs fly exactly from frame to frame, and where the
/// stepper chooses its steps itself.
#[must_use]
pub fn choose_time_step(settings: &Settings, plan: &Plan, bound: Option<&StabilityBound>) -> Option<f64> {
    let flies = settings.stepper == StepperName::Auto && settings.collision == CollisionForm::TimeOfImpact;
    if flies && plan.attached == 0 || chooses_steps(settings) {
        return None;
    }
    Some(match settings.time_step {
        TimeStep::Seconds(seconds) => seconds,
        TimeStep::Auto => {
            let longest = LONGEST.min(settings.duration);
            let limit = bound.map_or(f64::INFINITY, |bound| match settings.stepper {
                // It is to step as Verlet while it can.
                StepperName::Auto => bound.velocity_verlet,
                // It has no stable one where anything is undamped: then it is at least to grow slowly.
                StepperName::ExplicitEuler if bound.explicit_euler <= 0.0 => 0.01 / bound.frequency,
                stepper => largest_stable_step(stepper, bound),
            });
            let part = PART_OF_BOUND * limit;
            if part < longest { two_digits_below(part) } else { longest }
        }
    })
}

/// The largest time step at which a stepper is sure to be stable, s: infinite for the implicit ones and `auto`, which
/// turns to one of them. For explicit Euler it is only an upper limit.
#[must_use]
pub fn largest_stable_step(stepper: StepperName, bound: &StabilityBound) -> f64 {
    match stepper {
        StepperName::ExplicitEuler => bound.explicit_euler,
        StepperName::SemiImplicitEuler => bound.semi_implicit_euler,
        StepperName::VelocityVerlet => bound.velocity_verlet,
        StepperName::Rk4 => bound.rk4(),
        StepperName::BlanesMoanS6 => bound.blanes_moan_s6(),
        StepperName::Dop853 => bound.dop853(),
        StepperName::DormandPrinceRkn8 => bound.dormand_prince_rkn8(),
        StepperName::ImplicitEuler
        | StepperName::ImplicitEulerLinearised
        | StepperName::ImplicitMidpoint
        | StepperName::TrBdf2
        | StepperName::Auto => f64::INFINITY,
    }
}

/// The largest number of two digits that is not larger: easier to read, and to write into a scene.
pub(crate) fn two_digits_below(value: f64) -> f64 {
    let exponent = value.log10().floor() as i32 - 1;
    let digits = (value / 10_f64.powi(exponent)).floor().max(10.0);
    // Read back from text, so that it is the number that its digits name.
    format!("{digits}e{exponent}").parse().unwrap_or(value)
}
