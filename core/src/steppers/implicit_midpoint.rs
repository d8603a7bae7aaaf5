//! The implicit midpoint rule.

use crate::Real;
use crate::roles::Stepper;
use crate::solve::{LinearSolver, Tolerance, Workspace, newton};
use crate::types::{Full, StepReport};
use crate::world::{Plan, Storage, View};

/// x' = x + dt·½(v + v'); v' = v + dt·a(½(x + x'), ½(v + v')). Second order, stable at any time step.
///
/// The midpoint solves the equation of [`super::ImplicitEuler`] for half the step, and is solved for as there; the step
/// goes on from it as far again. Unlike implicit Euler it takes no energy from a linear undamped oscillation: it is
/// symplectic (Hairer, Lubich and Wanner, *Geometric Numerical Integration*, §VI.4). What is far too fast for the step is not
/// damped either. `FILL` is what it is there.
pub struct ImplicitMidpoint<R: Real, M: Storage, const FILL: usize = 1> {
    workspace: Workspace<R, M, FILL>,
    tolerance: Tolerance,
}

impl<R: Real, M: Storage, const FILL: usize> ImplicitMidpoint<R, M, FILL> {
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
        self.workspace.linear_solver(&view.system, half(dt))
    }
}

fn half<R: Real>(dt: R) -> R {
    R::from_f64(0.5) * dt
}

impl<R: Real, M: Storage, const FILL: usize> Stepper<R> for ImplicitMidpoint<R, M, FILL> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.workspace.fit(plan)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        let half = half(dt);
        let report = newton(view, half, self.tolerance, &mut self.workspace.lend(&view.system, half));
        view.next.extrapolate(&view.current, R::ONE);
        report
    }

    fn order(&self) -> u32 {
        2
    }

    fn curvature(&self) -> R {
        R::from_f64(0.5)
    }
}
