//! What the explicit and the semi-implicit Euler method share: they differ in one argument.

use crate::Real;
use crate::carried::{Carried, CarriedMut};
use crate::forces::{Acceleration, Rest, Then, Tile};
use crate::lanes::{self, SixColumns};
use crate::types::StepReport;
use crate::vectors::{Columns, ColumnsMut, cut, cut_mut, lend, read, scaled, split, triples, triples_mut};
use crate::world::View;

/// v' = v + dt·a(x, v); x' = x + dt·v' or, with the `EXPLICIT` one, x' = x + dt·v.
pub fn advance<R: Real, const EXPLICIT: bool>(view: &mut View<'_, R>, dt: R) -> StepReport {
    let mut report = StepReport::default();
    let View { system, current, next, .. } = view;
    let (x, v) = (current.carried_position(), current.carried_velocity());
    let [next_position, CarriedMut { value: next_velocity, residual: velocity_residual }] = next.lend().apart();
    let update = Update::<R, EXPLICIT> { dt, x, v, first: 0, next_position, velocity_residual };
    view.is_next_finite = system.accelerations_then(x, v.value, next_velocity, &mut report, update);
    report
}

/// From accelerations to the next velocities, in their place, and positions.
struct Update<'a, R: Real, const EXPLICIT: bool> {
    dt: R,
    x: Carried<'a, R>,
    v: Carried<'a, R>,
    /// The slot that the next positions begin with.
    first: u32,
    next_position: CarriedMut<'a, R>,
    /// Of the next velocities.
    velocity_residual: ColumnsMut<'a, R::Residual>,
}

impl<R: Real, const EXPLICIT: bool> Update<'_, R, EXPLICIT> {
    /// The same sums with their rounding kept.
    fn carry<A: Acceleration<R>>(&mut self, tile: Tile<'_, R, A>) -> Option<bool> {
        let (dt, next) = (self.dt, tile.slots.start - self.first..tile.slots.end - self.first);
        let (x, v) = (self.x.cut(tile.slots.clone())?, self.v.cut(tile.slots.clone())?);
        let (lanes, rest) = (tile.rest.lanes, tile.rest);
        let residual = cut_mut(lend(&mut self.velocity_residual), next.clone())?;
        let mut velocity = CarriedMut { value: tile.below, residual };
        let impulses = rest.accelerations().map(|acceleration| move |below| scaled(dt, acceleration(below)));
        let is_velocity_finite = velocity.lend().add(lanes, v, impulses);
        let moving = if EXPLICIT { v.value } else { read(&velocity.value) };
        let drifts = triples(moving).map(|v| move |_| scaled(dt, v));
        let is_position_finite = self.next_position.lend().cut(next)?.add(lanes, x, drifts);
        Some(is_velocity_finite && is_position_finite)
    }
}

impl<R: Real, const EXPLICIT: bool> Then<R> for Update<'_, R, EXPLICIT> {
    #[inline(always)]
    fn then<A: Acceleration<R>>(&mut self, mut tile: Tile<'_, R, A>) -> bool {
        if R::IS_COMPENSATED {
            return self.carry(tile).unwrap_or(false);
        }
        let next = tile.slots.start - self.first..tile.slots.end - self.first;
        let (Some(x), Some(v), Some([x_next, y_next, z_next])) = (
            cut(self.x.value, tile.slots.clone()),
            cut(self.v.value, tile.slots.clone()),
            cut_mut(lend(&mut self.next_position.value), next),
        ) else {
            return false;
        };
        if cfg!(feature = "small") {
            tile.fresh();
            let ([x, y, z], [u, v, w], [x_a, y_a, z_a]) = (x, v, tile.below);
            let finite = update::<R, EXPLICIT>(self.dt, x, u, x_a, x_next);
            let finite = update::<R, EXPLICIT>(self.dt, y, v, y_a, y_next) & finite;
            return update::<R, EXPLICIT>(self.dt, z, w, z_a, z_next) & finite;
        }
        let [x_below, y_below, z_below] = tile.below;
        let particles = Particles::<R, A, EXPLICIT> { dt: self.dt, x, v, rest: tile.rest };
        lanes::run_on_six(tile.rest.lanes, particles, x_below, y_below, z_below, x_next, y_next, z_next)
    }

    fn split(self, slot: u32) -> (Self, Self) {
        let (lower, upper) = self.next_position.split(slot - self.first);
        let (lower_residual, upper_residual) = split(self.velocity_residual, slot - self.first);
        (
            Self { next_position: lower, velocity_residual: lower_residual, ..self },
            Self { next_position: upper, velocity_residual: upper_residual, first: slot, ..self },
        )
    }
}

/// Along one axis, from accelerations to the next velocities, in their place, and positions. Returns whether they are finite.
#[inline(never)]
fn update<R: Real, const EXPLICIT: bool>(dt: R, x: &[R], v: &[R], accelerations: &mut [R], next: &mut [R]) -> bool {
    let mut finite = true;
    for ((acceleration, next), (x, v)) in accelerations.iter_mut().zip(next).zip(x.iter().zip(v)) {
        let velocity = *v + dt * *acceleration;
        *next = *x + dt * if EXPLICIT { *v } else { velocity };
        *acceleration = velocity;
        finite &= next.is_finite() && (!EXPLICIT || velocity.is_finite());
    }
    finite
}

/// What a tile's particles are to be updated from, but for the forces from below.
struct Particles<'a, R, A, const EXPLICIT: bool> {
    dt: R,
    x: Columns<'a, R>,
    v: Columns<'a, R>,
    rest: Rest<'a, R, A>,
}

impl<R: Real, A: Acceleration<R>, const EXPLICIT: bool> SixColumns<R> for Particles<'_, R, A, EXPLICIT> {
    type Output = bool;

    /// Writes the next velocities in place of the forces from below, and the next positions. Returns whether they are
    /// finite.
    #[inline(always)]
    fn run(
        self,
        x_below: &mut [R],
        y_below: &mut [R],
        z_below: &mut [R],
        x_next: &mut [R],
        y_next: &mut [R],
        z_next: &mut [R],
    ) -> bool {
        let Self { dt, x, v, rest } = self;
        let written = triples_mut([x_below, y_below, z_below]).zip(triples_mut([x_next, y_next, z_next]));
        let mut infinite = 0;
        for (((below, next), acceleration), (x, v)) in written.zip(rest.accelerations()).zip(triples(x).zip(triples(v)))
        {
            let a = acceleration(below.each_ref().map(|component| **component));
            let components = a.into_iter().zip(x.into_iter().zip(v));
            for ((below, next), (a, (x, v))) in below.into_iter().zip(next).zip(components) {
                let velocity = v + dt * a;
                let position = x + dt * if EXPLICIT { v } else { velocity };
                *below = velocity;
                *next = position;
                // The semi-implicit method's position is no more finite than its velocity.
                infinite |= u32::from(!position.is_finite()) | u32::from(EXPLICIT && !velocity.is_finite());
            }
        }
        infinite == 0
    }
}
