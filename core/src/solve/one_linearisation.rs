//! Implicit Euler's equation, linearised once.

use super::linear::solve;
use super::linearised::Keep;
use super::newton::Tolerance;
use super::start::start;
use super::workspace::Scratch;
use crate::Real;
use crate::compiled::HotLoops;
use crate::types::StepReport;
use crate::vectors::{advance_columns, along, dot, scaled};
use crate::world::View;

/// Solves (M + dt·C + dt²·K)(v' − v) = dt (f(x, v) − dt·K v), the equation linearised once about the state now
/// (Baraff and Witkin 1998, eq. 6), and writes v' and x' to the view's next state.
pub fn one_linearisation<R: Real>(
    view: &mut View<'_, R>,
    dt: R,
    tolerance: Tolerance,
    scratch: &mut Scratch<'_, R>,
) -> StepReport {
    let mut report = StepReport { iterations: 1, ..StepReport::default() };
    start(view, dt, scratch, &mut report);
    let View { system, current, next, .. } = view;
    R::Loops::evaluate(scratch, system, current, dt);
    // The matrix holds dt²·K alone at first, so that its product with v is the right-hand side's.
    scratch.linearise(system, dt, Keep::Stiffness);
    for (slot, known) in (0..).zip(scratch.search.iter_mut()) {
        *known = current.velocity_of(slot);
    }
    scratch.product.as_flattened_mut().fill(R::ZERO);
    R::Loops::multiply(scratch, system);
    let mut size = 0.0;
    // `start` has left the accelerations in the direction.
    let known = scratch.direction.iter().zip(scratch.product.iter()).zip(scratch.support.iter());
    let masses = system.mass.iter().zip(system.inverse_mass).take(system.plan.attached as usize);
    let residuals = scratch.residual.iter_mut();
    for ((residual, ((acceleration, stretched), support)), (mass, inverse_mass)) in residuals.zip(known).zip(masses) {
        let impulse = scaled(dt * *mass, *acceleration);
        let right = if *inverse_mass > R::ZERO { along(impulse, -R::ONE, *stretched) } else { const { [R::ZERO; 3] } };
        let right = support.allow(right);
        size += inverse_mass.to_f64() * dot(right, right).to_f64();
        *residual = scaled(-R::ONE, right);
    }
    scratch.linearise(system, dt, Keep::Definite);
    let size = Real::sqrt(size);
    let solved = solve(system, scratch, tolerance.0.max(R::EPSILON.to_f64()) * size, &mut report);
    report.converged = solved.converged;
    report.residual = if size > 0.0 { solved.residual / size } else { 0.0 };
    for (slot, change) in (0..system.plan.attached).zip(scratch.direction.iter()) {
        next.set_velocity(slot, along(current.velocity_of(slot), R::ONE, *change));
    }
    advance_columns(&mut next.position, &current.position, dt, &next.velocity);
    next.forget_residuals_from(0);
    report
}
