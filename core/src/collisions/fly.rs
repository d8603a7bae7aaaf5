//! Particles in free flight: first the events of those that have any, then all of them from their last events on.

use core::ops::Range;

use super::due::{BLOCK, Due};
use super::events::{Events, half};
use crate::Real;
use crate::lanes::Kernel;
use crate::vectors::{at, lend, read, store, window, window_mut};
use crate::world::{State, System};

/// Particles whose columns are gone through one after the other: few enough for a cache.
const TILE: u32 = 256;

/// Writes the states of all particles in free flight at a time.
pub struct Fly<'a, R: Real> {
    pub system: &'a System<'a, R>,
    /// s
    pub time: f64,
    /// Up to then, once this has run.
    pub events: Events<'a, R>,
    /// Theirs alone.
    pub next: State<'a, R>,
}

/// What happened on the way.
#[derive(Clone, Copy, Debug, Default)]
pub struct Flown {
    /// The kinetic energy lost up to the last events, J.
    pub lost: f64,
    /// That lost since, J.
    pub pending: f64,
    /// Bounces.
    pub hits: u32,
    /// Particles that had too many of them.
    pub capped: u32,
}

impl<R: Real> Kernel for Fly<'_, R> {
    type Output = Flown;

    #[inline(always)]
    fn run(mut self) -> Flown {
        let mut flown = Flown::default();
        self.pass(&mut flown);
        self.coast();
        self.settle(&mut flown);
        flown
    }
}

impl<R: Real> Fly<'_, R> {
    /// Passes all that is due.
    #[inline(always)]
    fn pass(&mut self, flown: &mut Flown) {
        let mut due = Due::NOTHING;
        let mut block = 0;
        while (block as usize) < self.events.earliest.len() {
            block = due.list(&mut self.events, block, self.time);
            self.events.pass_together(self.system, &mut due, self.time);
            for (index, bounces) in due.each() {
                if self.events.due(index) <= self.time {
                    self.events.pass_until(self.system, index, self.time, bounces);
                }
            }
            let Some(mut events) = self.events.lend() else { return };
            for (index, bounces) in due.each() {
                flown.lost += at(self.system.mass, self.system.plan.attached + index).to_f64() * bounces.lost;
                flown.hits = flown.hits.saturating_add(bounces.hits);
                flown.capped = flown.capped.saturating_add(u32::from(bounces.capped));
                events.expect(index);
            }
        }
    }

    /// The states of all, from the last events on.
    #[inline(always)]
    fn coast(&mut self) {
        let free = self.system.plan.free();
        let mut room = [R::ZERO; TILE as usize];
        let mut start = 0;
        while start < free {
            let tile = start..start.saturating_add(TILE).min(free);
            start = tile.end;
            self.coast_tile(tile, &mut room);
        }
    }

    #[inline(always)]
    fn coast_tile(&mut self, tile: Range<u32>, room: &mut [R; TILE as usize]) {
        let [since] = window([&*self.events.since], tile.clone());
        for (elapsed, since) in room.iter_mut().zip(since) {
            *elapsed = R::from_f64(self.time - *since);
        }
        let position = window(read(&self.events.position), tile.clone());
        let velocity = window(read(&self.events.velocity), tile.clone());
        let acceleration = window(read(&self.events.acceleration), tile.clone());
        let next_position = window_mut(lend(&mut self.next.position), tile.clone());
        let next_velocity = window_mut(lend(&mut self.next.velocity), tile);
        let axes = position.into_iter().zip(velocity).zip(next_position).zip(next_velocity);
        let accelerations = acceleration.into_iter().zip(*self.events.uniform).zip(self.system.gravity);
        for ((((x, v), next_x), next_v), ((a, uniform), gravity)) in axes.zip(accelerations) {
            if uniform {
                coast(room, x, v, core::iter::repeat(&gravity), next_x, next_v);
            } else {
                coast(room, x, v, a, next_x, next_v);
            }
        }
    }

    /// The states of those that are about to come to rest: nothing else is due still.
    #[inline(always)]
    fn settle(&mut self, flown: &mut Flown) {
        for block in 0..self.events.earliest.len() as u32 {
            if at(self.events.earliest, block) <= self.time {
                let start = block * BLOCK as u32;
                let end = start.saturating_add(BLOCK as u32).min(self.system.plan.free());
                (start..end).for_each(|index| self.settle_one(index, flown));
            }
        }
    }

    fn settle_one(&mut self, index: u32, flown: &mut Flown) {
        let Some((flight, lost)) = self.events.settling(self.system, index, self.time) else { return };
        store(&mut self.next.position, index, flight.position);
        store(&mut self.next.velocity, index, flight.velocity);
        flown.pending += at(self.system.mass, self.system.plan.attached + index).to_f64() * lost;
    }
}

/// x' = x + τ (v + ½τ a), v' = v + τ a: one axis of [`Flight::after`](super::bounce::Flight::after).
#[inline(always)]
fn coast<'a, R: Real>(
    elapsed: &[R],
    x: &[R],
    v: &[R],
    a: impl IntoIterator<Item = &'a R>,
    next_x: &mut [R],
    next_v: &mut [R],
) {
    for ((tau, (next_x, next_v)), ((x, v), a)) in
        elapsed.iter().zip(next_x.iter_mut().zip(next_v)).zip(x.iter().zip(v).zip(a))
    {
        *next_x = *x + *tau * (*v + half::<R>() * *tau * *a);
        *next_v = *v + *tau * *a;
    }
}
