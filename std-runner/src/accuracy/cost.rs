//! What steps cost, as it is known before they are taken: so that a choice, and with it every bit of a run, is the same on any
//! machine, however busy.

use crate::model::Model;
use crate::scene::{Precision, StepperName};

/// Particles from which on numbers of twice the width take twice the time; with fewer most of it goes elsewhere.
const WIDE: usize = 200;

/// A step of one stepper in one precision, in steps of velocity Verlet in `f32`, which evaluates all forces once.
///
/// Rounded from `hooke bench` on a cloth of 32 x 32 and a rope of 41 particles; within a third where it matters.
#[must_use]
pub fn step_cost(stepper: StepperName, precision: Precision, model: &Model) -> f64 {
    let is_damped = model.damped_springs() > 0;
    let evaluations = match stepper {
        StepperName::ExplicitEuler | StepperName::SemiImplicitEuler => 0.9,
        StepperName::VelocityVerlet | StepperName::Auto => 1.0,
        StepperName::Rk4 => 3.8,
        // Each of its kicks goes through the dampers three times more.
        StepperName::BlanesMoanS6 if is_damped => 16.0,
        StepperName::BlanesMoanS6 => 6.5,
        StepperName::Dop853 => 12.5,
        StepperName::DormandPrinceRkn8 => 8.5,
        StepperName::ImplicitEulerLinearised => 15.0,
        StepperName::ImplicitEuler => 20.0,
        StepperName::ImplicitMidpoint => 25.0,
        StepperName::TrBdf2 => 40.0,
    };
    let width = match precision {
        Precision::F32 => 1.0,
        Precision::F32Compensated => 1.3,
        Precision::F64 if model.particles.len() < WIDE => 1.2,
        Precision::F64 => 1.9,
    };
    evaluations * width
}
