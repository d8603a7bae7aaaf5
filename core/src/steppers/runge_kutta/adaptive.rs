//! Runge-Kutta methods that choose the lengths of their steps.

use super::RungeKutta;
use super::embedded::Embedded;
use crate::Real;
use crate::roles::Stepper;
use crate::types::{Full, StepError, StepReport};
use crate::world::{Clock, Plan, StateColumns, Storage, View};

/// The part of what the estimate allows that a step is made of.
const SAFETY: f64 = 0.9;
/// The most that a step may be shorter and longer than the one before.
const CHANGE: [f64; 2] = [1.0 / 3.0, 6.0];
/// No part is shorter than this part of the whole step: where even such a one does not meet the tolerance, the report says so.
const SHORTEST: f64 = 1e-5;

/// An explicit Runge-Kutta method with an embedded formula that tells the error of each step: steps are as long as keeps
/// that below a tolerance, and those that turn out too long are taken again.
///
/// The error of a step is that of any position or, times the step's length, of any velocity, whichever is largest. With
/// estimates of order q the next step is 0.9 (tolerance/error)^(1/q) times as long as this one, within a third and six
/// times (Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, §II.4). A step that a caller asks for
/// is taken in as many parts as that takes; bounces begin parts of their own.
pub struct Adaptive<R: Real, M: Storage, T, const STAGES: usize> {
    pub(super) method: RungeKutta<R, M, T, STAGES>,
    /// m
    tolerance: f64,
    /// The length that the last estimate allows, s; infinite before there is one.
    allowed: f64,
    /// What is asked for, s; nothing before the first part of a step.
    whole: Option<f64>,
    /// Before the first part.
    start: StateColumns<R, M>,
    clock: Clock,
}

impl<R: Real, M: Storage, T: Embedded<STAGES>, const STAGES: usize> Adaptive<R, M, T, STAGES> {
    /// With the largest error in any position that a single part of a step may have, m; positive and finite, else every step is
    /// refused with [`StepError::Tolerance`]. How errors add up is the
    /// world's: a thousandth of what is to be reached in the end is a good first guess.
    #[must_use]
    pub const fn new(tolerance: f64) -> Self {
        Self {
            method: RungeKutta::new(),
            tolerance,
            allowed: f64::INFINITY,
            whole: None,
            start: StateColumns::EMPTY,
            clock: Clock::START,
        }
    }

    /// The length of the parts that steps are being taken in, s; nothing before the first.
    #[must_use]
    pub fn part(&self) -> Option<f64> {
        self.allowed.is_finite().then_some(self.allowed)
    }

    /// What is to come next of `most` seconds: no sliver is left for the part after.
    fn next_part(&self, most: R) -> R {
        let most_seconds = most.to_f64();
        if self.allowed >= most_seconds {
            most
        } else if 2.0 * self.allowed > most_seconds {
            R::from_f64(0.5) * most
        } else {
            R::from_f64(self.allowed)
        }
    }
}

impl<R: Real, M: Storage, T: Embedded<STAGES>, const STAGES: usize> Stepper<R> for Adaptive<R, M, T, STAGES> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.start.fit(plan.particles as usize)?;
        self.method.fit(plan)
    }

    fn accept(&self, plan: &Plan) -> Result<(), StepError> {
        // Nothing is below 0, and everything below what is not a number.
        if !(self.tolerance > 0.0 && self.tolerance.is_finite()) {
            return Err(StepError::Tolerance);
        }
        self.method.accept(plan)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        self.method.advance(view, dt)
    }

    fn advance_up_to(&mut self, view: &mut View<'_, R>, most: R, report: &mut StepReport) -> R {
        report.parts = report.parts.saturating_add(1);
        let mut part = self.next_part(most);
        let mut largest = CHANGE[1];
        let shortest = (SHORTEST * *self.whole.get_or_insert(most.to_f64())).min(most.to_f64());
        // What is cut short by `most` says little of what would be allowed.
        let before = if part == most && self.allowed.is_finite() { self.allowed } else { 0.0 };
        loop {
            report.add(&self.method.advance(view, part));
            let is_finite = view.refuse_non_finite().is_ok();
            let error = if is_finite { self.method.estimate(view, part) / self.tolerance } else { f64::INFINITY };
            let holds = error <= 1.0;
            // What is not a number is no small error.
            let change = if error >= 0.0 { SAFETY / root(error, T::ESTIMATED_ORDER) } else { CHANGE[0] };
            self.allowed =
                part.to_f64() * if holds { change.clamp(CHANGE[0], largest) } else { change.clamp(CHANGE[0], SAFETY) };
            if holds {
                self.allowed = self.allowed.max(before);
                return part;
            }
            // But for the rounding of a part.
            if part.to_f64() <= 1.000_001 * shortest {
                // The estimate is not met: whoever looks is told, and what is not finite is refused.
                self.allowed = shortest;
                report.converged = false;
                report.residual = if error > report.residual { error } else { report.residual };
                return part;
            }
            self.allowed = self.allowed.max(shortest);
            report.rejected = report.rejected.saturating_add(1);
            // What has just failed is not tried again right away.
            largest = 1.0;
            part = R::from_f64(self.allowed);
        }
    }

    fn chooses_parts(&self) -> bool {
        true
    }

    fn begins(&mut self, view: &View<'_, R>) {
        self.start.lend().copy_from(&view.current);
        self.clock = *view.clock;
        self.whole = None;
    }

    fn fails(&mut self, view: &mut View<'_, R>) {
        view.current.copy_from(&self.start.lend());
        *view.clock = self.clock;
        self.allowed = f64::INFINITY;
    }

    fn order(&self) -> u32 {
        Stepper::<R>::order(&self.method)
    }

    fn curvature(&self) -> R {
        self.method.curvature()
    }

    fn rearranged(&mut self, view: &View<'_, R>) {
        self.method.rearranged(view);
    }
}

/// x^(1/q), by Newton's method from the eighth root: `core` has no powers, and those of libraries differ in their bits.
fn root(x: f64, q: u32) -> f64 {
    // Beyond, a step changes as much as it may.
    let x = x.clamp(1e-9, 1e9);
    let mut root = Real::sqrt(Real::sqrt(Real::sqrt(x)));
    for _ in 0..8 {
        let power = (1..q).fold(1.0, |power, _| power * root);
        root += (x / power - root) / f64::from(q);
    }
    root
}
