//! The stepper and the response that a scene names, as types of the core with the scene's capacity.

use crate::scene::{CollisionForm, Settings, StepperName};
use crate::simulate::{FILL, Start};

/// A type, and what makes one.
pub struct Role {
    pub kind: String,
    pub value: String,
}

impl Role {
    fn new(name: &str, parameters: &str, value: &str) -> Self {
        Self { kind: format!("hooke::{name}{parameters}"), value: value.to_owned() }
    }
}

/// The stepper; `real` is the name of its numbers.
pub fn stepper(settings: &Settings, start: &Start, real: &str) -> Role {
    let room = format!("<{real}, Capacity>");
    let factor = format!("<{real}, Capacity, {}>", fill(start));
    let solving = format!("Stepper::new({:?})", settings.tolerance);
    let explicit = |name: &str| Role::new(name, &room, "Stepper::new()");
    let implicit = |name: &str| Role::new(name, &factor, &solving);
    match settings.stepper {
        StepperName::ExplicitEuler => Role::new("ExplicitEuler", "", "hooke::ExplicitEuler"),
        StepperName::SemiImplicitEuler => Role::new("SemiImplicitEuler", "", "hooke::SemiImplicitEuler"),
        StepperName::ImplicitEuler => implicit("ImplicitEuler"),
        StepperName::ImplicitEulerLinearised => implicit("ImplicitEulerLinearised"),
        StepperName::ImplicitMidpoint => implicit("ImplicitMidpoint"),
        StepperName::TrBdf2 => implicit("TrBdf2"),
        StepperName::VelocityVerlet => explicit("VelocityVerlet"),
        StepperName::Rk4 => explicit("Rk4"),
        StepperName::BlanesMoanS6 => explicit("BlanesMoanS6"),
        StepperName::Dop853 => explicit("Dop853"),
        StepperName::DormandPrinceRkn8 => explicit("DormandPrinceRkn8"),
        StepperName::Auto => implicit("Auto"),
    }
}

/// The blocks a spring that leave room for the factor that the desktop's stepper makes, and none where it makes none.
fn fill(start: &Start) -> u64 {
    let springs = u64::from(start.plan.springs).max(1);
    let blocks = start.linear_solver.map_or(0, |solver| u64::from(solver.elimination.blocks));
    let needed = blocks.div_ceil(springs);
    if needed <= FILL as u64 { needed } else { 0 }
}

/// The response.
pub fn response(settings: &Settings, real: &str) -> Role {
    match settings.collision {
        CollisionForm::Reflect => Role::new("Reflect", "", "hooke::Reflect"),
        CollisionForm::Project => Role::new("Project", "", "hooke::Project"),
        CollisionForm::TimeOfImpact => Role::new("TimeOfImpact", &format!("<{real}, Capacity>"), "Response::new()"),
    }
}
