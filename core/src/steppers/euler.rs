//! What the explicit and the semi-implicit Euler method share: they differ in one argument.

use core::ops::Range;

use crate::Real;
use crate::forces::Then;
use crate::types::StepReport;
use crate::vectors::{Columns, ColumnsMut, lend, read, split, window, window_mut};
use crate::world::View;

/// v' = v + dt·a(x, v); x' = x + dt·v' or, with the `EXPLICIT` one, x' = x + dt·v.
pub fn advance<R: Real, const EXPLICIT: bool>(view: &mut View<'_, R>, dt: R) -> StepReport {
    let mut report = StepReport::default();
    let View { system, current, next, .. } = view;
    let (x, v) = (read(&current.position), read(&current.velocity));
    let update = Update::<R, EXPLICIT> { dt, x, v, first: 0, next_position: lend(&mut next.position) };
    view.is_next_finite = system.accelerations_then(x, v, lend(&mut next.velocity), &mut report, update);
    report
}

/// From accelerations to the next velocities, in their place, and positions.
struct Update<'a, R, const EXPLICIT: bool> {
    dt: R,
    x: Columns<'a, R>,
    v: Columns<'a, R>,
    /// The slot that the next positions begin with.
    first: u32,
    next_position: ColumnsMut<'a, R>,
}

impl<R: Real, const EXPLICIT: bool> Then<R> for Update<'_, R, EXPLICIT> {
    #[inline(always)]
    fn then(&mut self, slots: Range<u32>, accelerations: ColumnsMut<'_, R>) -> bool {
        let (x, v) = (window(self.x, slots.clone()), window(self.v, slots.clone()));
        let next = window_mut(lend(&mut self.next_position), slots.start - self.first..slots.end - self.first);
        let mut finite = true;
        for ((a, next), (x, v)) in accelerations.into_iter().zip(next).zip(x.into_iter().zip(v)) {
            finite &= update::<R, EXPLICIT>(self.dt, x, v, a, next);
        }
        finite
    }

    fn split(self, slot: u32) -> (Self, Self) {
        let (lower, upper) = split(self.next_position, slot - self.first);
        (Self { next_position: lower, ..self }, Self { next_position: upper, first: slot, ..self })
    }
}

/// Returns whether the next state of these is finite.
#[inline(always)]
fn update<R: Real, const EXPLICIT: bool>(dt: R, x: &[R], v: &[R], a: &mut [R], next: &mut [R]) -> bool {
    let mut infinite = 0;
    for ((a, next), (x, v)) in a.iter_mut().zip(next).zip(x.iter().zip(v)) {
        let velocity = *v + dt * *a;
        let position = *x + dt * if EXPLICIT { *v } else { velocity };
        *a = velocity;
        *next = position;
        // The semi-implicit method's position is no more finite than its velocity.
        infinite |= u32::from(!position.is_finite()) | u32::from(EXPLICIT && !velocity.is_finite());
    }
    infinite == 0
}
