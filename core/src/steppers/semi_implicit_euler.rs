//! Semi-implicit (symplectic) Euler.

use crate::Real;
use crate::roles::Stepper;
use crate::types::StepReport;
use crate::vectors::{advance_columns, lend, read, velocities_from_accelerations};
use crate::world::View;

/// v' = v + dt·a(x, v); x' = x + dt·v'. First order, and symplectic where nothing is damped.
///
/// Stable on an oscillator up to ω dt = 2(√(1+ζ²) − ζ).
#[derive(Clone, Copy, Debug, Default)]
pub struct SemiImplicitEuler;

impl<R: Real> Stepper<R> for SemiImplicitEuler {
    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        let mut report = StepReport::default();
        let View { system, current, next, force_density, .. } = view;
        let (x, v) = (read(&current.position), read(&current.velocity));
        system.accelerations(x, v, force_density, lend(&mut next.velocity), &mut report);
        velocities_from_accelerations(lend(&mut next.velocity), v, dt);
        advance_columns(lend(&mut next.position), x, dt, read(&next.velocity));
        report
    }

    fn curvature(&self) -> R {
        R::ONE
    }
}
