//! Implicit Euler's equation, linearised once.

use super::evaluate::Evaluated;
use super::linear::solve;
use super::linearised::{Keep, Linearisation, linearise};
use super::newton::Tolerance;
use super::start::start;
use super::workspace::Scratch;
use crate::Real;
use crate::types::StepReport;
use crate::vectors::{advance_columns, along, at, dot, fetch, lend, put, read, scaled, store};
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
    let (position, velocity) = (read(&current.position), read(&current.velocity));
    let mut evaluated = Evaluated { axis: scratch.axis, force_density: scratch.force_density };
    evaluated.springs(system, position, velocity, dt, scratch.blocks);
    // The matrix holds dt²·K alone at first, so that its product with v is the right-hand side's.
    linearise(system, &evaluated, scratch.resistance, dt, Keep::Stiffness);
    for (slot, known) in (0..).zip(scratch.search.iter_mut()) {
        *known = fetch(velocity, slot);
    }
    scratch.product.fill([R::ZERO; 3]);
    let matrix = Linearisation { axis: evaluated.axis, resistance: scratch.resistance };
    matrix.add_product(system, scratch.search, scratch.product);
    let mut size = 0.0;
    for slot in 0..system.plan.attached {
        // `start` has left the accelerations in the direction.
        let impulse = scaled(dt * at(system.mass, slot), at(scratch.direction, slot));
        let stretched = at(scratch.product, slot);
        let right = if system.is_dynamic(slot) { along(impulse, -R::ONE, stretched) } else { [R::ZERO; 3] };
        let right = at(scratch.support, slot).allow(right);
        size += at(system.inverse_mass, slot).to_f64() * dot(right, right).to_f64();
        put(scratch.residual, slot, scaled(-R::ONE, right));
    }
    linearise(system, &evaluated, scratch.resistance, dt, Keep::Definite);
    let size = Real::sqrt(size);
    let solved = solve(system, scratch, tolerance.0.max(R::EPSILON.to_f64()) * size, &mut report);
    report.converged = solved.converged;
    report.residual = if size > 0.0 { solved.residual / size } else { 0.0 };
    for slot in 0..system.plan.attached {
        store(&mut next.velocity, slot, along(fetch(velocity, slot), R::ONE, at(scratch.direction, slot)));
    }
    advance_columns(lend(&mut next.position), position, dt, read(&next.velocity));
    next.forget_residuals_from(0);
    report
}
