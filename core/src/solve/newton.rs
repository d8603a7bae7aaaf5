//! Newton's method for the velocities at the end of a step.

use super::conjugate_gradients::{Solved, conjugate_gradients};
use super::linearised::{Keep, Linearisation};
use super::residual::{Measured, residual};
use super::workspace::Scratch;
use crate::Real;
use crate::contact::support;
use crate::sums::sum;
use crate::types::StepReport;
use crate::vectors::{advance_columns, along, at, copy_columns, dot, fetch, lend, put, read, scaled, store};
use crate::world::{System, View};

/// Newton iterations in one step.
const MOST_ITERATIONS: u32 = 100;
/// Halvings of one line search.
const MOST_HALVINGS: u32 = 30;
/// The linear residual that a Newton iteration asks for, relative to that of the equation: it then falls a
/// hundredfold an iteration at best, and no product with the matrix is spent on digits that the next one changes.
const LINEAR_TOLERANCE: f64 = 1e-2;
/// An iteration that leaves more than this part of the residual is slow.
const SLOW: f64 = 0.1;
/// The slope that a line search may be left with, relative to the first: past it the step went too far.
const SLOPE_LEFT: f64 = 0.9;

/// The residual at which a step counts as solved, relative to the size of its terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance(pub f64);

impl Tolerance {
    /// Whether a residual is as small as was asked for.
    fn is_met(self, measured: &Measured) -> bool {
        measured.norm <= self.0 * measured.scale
    }

    /// Whether it is that, or no larger than rounding may leave it.
    fn is_within_reach(self, measured: &Measured) -> bool {
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
        let solved = find_direction(view, dt, scratch, target, slow, &mut report);
        match search_line(view, dt, scratch, solved.descent, tolerance, &mut report) {
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
) -> Solved {
    if slow {
        linearise(view, dt, scratch, Keep::All);
        let solved = conjugate_gradients(&view.system, scratch, target);
        report.linear_iterations += solved.iterations;
        if solved.converged {
            return solved;
        }
        // The attempt has used the residual up.
        residual(view, dt, scratch, report);
    }
    linearise(view, dt, scratch, Keep::Definite);
    let solved = conjugate_gradients(&view.system, scratch, target);
    report.linear_iterations += solved.iterations;
    solved
}

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
    let count = view.system.plan.attached;
    view.system.force_densities(read(&view.current.position), read(&view.current.velocity), view.force_density);
    // The matrix holds dt²·K alone at first, so that its product with v is the right-hand side's.
    linearise(view, dt, scratch, Keep::Stiffness);
    let mut size = 0.0;
    for slot in 0..count {
        let system = &view.system;
        let stretched = matrix(scratch).row(system, read(&view.current.velocity), slot, [R::ZERO; 3]);
        // `start` has left the accelerations in the direction.
        let impulse = scaled(dt * at(system.mass, slot), fetch(read(&scratch.direction), slot));
        let right = if system.is_dynamic(slot) { along(impulse, -R::ONE, stretched) } else { [R::ZERO; 3] };
        let right = at(scratch.support, slot).allow(right);
        size += at(system.inverse_mass, slot).to_f64() * dot(right, right).to_f64();
        store(&mut scratch.residual, slot, scaled(-R::ONE, right));
    }
    linearise(view, dt, scratch, Keep::Definite);
    let size = Real::sqrt(size);
    let solved = conjugate_gradients(&view.system, scratch, tolerance.0.max(R::EPSILON.to_f64()) * size);
    report.linear_iterations = solved.iterations;
    report.converged = solved.converged;
    report.residual = if size > 0.0 { solved.residual / size } else { 0.0 };
    let View { current, next, .. } = view;
    for slot in 0..count {
        let change = fetch(read(&scratch.direction), slot);
        store(&mut next.velocity, slot, along(fetch(read(&current.velocity), slot), R::ONE, change));
    }
    advance_columns(lend(&mut next.position), read(&current.position), dt, read(&next.velocity));
    report
}

/// Starts from the velocities now; a particle without springs is at its solution v + dt·g at once. Leaves the
/// accelerations now in the direction, and what planes hold up in the supports.
fn start<R: Real>(view: &mut View<'_, R>, dt: R, scratch: &mut Scratch<'_, R>, report: &mut StepReport) {
    let View { system, current, next, .. } = view;
    let (x, v) = (read(&current.position), read(&current.velocity));
    // What planes hold up is decided by what presses, before they push back.
    let unsupported = System { support: false, ..*system };
    unsupported.accelerations(x, v, lend(&mut next.velocity), report);
    for slot in 0..system.plan.particles {
        let (velocity, a) = (fetch(v, slot), fetch(read(&next.velocity), slot));
        if slot >= system.plan.attached {
            store(&mut next.velocity, slot, along(velocity, dt, a));
            continue;
        }
        store(&mut next.velocity, slot, velocity);
        store(&mut scratch.direction, slot, a);
        let held = system.support.then(|| support(system.planes, fetch(x, slot), velocity, a));
        put(scratch.support, slot, held.unwrap_or_default());
    }
    copy_columns(lend(&mut next.position), x);
}

/// Linearises about the view's next state.
fn linearise<R: Real>(view: &View<'_, R>, dt: R, scratch: &mut Scratch<'_, R>, keep: Keep) {
    matrix(scratch).about(&view.system, read(&view.next.position), view.force_density, dt, keep);
}

fn matrix<'a, R: Real>(scratch: &'a mut Scratch<'_, R>) -> Linearisation<'a, R> {
    Linearisation { axis: lend(&mut scratch.axis), along: scratch.along, across: scratch.across }
}

/// Goes along the direction, halving the way while it leads past the lowest point: while the slope r·p there, which
/// starts at −`descent`, has turned and is nearly as steep as at the start. Nothing if no way is short enough.
fn search_line<R: Real>(
    view: &mut View<'_, R>,
    dt: R,
    scratch: &mut Scratch<'_, R>,
    descent: f64,
    tolerance: Tolerance,
    report: &mut StepReport,
) -> Option<Measured> {
    let count = view.system.plan.attached;
    copy_columns(lend(&mut scratch.base), read(&view.next.velocity));
    let mut fraction = R::ONE;
    for _ in 0..MOST_HALVINGS {
        for slot in 0..count {
            let (base, p) = (fetch(read(&scratch.base), slot), fetch(read(&scratch.direction), slot));
            store(&mut view.next.velocity, slot, along(base, fraction, p));
        }
        let measured = residual(view, dt, scratch, report);
        let slope = sum(count, |slot| {
            dot(fetch(read(&scratch.residual), slot), fetch(read(&scratch.direction), slot)).to_f64()
        });
        if measured.norm.is_finite() && (slope <= SLOPE_LEFT * descent || tolerance.is_within_reach(&measured)) {
            return Some(measured);
        }
        fraction = R::from_f64(0.5) * fraction;
    }
    for slot in 0..count {
        store(&mut view.next.velocity, slot, fetch(read(&scratch.base), slot));
    }
    residual(view, dt, scratch, report);
    None
}
