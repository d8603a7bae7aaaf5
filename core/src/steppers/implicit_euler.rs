//! Implicit (backward) Euler, solved.

use crate::Real;
use crate::roles::Stepper;
use crate::solve::{LinearSolver, Tolerance, Workspace, newton};
use crate::types::{Full, StepReport};
use crate::world::{Plan, Storage, View};

/// v' = v + dt·a(x', v'); x' = x + dt·v', solved by Newton's method. First order, stable at any time step.
///
/// Each Newton iteration solves a positive definite linear system and searches along the line to its solution: by
/// a factorisation where that is cheaper (ropes, chains and trees at almost any step; small cloths where they are stiff),
/// by preconditioned conjugate gradients elsewhere. [`ImplicitEuler::linear_solver`] tells which, and a report how often.
/// A factor has room for `FILL` blocks a spring, whatever the capacity: 1 is enough for ropes, chains and trees, 16 for
/// cloths of 64 x 64, and with 0 there is none.
///
/// A step is solved when the true residual m (v' − v) − dt·f(x', v'), weighted by
/// 1/m, is at most `tolerance` times the size of its terms, or as small as rounding lets it be; if that takes more
/// than 100 iterations the report says so and the last iterate is kept.
///
/// It damps every oscillation, by 1/(1 + 2ζh + h²) of its energy a step where h = ω dt.
pub struct ImplicitEuler<R: Real, M: Storage, const FILL: usize = 1> {
    workspace: Workspace<R, M, FILL>,
    tolerance: Tolerance,
}

impl<R: Real, M: Storage, const FILL: usize> ImplicitEuler<R, M, FILL> {
    /// With the residual at which a step counts as solved, relative to the size of its terms, without a unit;
    /// 1e-6, say. 0 asks for as little as rounding allows. Without room for any particles yet.
    #[must_use]
    pub const fn new(tolerance: f64) -> Self {
        Self { workspace: Workspace::new(), tolerance: Tolerance(tolerance) }
    }

    /// What solves the linear systems of steps of `dt` seconds, and why.
    ///
    /// # Errors
    /// If the workspace has a fixed capacity and the world is larger.
    pub fn linear_solver(&mut self, view: &View<'_, R>, dt: R) -> Result<LinearSolver, Full> {
        self.workspace.linear_solver(&view.system, dt)
    }
}

impl<R: Real, M: Storage, const FILL: usize> Stepper<R> for ImplicitEuler<R, M, FILL> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.workspace.fit(plan)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        newton(view, dt, self.tolerance, &mut self.workspace.lend(&view.system, dt))
    }

    fn order(&self) -> u32 {
        1
    }

    fn curvature(&self) -> R {
        R::ONE
    }
}
