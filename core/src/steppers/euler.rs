//! What the explicit and the semi-implicit Euler method share: they differ in one argument.

use crate::Real;
use crate::carried::{Carried, CarriedMut};
use crate::compiled::HotLoops;
use crate::forces::{Falling, Follow, Known, Origin, Pulled, Rest, Rule, Then, Tile};
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
    fn carry(&mut self, tile: Tile<'_, R>) -> Option<bool> {
        match tile.rest.origin {
            Origin::Pulled => self.carry_by(tile, Pulled),
            Origin::Falling => self.carry_by(tile, Falling),
            Origin::Known => self.carry_by(tile, Known),
        }
    }

    fn carry_by(&mut self, tile: Tile<'_, R>, rule: impl Rule<R>) -> Option<bool> {
        let (dt, next) = (self.dt, tile.slots.start - self.first..tile.slots.end - self.first);
        let (x, v) = (self.x.cut(tile.slots.clone())?, self.v.cut(tile.slots.clone())?);
        let (lanes, rest) = (tile.rest.lanes, tile.rest);
        let residual = cut_mut(lend(&mut self.velocity_residual), next.clone())?;
        let mut velocity = CarriedMut { value: tile.below, residual };
        let impulses = rest.accelerations(rule).map(|acceleration| move |below| scaled(dt, acceleration(below)));
        let is_velocity_finite = velocity.lend().add(lanes, v, impulses);
        let moving = if EXPLICIT { v.value } else { read(&velocity.value) };
        let drifts = triples(moving).map(|v| move |_| scaled(dt, v));
        let is_position_finite = self.next_position.lend().cut(next)?.add(lanes, x, drifts);
        Some(is_velocity_finite && is_position_finite)
    }
}

impl<R: Real, const EXPLICIT: bool> Then<R> for Update<'_, R, EXPLICIT> {
    fn then(&mut self, mut tile: Tile<'_, R>) -> bool {
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
        let dt = self.dt;
        if cfg!(feature = "compact") {
            tile.fresh();
            let ([x, y, z], [u, v, w], [x_a, y_a, z_a]) = (x, v, tile.below);
            let update = if EXPLICIT { R::Loops::update_explicitly } else { R::Loops::update_semi_implicitly };
            let finite = update(Along { dt, x, v: u, a: x_a, next: x_next });
            let finite = update(Along { dt, x: y, v, a: y_a, next: y_next }) & finite;
            return update(Along { dt, x: z, v: w, a: z_a, next: z_next }) & finite;
        }
        let particles = Particles { is_explicit: EXPLICIT, dt, x, v, rest: tile.rest };
        R::Loops::update_all(particles, tile.below, [x_next, y_next, z_next])
    }
}

impl<R: Real, const EXPLICIT: bool> Follow<R> for Update<'_, R, EXPLICIT> {
    fn split(self, slot: u32) -> (Self, Self) {
        let (lower, upper) = self.next_position.split(slot - self.first);
        let (lower_residual, upper_residual) = split(self.velocity_residual, slot - self.first);
        (
            Self { next_position: lower, velocity_residual: lower_residual, ..self },
            Self { next_position: upper, velocity_residual: upper_residual, first: slot, ..self },
        )
    }
}

/// One axis of a tile's particles, for programs that are to be compact.
pub struct Along<'a, R> {
    dt: R,
    x: &'a [R],
    v: &'a [R],
    /// Accelerations, and then the next velocities in their place.
    a: &'a mut [R],
    /// The next positions.
    next: &'a mut [R],
}

impl<R: Real> Along<'_, R> {
    /// Returns whether what is written is finite.
    #[inline(always)]
    pub fn update<const EXPLICIT: bool>(self) -> bool {
        let Self { dt, x, v, a, next } = self;
        let mut infinite = 0;
        for ((a, next), (x, v)) in a.iter_mut().zip(next).zip(x.iter().zip(v)) {
            let velocity = *v + dt * *a;
            *next = *x + dt * if EXPLICIT { *v } else { velocity };
            *a = velocity;
            infinite |= u32::from(!next.is_finite()) | u32::from(EXPLICIT && !velocity.is_finite());
        }
        infinite == 0
    }
}

/// What a tile's particles are to be updated from, but for the forces from below.
pub struct Particles<'a, R> {
    is_explicit: bool,
    dt: R,
    x: Columns<'a, R>,
    v: Columns<'a, R>,
    rest: Rest<'a, R>,
}

impl<R: Real> Particles<'_, R> {
    /// Writes the next velocities in place of the forces from below, and the next positions. Returns whether they are
    /// finite.
    #[inline(always)]
    pub fn update(self, [x, y, z]: ColumnsMut<'_, R>, [x_next, y_next, z_next]: ColumnsMut<'_, R>) -> bool {
        lanes::run_on_six(self.rest.lanes, self, x, y, z, x_next, y_next, z_next)
    }

    #[inline(always)]
    fn by<A: Rule<R>>(self, rule: A, below: ColumnsMut<'_, R>, next: ColumnsMut<'_, R>) -> bool {
        if self.is_explicit {
            self.each::<A, true>(rule, below, next)
        } else {
            self.each::<A, false>(rule, below, next)
        }
    }

    #[inline(always)]
    fn each<A: Rule<R>, const EXPLICIT: bool>(
        self,
        rule: A,
        below: ColumnsMut<'_, R>,
        next: ColumnsMut<'_, R>,
    ) -> bool {
        let Self { dt, x, v, rest, .. } = self;
        let written = triples_mut(below).zip(triples_mut(next));
        let mut infinite = 0;
        for (((below, next), acceleration), (x, v)) in
            written.zip(rest.accelerations(rule)).zip(triples(x).zip(triples(v)))
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

impl<R: Real> SixColumns<R> for Particles<'_, R> {
    type Output = bool;

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
        let (below, next) = ([x_below, y_below, z_below], [x_next, y_next, z_next]);
        match self.rest.origin {
            Origin::Pulled => self.by(Pulled, below, next),
            Origin::Falling => self.by(Falling, below, next),
            Origin::Known => self.by(Known, below, next),
        }
    }
}
