//! Newton's method for the velocities at the end of a step.

use super::conjugate_gradients::Solved;
use super::line_search::search_line;
use super::linear::solve;
use super::linearised::Keep;
use super::residual::{Measured, residual};
use super::start::start;
use super::workspace::Scratch;
use crate::Real;
use crate::types::StepReport;
use crate::world::View;

/// Newton iterations in one step.
const MOST_ITERATIONS: u32 = 100;
/// The linear residual that a Newton iteration asks for, relative to that of the equation: it then falls a
/// hundredfold an iteration at best, and no product with the matrix is spent on digits that the next one changes.
const LINEAR_TOLERANCE: f64 = 1e-2;
/// An iteration that leaves more than this part of the residual is slow.
const SLOW: f64 = 0.1;

/// The residual at which a step counts as solved, relative to the size of its terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance(pub f64);

impl Tolerance {
    /// Whether a residual is as small as was asked for.
    fn is_met(self, measured: &Measured) -> bool {
        measured.norm <= self.0 * measured.scale
    }

    /// Whether it is that, or no larger than rounding may leave it.
    pub fn is_within_reach(self, measured: &Measured) -> bool {
        self.is_met(measured) || measured.norm <= measured.rounding
    }
}

/// Solves v' = v + dt·a(x + dt·v', v') and writes v' and x' to the view's next state.
pub fn newton<R: Real>(
    view: &mut View<'_, R>,
    dt: R,
    tolerance: Tolerance,
    scratch: &mut Scratch<'_, R>,
) -> StepReport {
    let mut report = StepReport::default();
    start(view, dt, scratch, &mut report);
    let mut measured = residual(view, dt, scratch, &mut report);
    let mut slow = false;
    while !tolerance.is_met(&measured) && report.iterations < MOST_ITERATIONS {
        report.iterations += 1;
        let target = (LINEAR_TOLERANCE * measured.norm).max(0.1 * tolerance.0 * measured.scale);
        find_direction(view, dt, scratch, target, slow, &mut report);
        match search_line(view, dt, scratch, tolerance, &mut report) {
            Some(found) => {
                // What rounding may leave is only bounded: it is reached where an iteration no longer gains much.
                let ended = tolerance.is_within_reach(&found) && found.norm > 0.5 * measured.norm;
                slow = found.norm > SLOW * measured.norm;
                measured = found;
                if ended {
                    break;
                }
            }
            // The definite matrix has not had its turn.
            None if slow => slow = false,
            None => break,
        }
    }
    view.next.forget_residuals_from(0);
    report.converged = tolerance.is_within_reach(&measured);
    report.residual = measured.relative();
    report
}

/// Where to search next. The definite matrix always leads down, but where springs are compressed only slowly: after a
/// `slow` iteration the matrix as it is gets a try, and the definite one its turn where that bends down somewhere.
fn find_direction<R: Real>(
    view: &mut View<'_, R>,
    dt: R,
    scratch: &mut Scratch<'_, R>,
    target: f64,
    slow: bool,
    report: &mut StepReport,
) {
    if slow && solve_keeping(view, dt, scratch, Keep::All, target, report).converged {
        return;
    }
    solve_keeping(view, dt, scratch, Keep::Definite, target, report);
}

/// Solves the equation linearised about the view's next state.
fn solve_keeping<R: Real>(
    view: &mut View<'_, R>,
    dt: R,
    scratch: &mut Scratch<'_, R>,
    keep: Keep,
    target: f64,
    report: &mut StepReport,
) -> Solved {
    scratch.linearise(&view.system, dt, keep);
    solve(&view.system, scratch, target, report)
}
