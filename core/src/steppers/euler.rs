//! What the explicit and the semi-implicit Euler method share: they differ in one argument.

use core::ops::Range;

use crate::Real;
use crate::forces::Then;
use crate::types::StepReport;
use crate::vectors::{Columns, ColumnsMut, lend, read, window, window_mut};
use crate::world::View;

/// v' = v + dt·a(x, v); x' = x + dt·v' or, with the `EXPLICIT` one, x' = x + dt·v.
pub fn advance<R: Real, const EXPLICIT: bool>(view: &mut View<'_, R>, dt: R) -> StepReport {
    let mut report = StepReport::default();
    let View { system, current, next, .. } = view;
    let (x, v) = (read(&current.position), read(&current.velocity));
    let mut update = Update::<R, EXPLICIT> { dt, x, v, next_position: lend(&mut next.position), finite: true };
    system.accelerations_then(x, v, lend(&mut next.velocity), &mut report, &mut update);
    view.is_next_finite = update.finite;
    report
}

/// From accelerations to the next velocities, in their place, and positions.
struct Update<'a, R, const EXPLICIT: bool> {
    dt: R,
    x: Columns<'a, R>,
    v: Columns<'a, R>,
    next_position: ColumnsMut<'a, R>,
    /// So far.
    finite: bool,
}

impl<R: Real, const EXPLICIT: bool> Then<R> for Update<'_, R, EXPLICIT> {
    #[inline(always)]
    fn then(&mut self, slots: Range<u32>, accelerations: ColumnsMut<'_, R>) {
        let (x, v) = (window(self.x, slots.clone()), window(self.v, slots.clone()));
        let next = window_mut(lend(&mut self.next_position), slots);
        for ((a, next), (x, v)) in accelerations.into_iter().zip(next).zip(x.into_iter().zip(v)) {
            self.finite &= update::<R, EXPLICIT>(self.dt, x, v, a, next);
        }
    }
}

#[inline(always)]
fn update<R: Real, const EXPLICIT: bool>(dt: R, x: &[R], v: &[R], a: &mut [R], next: &mut [R]) -> bool {
    let mut infinite = 0;
    for ((a, next), (x, v)) in a.iter_mut().zip(next).zip(x.iter().zip(v)) {
        let velocity = *v + dt * *a;
        let position = *x + dt * if EXPLICIT { *v } else { velocity };
        *a = velocity;
        *next = position;
        infinite |= u32::from(!velocity.is_finite()) | u32::from(!position.is_finite());
    }
    infinite == 0
}
