//! The time step of a scene that leaves it to the runner.

use hooke::{Plan, StabilityBound};

use crate::scene::{CollisionForm, Settings, StepperName, TimeStep};

/// The part of the largest stable time step that is taken: at the bound itself the stiffest motion is stable but
/// wrong, and springs that stretch and turn on the way may lower it.
const PART_OF_BOUND: f64 = 0.25;

/// No step that is chosen is longer than this, s: a slow scene is still to be drawn smoothly.
const LONGEST: f64 = 0.01;

/// The time step of a run, s; nothing where particles without springs fly exactly from frame to frame.
#[must_use]
pub fn choose_time_step(settings: &Settings, plan: &Plan, bound: Option<&StabilityBound>) -> Option<f64> {
    let flies = settings.stepper == StepperName::Auto && settings.collision == CollisionForm::TimeOfImpact;
    if flies && plan.attached == 0 {
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
fn two_digits_below(value: f64) -> f64 {
    let exponent = value.log10().floor() as i32 - 1;
    let digits = (value / 10_f64.powi(exponent)).floor().max(10.0);
    // Read back from text, so that it is the number that its digits name.
    format!("{digits}e{exponent}").parse().unwrap_or(value)
}
