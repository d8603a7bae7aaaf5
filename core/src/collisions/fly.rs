//! Particles in free flight, tile by tile: whole vectors of them where nothing happens, one by one where something does.

use core::ops::Range;

use super::bounce::Bounces;
use super::events::{Events, half};
use crate::Real;
use crate::lanes::Kernel;
use crate::vectors::{at, lend, read, store, window, window_mut};
use crate::world::{State, System};

/// Particles whose columns are gone through at once: enough that some have something due, few enough for a cache.
const TILE: u32 = 512;

/// Particles that are looked at together for whether any of them has something due.
const BLOCK: usize = 16;

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
    /// Whether the states are known to be finite.
    pub finite: bool,
}

impl<R: Real> Kernel for Fly<'_, R> {
    type Output = Flown;

    #[inline(always)]
    fn run(mut self) -> Flown {
        let mut flown = Flown { finite: true, ..Flown::default() };
        let free = self.system.plan.free();
        let mut start = 0;
        while start < free {
            let tile = start..start.saturating_add(TILE).min(free);
            start = tile.end;
            let mut room = [0; TILE as usize];
            let due = self.due(tile.clone(), &mut room);
            self.pass(due, &mut flown);
            flown.finite &= self.coast(tile);
            for index in due {
                self.settle(*index, &mut flown);
            }
        }
        flown
    }
}

impl<R: Real> Fly<'_, R> {
    /// The particles of a tile that have something due.
    #[inline(always)]
    fn due<'b>(&self, tile: Range<u32>, room: &'b mut [u32; TILE as usize]) -> &'b [u32] {
        let [due] = window([&*self.events.due], tile.clone());
        let mut found = 0;
        for (block, first) in due.chunks(BLOCK).zip((tile.start..).step_by(BLOCK)) {
            if !block.iter().fold(false, |any, due| any | (*due <= self.time)) {
                continue;
            }
            for (due, index) in block.iter().zip(first..) {
                // Without a branch that nothing foretells.
                if let Some(place) = room.get_mut(found) {
                    *place = index;
                }
                found += usize::from(*due <= self.time);
            }
        }
        room.get(..found).unwrap_or_default()
    }

    /// Passes what these have due.
    #[inline(always)]
    fn pass(&mut self, particles: &[u32], flown: &mut Flown) {
        if particles.is_empty() {
            return;
        }
        let mut bounces = [Bounces::default(); TILE as usize];
        self.events.pass_together(self.system, particles, self.time, &mut bounces);
        for (index, bounces) in particles.iter().zip(&mut bounces) {
            self.events.pass_until(self.system, *index, self.time, bounces);
            flown.lost += self.mass(*index) * bounces.lost;
            flown.hits = flown.hits.saturating_add(bounces.hits);
            flown.capped = flown.capped.saturating_add(u32::from(bounces.capped));
        }
    }

    fn settle(&mut self, index: u32, flown: &mut Flown) {
        let Some((flight, lost)) = self.events.settling(self.system, index, self.time) else { return };
        store(&mut self.next.position, index, flight.position);
        store(&mut self.next.velocity, index, flight.velocity);
        flown.finite &= flight.position.into_iter().chain(flight.velocity).all(R::is_finite);
        flown.pending += self.mass(index) * lost;
    }

    fn mass(&self, index: u32) -> f64 {
        at(self.system.mass, self.system.plan.attached + index).to_f64()
    }

    /// The states of a tile, from the last events on. Returns whether they are finite.
    #[inline(always)]
    fn coast(&mut self, tile: Range<u32>) -> bool {
        let mut room = [R::ZERO; TILE as usize];
        let [since] = window([&*self.events.since], tile.clone());
        for (elapsed, since) in room.iter_mut().zip(since) {
            *elapsed = R::from_f64(self.time - *since);
        }
        let position = window(read(&self.events.position), tile.clone());
        let velocity = window(read(&self.events.velocity), tile.clone());
        let acceleration = window(read(&self.events.acceleration), tile.clone());
        let next_position = window_mut(lend(&mut self.next.position), tile.clone());
        let next_velocity = window_mut(lend(&mut self.next.velocity), tile);
        let mut finite = true;
        for ((((x, v), a), next_x), next_v) in
            position.into_iter().zip(velocity).zip(acceleration).zip(next_position).zip(next_velocity)
        {
            finite &= coast(&room, x, v, a, next_x, next_v);
        }
        finite
    }
}

/// x' = x + τ (v + ½τ a), v' = v + τ a: one axis of [`Flight::after`](super::bounce::Flight::after). Returns whether
/// both are finite.
#[inline(always)]
fn coast<R: Real>(elapsed: &[R], x: &[R], v: &[R], a: &[R], next_x: &mut [R], next_v: &mut [R]) -> bool {
    let mut infinite = 0;
    for ((tau, (next_x, next_v)), (x, (v, a))) in
        elapsed.iter().zip(next_x.iter_mut().zip(next_v)).zip(x.iter().zip(v.iter().zip(a)))
    {
        *next_x = *x + *tau * (*v + half::<R>() * *tau * *a);
        *next_v = *v + *tau * *a;
        infinite |= u32::from(!next_x.is_finite()) | u32::from(!next_v.is_finite());
    }
    infinite == 0
}
