//! The trapezoidal rule and the backward differentiation formula of second order, one after the other.

use crate::Real;
use crate::roles::Stepper;
use crate::solve::{LinearSolver, Tolerance, Workspace, newton};
use crate::types::{Full, StepReport};
use crate::vectors::{advance_columns, lend, read};
use crate::world::{Plan, StateColumns, Storage, View};

/// √2
const ROOT: f64 = core::f64::consts::SQRT_2;
/// ½γ with γ = 2 − √2: the part of the step that both stages solve an implicit Euler step of, with the same matrix.
const PART: f64 = 1.0 - 0.5 * ROOT;
/// (1 − γ)²/(γ (2 − γ)): how far the second stage's base lies beyond the first stage, in parts of the way there.
const BEYOND: f64 = (ROOT - 1.0) * (ROOT - 1.0) / ((2.0 - ROOT) * ROOT);

/// TR-BDF2: the trapezoidal rule to γ dt, and from there the second backward differentiation formula to dt, γ = 2 − √2.
/// Second order, stable at any time step, and what is far too fast for it is damped away (Bank and others, *Transient
/// simulation of silicon devices and circuits*, 1985; Hosea and Shampine, *Analysis and implementation of TR-BDF2*, 1996).
///
/// Both stages are implicit Euler steps of ½γ dt from other states than the current one: they are solved for as in
/// [`super::ImplicitEuler`]. `FILL` is what it is there.
pub struct TrBdf2<R: Real, M: Storage, const FILL: usize = 1> {
    workspace: Workspace<R, M, FILL>,
    tolerance: Tolerance,
    /// The state that a stage starts from.
    base: StateColumns<R, M>,
}

impl<R: Real, M: Storage, const FILL: usize> TrBdf2<R, M, FILL> {
    /// With the residual at which a stage counts as solved, relative to the size of its terms, without a unit;
    /// 1e-6, say. 0 asks for as little as rounding allows. Without room for any particles yet.
    #[must_use]
    pub const fn new(tolerance: f64) -> Self {
        Self { workspace: Workspace::new(), tolerance: Tolerance(tolerance), base: StateColumns::EMPTY }
    }

    /// What solves the linear systems of steps of `dt` seconds, and why.
    ///
    /// # Errors
    /// If the workspace has a fixed capacity and the world is larger.
    pub fn linear_solver(&mut self, view: &View<'_, R>, dt: R) -> Result<LinearSolver, Full> {
        self.workspace.linear_solver(&view.system, part(dt))
    }
}

fn part<R: Real>(dt: R) -> R {
    R::from_f64(PART) * dt
}

impl<R: Real, M: Storage, const FILL: usize> Stepper<R> for TrBdf2<R, M, FILL> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.workspace.fit(plan)?;
        self.base.fit(plan.particles as usize)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        let part = part(dt);
        let mut base = self.base.lend();
        let mut report = StepReport::default();
        // x + ½γdt v and v + ½γdt a(x, v)
        let View { system, current, next, .. } = view;
        let (position, velocity) = (current.carried_position(), read(&current.velocity));
        system.accelerations(position, velocity, lend(&mut next.velocity), &mut report);
        advance_columns(&mut base.position, &current.position, part, &current.velocity);
        advance_columns(&mut base.velocity, &current.velocity, part, &next.velocity);
        let scratch = &mut self.workspace.lend(&view.system, part);
        report.add(&newton(&mut view.starting_from(&mut base), part, self.tolerance, scratch));
        // x_γ + (x_γ − x)(1 − γ)²/(γ(2 − γ)), and its velocity likewise
        base.copy_from(&view.next);
        base.extrapolate(&view.current, R::from_f64(BEYOND));
        report.add(&newton(&mut view.starting_from(&mut base), part, self.tolerance, scratch));
        report
    }

    fn order(&self) -> u32 {
        2
    }

    fn curvature(&self) -> R {
        R::from_f64(0.5)
    }
}
