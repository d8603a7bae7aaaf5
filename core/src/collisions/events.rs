//! The last event of each particle in free flight, and the next one: an impact, or the end of all impacts.

use super::bounce::{Bounces, Flight, MOST_BOUNCES, Path, half_square};
use crate::Real;
use crate::vectors::{ColumnsMut, at, dot, fetch, put, read, store};
use crate::world::{System, View};

/// Bounces that would all end within this time, in s, are summed when the first of them comes. The sum is exact at
/// any value; this one decides only when it is taken, and does not depend on the times that are asked for, so that
/// neither do the results.
pub const SETTLING_TIME: f64 = 1e-3;

/// No bounce to come.
const NEVER: f64 = f64::INFINITY;

/// Marks the plane on which a particle comes to rest at its next event.
pub const SETTLES: u32 = 1 << 31;

/// Of each particle in free flight.
pub struct Events<'a, R> {
    /// At the last event, m.
    pub position: ColumnsMut<'a, R>,
    /// Right after it, m/s.
    pub velocity: ColumnsMut<'a, R>,
    /// From then on, m/s²: what planes that it lies on leave of gravity.
    pub acceleration: ColumnsMut<'a, R>,
    /// When the last event was, s.
    pub since: &'a mut [f64],
    /// How long after that the next one will be, s.
    pub tau: &'a mut [f64],
    /// From when on the three above do not tell its state any more, s.
    pub due: &'a mut [f64],
    /// The plane of the next event; with [`SETTLES`] added, that on which it comes to rest then.
    pub plane: &'a mut [u32],
}

impl<R: Real> Events<'_, R> {
    /// All flights begin from the current state, at the time `now`.
    pub fn begin(&mut self, view: &View<'_, R>, now: f64) {
        for index in 0..view.system.plan.free() {
            let slot = view.system.plan.attached + index;
            let flight = Flight {
                position: fetch(read(&view.current.position), slot),
                velocity: fetch(read(&view.current.velocity), slot),
            };
            self.set(&Path::of(&view.system, slot, half()), index, flight, now);
        }
    }

    /// Passes the events of a particle up to a time, after the `bounces` that it has had on the way there.
    // One copy of it serves all lanes.
    #[inline(never)]
    pub fn pass_until(&mut self, system: &System<'_, R>, index: u32, time: f64, bounces: &mut Bounces) {
        let path = Path::of(system, system.plan.attached + index, half());
        while at(self.since, index) + at(self.tau, index) <= time {
            if bounces.hits == MOST_BOUNCES {
                bounces.capped = true;
                let mut stopped = self.last(index);
                bounces.lost += path.stop(&mut stopped);
                // It stays there until then: nobody has looked what it would meet on the way.
                self.set(&path, index, stopped, time);
                break;
            }
            self.pass_event(&path, index, bounces);
        }
    }

    /// The state at a time of a particle that is about to come to rest, and the energy lost since its last event, over
    /// the mass. Nothing of any other.
    pub fn settling(&self, system: &System<'_, R>, index: u32, time: f64) -> Option<(Flight<R>, f64)> {
        if at(self.plane, index) & SETTLES == 0 {
            return None;
        }
        let path = Path::of(system, system.plan.attached + index, half());
        let mut flight = self.last(index);
        let later = path.fly(&mut flight, R::from_f64(time - at(self.since, index)));
        Some((flight, later.lost))
    }

    /// Records an event, and finds the next one.
    fn set(&mut self, path: &Path<'_, R>, index: u32, flight: Flight<R>, now: f64) {
        let a = path.acceleration(&flight);
        let next = path.next_hit(&flight, a).map(|(tau, _, plane)| (tau, plane));
        self.record(index, flight, a, now, next);
    }

    /// Records an event, and the next one: how long after it, and on which plane.
    #[inline(always)]
    pub fn record(&mut self, index: u32, flight: Flight<R>, a: [R; 3], now: f64, next: Option<(R, u32)>) {
        store(&mut self.position, index, flight.position);
        store(&mut self.velocity, index, flight.velocity);
        store(&mut self.acceleration, index, a);
        put(self.since, index, now);
        let (tau, plane) = next.map_or((NEVER, 0), |(tau, plane)| (tau.to_f64(), plane));
        put(self.tau, index, tau);
        put(self.due, index, now + tau);
        put(self.plane, index, plane);
    }

    #[inline(always)]
    pub fn last(&self, index: u32) -> Flight<R> {
        Flight { position: fetch(read(&self.position), index), velocity: fetch(read(&self.velocity), index) }
    }

    /// The next event becomes the last one.
    fn pass_event(&mut self, path: &Path<'_, R>, index: u32, bounces: &mut Bounces) {
        // Not the difference of two times: late in a long run those are known less well than the flight between them.
        let tau = at(self.tau, index);
        let elapsed = R::from_f64(tau);
        let until = at(self.since, index) + tau;
        let mut flight = self.last(index);
        let named = at(self.plane, index);
        let Some(plane) = path.planes.get((named & !SETTLES) as usize) else {
            put(self.tau, index, NEVER);
            put(self.due, index, NEVER);
            return;
        };
        if named & SETTLES != 0 {
            let speed = dot(plane.normal, flight.velocity);
            bounces.lost += half_square(speed);
            path.settle(&mut flight, plane, elapsed);
            bounces.lost += path.calm(&mut flight);
            self.set(path, index, flight, until);
            return;
        }
        let (speed, impact) = path.impact(&flight, elapsed, plane, fetch(read(&self.acceleration), index));
        flight = impact;
        let away = plane.restitution * speed;
        bounces.hits += 1;
        bounces.lost += half_square(speed) - half_square(away);
        flight.put_on(plane, away);
        bounces.lost += path.calm(&mut flight);
        let settling = path
            .settling_time(plane, speed)
            .filter(|settling| settling.to_f64() <= SETTLING_TIME && path.is_alone(&flight, plane, *settling));
        self.set(path, index, flight, until);
        if let Some(settling) = settling {
            put(self.tau, index, settling.to_f64());
            put(self.plane, index, named | SETTLES);
            // It bounces all the time until then.
            put(self.due, index, until);
        }
    }
}

/// β of the exact path.
pub fn half<R: Real>() -> R {
    R::from_f64(0.5)
}
