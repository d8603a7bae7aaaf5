//! What velocity Verlet does before and after the forces, particle by particle.

use core::ops::Range;

use crate::Real;
use crate::carried::{Carried, CarriedMut};
use crate::compiled::HotLoops;
use crate::lanes::{Kernel, Present, Set};
use crate::shared::Divisible;
use crate::vectors::{Columns, ColumnsMut, along, cut, scaled, set, split, triples, triples_mut};

/// x' = x + dt·(v + ½dt·a), and the velocity that is to be expected there, v + dt·a. Tells whether x' is finite.
pub struct Drift<'a, R: Real> {
    pub lanes: Present,
    /// s
    pub dt: R,
    /// The slots that are written to.
    pub slots: Range<u32>,
    pub position: Carried<'a, R>,
    pub velocity: Columns<'a, R>,
    pub acceleration: Columns<'a, R>,
    /// Of these slots.
    pub next_position: CarriedMut<'a, R>,
    /// Of these slots.
    pub predicted: ColumnsMut<'a, R>,
}

impl<R: Real> Drift<'_, R> {
    /// The same with the rounding of x' kept.
    fn carry(self) -> Option<bool> {
        let Self { lanes, dt, slots, position, velocity, acceleration, next_position, predicted } = self;
        let half = R::from_f64(0.5) * dt;
        let (v, a) = (cut(velocity, slots.clone())?, cut(acceleration, slots.clone())?);
        for (to, (v, a)) in triples_mut(predicted).zip(triples(v).zip(triples(a))) {
            set(to, along(v, dt, a));
        }
        let drifts = triples(v).zip(triples(a)).map(|(v, a)| move |_| scaled(dt, along(v, half, a)));
        Some(next_position.add(lanes, position.cut(slots)?, drifts))
    }
}

impl<R: Real> Kernel for Drift<'_, R> {
    /// Whether what is written is finite.
    type Output = Option<bool>;

    #[inline(always)]
    fn run(self, _set: impl Set) -> Option<bool> {
        let Self { dt, slots, position, velocity, acceleration, next_position, predicted, .. } = self;
        let state = cut(position.value, slots.clone())?.into_iter().zip(cut(velocity, slots.clone())?);
        let columns = next_position.value.into_iter().zip(predicted).zip(state.zip(cut(acceleration, slots)?));
        let mut finite = true;
        for (next, now) in columns {
            finite &= drift(dt, next, now);
        }
        Some(finite)
    }
}

/// Along one axis.
#[cfg_attr(feature = "compact", inline(never))]
#[cfg_attr(not(feature = "compact"), inline(always))]
fn drift<R: Real>(dt: R, (next, predicted): (&mut [R], &mut [R]), ((x, v), a): ((&[R], &[R]), &[R])) -> bool {
    let half = R::from_f64(0.5) * dt;
    let mut infinite = 0;
    for ((next, predicted), ((x, v), a)) in next.iter_mut().zip(predicted).zip(x.iter().zip(v).zip(a)) {
        *next = *x + dt * (*v + half * *a);
        *predicted = *v + dt * *a;
        infinite |= u32::from(!next.is_finite());
    }
    infinite == 0
}

impl<R: Real> Divisible for Drift<'_, R> {
    type Outcome = bool;

    fn slots(&self) -> Range<u32> {
        self.slots.clone()
    }

    fn halves(self, slot: u32) -> (Self, Self) {
        let (lower, upper) = self.next_position.split(slot - self.slots.start);
        let (lower_predicted, upper_predicted) = split(self.predicted, slot - self.slots.start);
        (
            Self { slots: self.slots.start..slot, next_position: lower, predicted: lower_predicted, ..self },
            Self { slots: slot..self.slots.end, next_position: upper, predicted: upper_predicted, ..self },
        )
    }

    fn alone(self) -> bool {
        let done = if R::IS_COMPENSATED { self.carry() } else { R::Loops::drift(self.lanes, self) };
        done.unwrap_or_default()
    }

    fn joined(first: bool, second: bool) -> bool {
        first && second
    }
}

/// v' = v + ½dt·(a + a'). Tells whether it is finite.
pub struct Kick<'a, R: Real> {
    pub lanes: Present,
    /// s
    pub dt: R,
    /// The slots that are written to.
    pub slots: Range<u32>,
    pub velocity: Carried<'a, R>,
    pub acceleration: Columns<'a, R>,
    pub next_acceleration: Columns<'a, R>,
    /// Of these slots.
    pub next_velocity: CarriedMut<'a, R>,
}

impl<R: Real> Kick<'_, R> {
    /// The same with its rounding kept.
    fn carry(self) -> Option<bool> {
        let Self { lanes, dt, slots, velocity, acceleration, next_acceleration, next_velocity } = self;
        let half = R::from_f64(0.5) * dt;
        let accelerations =
            triples(cut(acceleration, slots.clone())?).zip(triples(cut(next_acceleration, slots.clone())?));
        let impulses = accelerations.map(|(a, next)| move |_| scaled(half, along(a, R::ONE, next)));
        Some(next_velocity.add(lanes, velocity.cut(slots)?, impulses))
    }
}

impl<R: Real> Kernel for Kick<'_, R> {
    /// Whether what is written is finite.
    type Output = Option<bool>;

    #[inline(always)]
    fn run(self, _set: impl Set) -> Option<bool> {
        let Self { dt, slots, velocity, acceleration, next_acceleration, next_velocity, .. } = self;
        let accelerations = cut(acceleration, slots.clone())?.into_iter().zip(cut(next_acceleration, slots.clone())?);
        let columns = next_velocity.value.into_iter().zip(cut(velocity.value, slots)?.into_iter().zip(accelerations));
        let mut finite = true;
        for (next, now) in columns {
            finite &= kick(dt, next, now);
        }
        Some(finite)
    }
}

/// Along one axis.
#[cfg_attr(feature = "compact", inline(never))]
#[cfg_attr(not(feature = "compact"), inline(always))]
fn kick<R: Real>(dt: R, next: &mut [R], (v, (a, next_a)): (&[R], (&[R], &[R]))) -> bool {
    let half = R::from_f64(0.5) * dt;
    let mut infinite = 0;
    for ((next, v), (a, next_a)) in next.iter_mut().zip(v).zip(a.iter().zip(next_a)) {
        *next = *v + half * (*a + *next_a);
        infinite |= u32::from(!next.is_finite());
    }
    infinite == 0
}

impl<R: Real> Divisible for Kick<'_, R> {
    type Outcome = bool;

    fn slots(&self) -> Range<u32> {
        self.slots.clone()
    }

    fn halves(self, slot: u32) -> (Self, Self) {
        let (lower, upper) = self.next_velocity.split(slot - self.slots.start);
        (
            Self { slots: self.slots.start..slot, next_velocity: lower, ..self },
            Self { slots: slot..self.slots.end, next_velocity: upper, ..self },
        )
    }

    fn alone(self) -> bool {
        let done = if R::IS_COMPENSATED { self.carry() } else { R::Loops::kick(self.lanes, self) };
        done.unwrap_or_default()
    }

    fn joined(first: bool, second: bool) -> bool {
        first && second
    }
}
