//! Semi-implicit (symplectic) Euler.

use super::euler;
use crate::Real;
use crate::roles::Stepper;
use crate::types::StepReport;
use crate::world::View;

/// v' = v + dt·a(x, v); x' = x + dt·v'. First order, and symplectic where nothing is damped.
///
/// Stable on an oscillator up to ω dt = 2(√(1+ζ²) − ζ).
#[derive(Clone, Copy, Debug, Default)]
pub struct SemiImplicitEuler;

impl<R: Real> Stepper<R> for SemiImplicitEuler {
    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        euler::advance::<R, false>(view, dt)
    }

    fn order(&self) -> u32 {
        1
    }

    fn curvature(&self) -> R {
        R::ONE
    }
}
