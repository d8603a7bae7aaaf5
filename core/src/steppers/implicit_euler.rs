//! Implicit (backward) Euler, solved.

use crate::Real;
use crate::roles::Stepper;
use crate::solve::{Tolerance, Workspace, newton};
use crate::types::{Full, StepReport};
use crate::world::{Plan, Storage, View};

/// v' = v + dt·a(x', v'); x' = x + dt·v', solved by Newton's method. First order, stable at any time step.
///
/// Each Newton iteration solves a positive definite linear system by preconditioned conjugate gradients and searches
/// along the line to its solution. A step is solved when the true residual m (v' − v) − dt·f(x', v'), weighted by
/// 1/m, is at most `tolerance` times the size of its terms, or as small as rounding lets it be; if that takes more
/// than 100 iterations the report says so and the last iterate is kept.
///
/// It damps every oscillation, by 1/(1 + 2ζh + h²) of its energy a step where h = ω dt.
pub struct ImplicitEuler<R: Real, M: Storage> {
    workspace: Workspace<R, M>,
    tolerance: Tolerance,
}

impl<R: Real, M: Storage> ImplicitEuler<R, M> {
    /// With the residual at which a step counts as solved, relative to the size of its terms; 1e-6, say.
    #[must_use]
    pub const fn new(tolerance: f64) -> Self {
        Self { workspace: Workspace::new(), tolerance: Tolerance(tolerance) }
    }
}

impl<R: Real, M: Storage> Stepper<R> for ImplicitEuler<R, M> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.workspace.fit(plan)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        newton(view, dt, self.tolerance, &mut self.workspace.lend())
    }

    fn curvature(&self) -> R {
        R::ONE
    }
}
