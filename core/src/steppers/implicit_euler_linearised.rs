//! Implicit Euler, linearised once a step.

use crate::Real;
use crate::roles::Stepper;
use crate::solve::{LinearSolver, Tolerance, Workspace, one_linearisation};
use crate::types::{Full, StepReport};
use crate::world::{Plan, Storage, View};

/// One linear solve a step: (M + dt·C + dt²·K)(v' − v) = dt (f(x, v) − dt·K v); x' = x + dt·v'. First order.
///
/// This is the step of Baraff and Witkin, *Large steps in cloth simulation* (1998), with their positive definite
/// matrix. It is one linearisation of [`super::ImplicitEuler`]'s equation, not its solution: cheaper, damped further,
/// and off by what the forces bend within a step. `FILL` is what it is there.
pub struct ImplicitEulerLinearised<R: Real, M: Storage, const FILL: usize = 1> {
    workspace: Workspace<R, M, FILL>,
    tolerance: Tolerance,
}

impl<R: Real, M: Storage, const FILL: usize> ImplicitEulerLinearised<R, M, FILL> {
    /// With the residual at which the linear system counts as solved, relative to its right-hand side, without a
    /// unit; more than 0; 1e-6, say. Without room for any particles yet.
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

impl<R: Real, M: Storage, const FILL: usize> Stepper<R> for ImplicitEulerLinearised<R, M, FILL> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.workspace.fit(plan)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        one_linearisation(view, dt, self.tolerance, &mut self.workspace.lend(&view.system, dt))
    }

    fn order(&self) -> u32 {
        1
    }

    fn curvature(&self) -> R {
        R::ONE
    }
}
