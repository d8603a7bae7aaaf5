//! How far to go along a direction.

use super::newton::Tolerance;
use super::residual::{Measured, residual};
use super::workspace::Scratch;
use crate::Real;
use crate::sums::sum;
use crate::types::StepReport;
use crate::vectors::{along, at, dot};
use crate::world::View;

/// Halvings of one line search.
const MOST_HALVINGS: u32 = 30;
/// The slope that a line search may be left with, relative to the first: past it the step went too far.
const SLOPE_LEFT: f64 = 0.9;

/// Goes along the direction, halving the way while it leads past the lowest point: while the slope r·p there, which is
/// negative at the start, has turned and is nearly as steep. Nothing if no way is short enough.
pub fn search_line<R: Real>(
    view: &mut View<'_, R>,
    dt: R,
    scratch: &mut Scratch<'_, R>,
    tolerance: Tolerance,
    report: &mut StepReport,
) -> Option<Measured> {
    let count = view.system.plan.attached;
    let descent = -slope(scratch, count);
    for (slot, start) in (0..count).zip(scratch.spare.iter_mut()) {
        *start = view.next.velocity_of(slot);
    }
    let mut fraction = R::ONE;
    for _ in 0..MOST_HALVINGS {
        go(view, scratch, fraction);
        let measured = residual(view, dt, scratch, report);
        let is_near = slope(scratch, count) <= SLOPE_LEFT * descent || tolerance.is_within_reach(&measured);
        if measured.norm.is_finite() && is_near {
            return Some(measured);
        }
        fraction = R::from_f64(0.5) * fraction;
    }
    go(view, scratch, R::ZERO);
    residual(view, dt, scratch, report);
    None
}

/// Sets the velocities to those so far along the direction.
fn go<R: Real>(view: &mut View<'_, R>, scratch: &Scratch<'_, R>, fraction: R) {
    let ways = scratch.spare.iter().zip(scratch.direction.iter());
    for (slot, (start, p)) in (0..view.system.plan.attached).zip(ways) {
        let velocity = if fraction > R::ZERO { along(*start, fraction, *p) } else { *start };
        view.next.set_velocity(slot, velocity);
    }
}

/// r·p
fn slope<R: Real>(scratch: &Scratch<'_, R>, count: u32) -> f64 {
    sum(count, |slot| dot(at(scratch.residual, slot), at(scratch.direction, slot)).to_f64())
}
