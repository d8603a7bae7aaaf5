//! The linear system of a Newton iteration, solved by whichever of the two ways is cheaper.

use super::conjugate_gradients::Solved;
use super::preconditioner::Preconditioner;
use super::workspace::Scratch;
use crate::Real;
use crate::types::StepReport;
use crate::world::System;

/// Improvements of a solution by the very factor of its matrix: each takes from the residual all but what rounding adds.
const MOST_REFINEMENTS: f64 = 10.0;

/// Solves A·direction = −residual to a residual norm of `target`, for the matrix that the scratch holds. Where a factor
/// is worth its work it comes first; conjugate gradients around it verify its solution, and improve one that rounding or
/// an older factor leaves short of the target.
pub fn solve<R: Real>(
    system: &System<'_, R>,
    scratch: &mut Scratch<'_, R>,
    target: f64,
    report: &mut StepReport,
) -> Solved {
    scratch.set_out(system);
    let go_on = |scratch: &mut Scratch<'_, R>, preconditioner, most: f64, report: &mut StepReport| {
        let solved = scratch.go_on(system, preconditioner, target, most as u32);
        report.linear_iterations = report.linear_iterations.saturating_add(solved.iterations);
        solved
    };
    let most = most_iterations(system.plan.attached);
    let solver = scratch.direct.solver;
    if !scratch.direct.is_chosen {
        scratch.invert_blocks(system);
        let solved = go_on(scratch, Preconditioner::Blocks, solver.patience.min(most), report);
        if solved.is_final() || !solver.is_possible() {
            return solved;
        }
        // They have taken as long as a factor would have: it is about time for one.
        scratch.direct.is_chosen = true;
    }
    // The factor of an earlier iteration may still be near enough.
    if scratch.direct.is_made && solver.renewal > 1.0 {
        let solved = go_on(scratch, Preconditioner::Factor, solver.renewal, report);
        if solved.is_final() {
            return solved;
        }
    }
    report.factorisations = report.factorisations.saturating_add(1);
    scratch.factorise(system);
    if scratch.direct.is_made {
        let solved = go_on(scratch, Preconditioner::Factor, MOST_REFINEMENTS, report);
        if solved.is_final() {
            return solved;
        }
    }
    scratch.invert_blocks(system);
    go_on(scratch, Preconditioner::Blocks, most, report)
}

/// In exact arithmetic there are as many iterations as unknowns at most; rounding may double them.
fn most_iterations(particles: u32) -> f64 {
    (6.0 * f64::from(particles)).clamp(50.0, 20_000.0)
}
