//! Explicit Euler.

use crate::Real;
use crate::roles::Stepper;
use crate::types::StepReport;
use crate::vectors::{advance_columns, lend, read, velocities_from_accelerations};
use crate::world::View;

/// v' = v + dt·a(x, v); x' = x + dt·v. First order.
///
/// It adds energy to every undamped oscillation: (ω dt)² of it a step.
#[derive(Clone, Copy, Debug, Default)]
pub struct ExplicitEuler;

impl<R: Real> Stepper<R> for ExplicitEuler {
    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        let mut report = StepReport::default();
        let View { system, current, next, force_density, .. } = view;
        let (x, v) = (read(&current.position), read(&current.velocity));

        system.accelerations(x, v, force_density, lend(&mut next.velocity), &mut report);
        velocities_from_accelerations(lend(&mut next.velocity), v, dt);
        advance_columns(lend(&mut next.position), x, dt, v);
        report
    }

    fn curvature(&self) -> R {
        R::ZERO
    }
}
