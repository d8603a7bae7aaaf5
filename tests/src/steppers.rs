//! Which steppers a test goes through.

use hooke_runner::scene::StepperName;

/// Those that can step any scene.
pub fn all() -> impl Iterator<Item = StepperName> + Clone {
    StepperName::ALL.iter().copied().filter(|stepper| stepper.knows_damping())
}

/// Those of first and second order.
pub fn of_low_order() -> impl Iterator<Item = StepperName> + Clone {
    all().filter(|stepper| !matches!(stepper, StepperName::Rk4 | StepperName::BlanesMoanS6 | StepperName::Dop853))
}
