//! The linear system of a Newton iteration, solved by whichever of the two ways is cheaper.

use super::conjugate_gradients::{Solved, Unknowns, conjugate_gradients, set_out};
use super::linearised::Linearisation;
use super::preconditioner::{Preconditioner, invert_blocks};
use super::workspace::Scratch;
use crate::Real;
use crate::types::StepReport;
use crate::world::System;

/// Improvements of a solution by the very factor of its matrix: each takes from the residual all but what rounding adds.
const MOST_REFINEMENTS: u32 = 10;

/// Solves A·direction = −residual to a residual norm of `target`, for the matrix that the scratch holds. Where a factor
/// is worth its work it comes first; conjugate gradients around it verify its solution, and improve one that rounding or
/// an older factor leaves short of the target.
pub fn solve<R: Real>(
    system: &System<'_, R>,
    scratch: &mut Scratch<'_, R>,
    target: f64,
    report: &mut StepReport,
) -> Solved {
    let Scratch { direction, residual, spare, search, product, blocks, support, axis, resistance, direct, .. } =
        scratch;
    let matrix = Linearisation { axis, resistance };
    let mut unknowns = Unknowns { direction, rest: spare, search, product };
    set_out(system, support, residual, &mut unknowns);
    let mut go_on = |mut preconditioner: Preconditioner<'_, '_, R>, most: u32, report: &mut StepReport| {
        let solved = conjugate_gradients(system, &matrix, support, &mut preconditioner, &mut unknowns, target, most);
        report.linear_iterations = report.linear_iterations.saturating_add(solved.iterations);
        solved
    };
    if !direct.is_chosen {
        let most = direct.solver.patience.min(most_iterations(system.plan.attached)) as u32;
        invert_blocks(system, &matrix, blocks);
        let solved = go_on(Preconditioner::Blocks(blocks), most, report);
        if solved.is_final() || !direct.solver.is_possible() {
            return solved;
        }
        // They have taken as long as a factor would have: it is about time for one.
        direct.is_chosen = true;
    }
    // The factor of an earlier iteration may still be near enough.
    if direct.is_made && direct.solver.renewal > 1.0 {
        let solved = go_on(Preconditioner::Factor(&mut direct.factor), direct.solver.renewal as u32, report);
        if solved.is_final() {
            return solved;
        }
    }
    report.factorisations = report.factorisations.saturating_add(1);
    direct.is_made = direct.factor.make(system, &matrix, support, blocks);
    if direct.is_made {
        let solved = go_on(Preconditioner::Factor(&mut direct.factor), MOST_REFINEMENTS, report);
        if solved.is_final() {
            return solved;
        }
    }
    invert_blocks(system, &matrix, blocks);
    go_on(Preconditioner::Blocks(blocks), most_iterations(system.plan.attached) as u32, report)
}

/// In exact arithmetic there are as many iterations as unknowns at most; rounding may double them.
fn most_iterations(particles: u32) -> f64 {
    (6.0 * f64::from(particles)).clamp(50.0, 20_000.0)
}
