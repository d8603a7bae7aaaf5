//! Explicit Euler.

use super::euler;
use crate::Real;
use crate::roles::Stepper;
use crate::types::StepReport;
use crate::world::View;

/// v' = v + dt·a(x, v); x' = x + dt·v. First order.
///
/// It adds energy to every undamped oscillation: (ω dt)² of it a step.
#[derive(Clone, Copy, Debug, Default)]
pub struct ExplicitEuler;

impl<R: Real> Stepper<R> for ExplicitEuler {
    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        euler::advance::<R, true>(view, dt)
    }

    fn order(&self) -> u32 {
        1
    }

    fn curvature(&self) -> R {
        R::ZERO
    }
}
