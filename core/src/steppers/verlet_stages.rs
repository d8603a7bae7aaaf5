//! What velocity Verlet does before and after the forces, particle by particle.

use core::ops::Range;

use crate::Real;
use crate::lanes::{self, Kernel, Lanes, Set};
use crate::shared::Divisible;
use crate::vectors::{Columns, ColumnsMut, cut, split};

/// x' = x + dt·(v + ½dt·a), and the velocity that is to be expected there, v + dt·a. Tells whether x' is finite.
pub struct Drift<'a, R> {
    pub lanes: Lanes,
    /// s
    pub dt: R,
    /// The slots that are written to.
    pub slots: Range<u32>,
    pub position: Columns<'a, R>,
    pub velocity: Columns<'a, R>,
    pub acceleration: Columns<'a, R>,
    /// Of these slots.
    pub next_position: ColumnsMut<'a, R>,
    /// Of these slots.
    pub predicted: ColumnsMut<'a, R>,
}

impl<R: Real> Kernel for Drift<'_, R> {
    /// Whether what is written is finite.
    type Output = Option<bool>;

    #[inline(always)]
    fn run(self, _set: impl Set) -> Option<bool> {
        let Self { dt, slots, position, velocity, acceleration, next_position, predicted, .. } = self;
        let half = R::from_f64(0.5) * dt;
        let state = cut(position, slots.clone())?.into_iter().zip(cut(velocity, slots.clone())?);
        let columns = next_position.into_iter().zip(predicted).zip(state.zip(cut(acceleration, slots)?));
        let mut infinite = 0;
        for ((next, predicted), ((x, v), a)) in columns {
            for ((next, predicted), ((x, v), a)) in next.iter_mut().zip(predicted).zip(x.iter().zip(v).zip(a)) {
                *next = *x + dt * (*v + half * *a);
                *predicted = *v + dt * *a;
                infinite |= u32::from(!next.is_finite());
            }
        }
        Some(infinite == 0)
    }
}

impl<R: Real> Divisible for Drift<'_, R> {
    type Outcome = bool;

    fn slots(&self) -> Range<u32> {
        self.slots.clone()
    }

    fn halves(self, slot: u32) -> (Self, Self) {
        let (lower, upper) = split(self.next_position, slot - self.slots.start);
        let (lower_predicted, upper_predicted) = split(self.predicted, slot - self.slots.start);
        (
            Self { slots: self.slots.start..slot, next_position: lower, predicted: lower_predicted, ..self },
            Self { slots: slot..self.slots.end, next_position: upper, predicted: upper_predicted, ..self },
        )
    }

    fn alone(self) -> bool {
        lanes::run(self.lanes, self).unwrap_or_default()
    }

    fn joined(first: bool, second: bool) -> bool {
        first && second
    }
}

/// v' = v + ½dt·(a + a'). Tells whether it is finite.
pub struct Kick<'a, R> {
    pub lanes: Lanes,
    /// s
    pub dt: R,
    /// The slots that are written to.
    pub slots: Range<u32>,
    pub velocity: Columns<'a, R>,
    pub acceleration: Columns<'a, R>,
    pub next_acceleration: Columns<'a, R>,
    /// Of these slots.
    pub next_velocity: ColumnsMut<'a, R>,
}

impl<R: Real> Kernel for Kick<'_, R> {
    /// Whether what is written is finite.
    type Output = Option<bool>;

    #[inline(always)]
    fn run(self, _set: impl Set) -> Option<bool> {
        let Self { dt, slots, velocity, acceleration, next_acceleration, next_velocity, .. } = self;
        let half = R::from_f64(0.5) * dt;
        let accelerations = cut(acceleration, slots.clone())?.into_iter().zip(cut(next_acceleration, slots.clone())?);
        let mut infinite = 0;
        for (next, (v, (a, next_a))) in
            next_velocity.into_iter().zip(cut(velocity, slots)?.into_iter().zip(accelerations))
        {
            for ((next, v), (a, next_a)) in next.iter_mut().zip(v).zip(a.iter().zip(next_a)) {
                *next = *v + half * (*a + *next_a);
                infinite |= u32::from(!next.is_finite());
            }
        }
        Some(infinite == 0)
    }
}

impl<R: Real> Divisible for Kick<'_, R> {
    type Outcome = bool;

    fn slots(&self) -> Range<u32> {
        self.slots.clone()
    }

    fn halves(self, slot: u32) -> (Self, Self) {
        let (lower, upper) = split(self.next_velocity, slot - self.slots.start);
        (
            Self { slots: self.slots.start..slot, next_velocity: lower, ..self },
            Self { slots: slot..self.slots.end, next_velocity: upper, ..self },
        )
    }

    fn alone(self) -> bool {
        lanes::run(self.lanes, self).unwrap_or_default()
    }

    fn joined(first: bool, second: bool) -> bool {
        first && second
    }
}
