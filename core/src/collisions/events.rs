//! The last event of each particle in free flight, and the next one: an impact, or the end of all impacts.

use super::bounce::{Bounces, Flight, MOST_BOUNCES, Path, half_square};
use super::due::BLOCK;
use crate::Real;
use crate::vectors::{ColumnsMut, at, cut_mut, dot, fetch, lend, put, read, window};
use crate::world::{System, View};

/// Bounces that would all end within this time, in s, are summed when the first of them comes. The sum is exact at
/// any value; this one decides only when it is taken, and does not depend on the times that are asked for, so that
/// neither do the results.
pub const SETTLING_TIME: f64 = 1e-3;

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
    /// Along which axes that is gravity's for every particle: nobody need read it.
    pub uniform: &'a mut [bool; 3],
    /// Along which axes nothing moves, nor can be made to: what is written of them stays.
    pub still: &'a mut [bool; 3],
    /// When the last event was, s.
    pub since: &'a mut [f64],
    /// How long after that the next one will be, s; infinite if there is none, and with its sign changed for a particle
    /// that [`SETTLES`] then: it bounces all the time until then.
    pub tau: &'a mut [R],
    /// The plane of the next event; with [`SETTLES`] added, that on which it comes to rest then.
    pub plane: &'a mut [u32],
    /// Of each block of particles, when the first is due, s.
    pub earliest: &'a mut [f64],
}

impl<R: Real> Events<'_, R> {
    /// All flights begin from the current state, at the time `now`.
    pub fn begin(&mut self, view: &View<'_, R>, now: f64) {
        *self.uniform = [true; 3];
        // What the flights begin from is recorded along all axes.
        *self.still = [false; 3];
        for index in 0..view.system.plan.free() {
            let slot = view.system.plan.attached + index;
            let flight = Flight {
                position: fetch(read(&view.current.position), slot),
                velocity: fetch(read(&view.current.velocity), slot),
            };
            self.set(&view.system, &Path::of(&view.system, slot, half()), index, flight, now);
        }
        *self.still = still(view);
        // Each block is looked at before the next state is written.
        self.earliest.fill(now);
    }

    /// The same columns, lent to one loop: here the compiler knows that they are of one length, and that nothing else
    /// changes where they are.
    #[inline(always)]
    pub fn lend(&mut self) -> Option<Events<'_, R>> {
        let all = 0..self.plane.len() as u32;
        let items = 0..self.plane.len();
        Some(Events {
            position: cut_mut(lend(&mut self.position), all.clone())?,
            velocity: cut_mut(lend(&mut self.velocity), all.clone())?,
            acceleration: cut_mut(lend(&mut self.acceleration), all)?,
            uniform: self.uniform,
            still: self.still,
            since: self.since.get_mut(items.clone())?,
            tau: self.tau.get_mut(items.clone())?,
            plane: self.plane.get_mut(items)?,
            earliest: self.earliest,
        })
    }

    /// From when on the columns above do not tell a particle's state any more, s.
    #[inline(always)]
    pub fn due(&self, index: u32) -> f64 {
        at(self.since, index) + at(self.tau, index).to_f64()
    }

    /// Has a particle count for when the first of its block is due.
    #[inline(always)]
    pub fn foresee(&mut self, index: u32) {
        let due = self.due(index);
        if let Some(earliest) = self.earliest.get_mut(index as usize / BLOCK) {
            *earliest = earliest.at_most(due);
        }
    }

    /// Passes the events of a particle up to a time, after the `bounces` that it has had on the way there.
    // One copy of it serves all lanes.
    #[inline(never)]
    pub fn pass_until(&mut self, system: &System<'_, R>, index: u32, time: f64, bounces: &mut Bounces) {
        let path = Path::of_dynamic(system, half());
        while at(self.since, index) + at(self.tau, index).abs().to_f64() <= time {
            if bounces.hits == MOST_BOUNCES {
                bounces.capped = true;
                let mut stopped = self.last(index);
                bounces.lost += path.stop(&mut stopped);
                // It stays there until then: nobody has looked what it would meet on the way.
                self.set(system, &path, index, stopped, time);
                break;
            }
            self.pass_event(system, &path, index, bounces);
        }
    }

    /// The state at a time of a particle that is about to come to rest, and the energy lost since its last event, over
    /// the mass. Nothing of any other.
    pub fn settling(&self, system: &System<'_, R>, index: u32, time: f64) -> Option<(Flight<R>, f64)> {
        if at(self.plane, index) & SETTLES == 0 {
            return None;
        }
        let path = Path::of_dynamic(system, half());
        let mut flight = self.last(index);
        let later = path.fly(&mut flight, R::from_f64(time - at(self.since, index)));
        Some((flight, later.lost))
    }

    /// Records an event, and finds the next one.
    fn set(&mut self, system: &System<'_, R>, path: &Path<'_, R>, index: u32, flight: Flight<R>, now: f64) {
        let a = path.acceleration(&flight);
        let (tau, plane) = path.next_hit(&flight, a).map_or((R::INFINITY, 0), |(tau, _, plane)| (tau, plane));
        self.set_acceleration(index, a, system.gravity);
        self.record(index, flight, now, tau, plane);
    }

    fn set_acceleration(&mut self, index: u32, a: [R; 3], gravity: [R; 3]) {
        let columns = self.acceleration.iter_mut().zip(self.uniform.iter_mut());
        for ((column, uniform), (a, gravity)) in columns.zip(a.into_iter().zip(gravity)) {
            // 0 and −0 are the same one here, whether it is read or not.
            put(column, index, if a == gravity { gravity } else { a });
            *uniform &= a == gravity;
        }
    }

    /// Records an event but for the acceleration after it, and the next one: how long after it, and on which plane.
    #[inline(always)]
    pub fn record(&mut self, index: u32, flight: Flight<R>, now: f64, tau: R, plane: u32) {
        let columns = self.position.iter_mut().zip(&mut self.velocity).zip(&*self.still);
        for (((position, velocity), still), (x, v)) in columns.zip(flight.position.into_iter().zip(flight.velocity)) {
            if !still {
                put(position, index, x);
                put(velocity, index, v);
            }
        }
        put(self.since, index, now);
        put(self.tau, index, tau);
        put(self.plane, index, plane);
    }

    #[inline(always)]
    pub fn last(&self, index: u32) -> Flight<R> {
        Flight { position: fetch(read(&self.position), index), velocity: fetch(read(&self.velocity), index) }
    }

    /// The next event becomes the last one.
    fn pass_event(&mut self, system: &System<'_, R>, path: &Path<'_, R>, index: u32, bounces: &mut Bounces) {
        // Not the difference of two times: late in a long run those are known less well than the flight between them.
        let elapsed = at(self.tau, index).abs();
        let until = at(self.since, index) + elapsed.to_f64();
        let mut flight = self.last(index);
        let named = at(self.plane, index);
        let Some(plane) = path.planes.get((named & !SETTLES) as usize) else {
            put(self.tau, index, R::INFINITY);
            return;
        };
        if named & SETTLES != 0 {
            let speed = dot(plane.normal, flight.velocity);
            bounces.lost += half_square(speed);
            path.settle(&mut flight, plane, elapsed);
            bounces.lost += path.calm(&mut flight);
            self.set(system, path, index, flight, until);
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
        self.set(system, path, index, flight, until);
        if let Some(settling) = settling {
            put(self.tau, index, -settling);
            put(self.plane, index, named | SETTLES);
        }
    }
}

/// Along which axes no particle in free flight moves, gravity pulls at none and no plane can throw one back.
///
/// Zeros are told by their signs: whatever zero is added to what this finds, the bits stay.
fn still<R: Real>(view: &View<'_, R>) -> [bool; 3] {
    let slots = view.system.plan.attached..view.system.plan.particles;
    let position = window(read(&view.current.position), slots.clone());
    let velocity = window(read(&view.current.velocity), slots);
    let mut still = view.system.gravity.map(|gravity| gravity == R::ZERO);
    for plane in view.system.planes {
        for (still, normal) in still.iter_mut().zip(plane.normal) {
            *still &= normal == R::ZERO;
        }
    }
    for (still, (x, v)) in still.iter_mut().zip(position.into_iter().zip(velocity)) {
        let rests = |v: &R| v.to_f64().to_bits() == 0.0_f64.to_bits();
        let keeps = |x: &R| x.to_f64().to_bits() != (-0.0_f64).to_bits();
        *still = *still && v.iter().all(rests) && x.iter().all(keeps);
    }
    still
}

/// β of the exact path.
pub fn half<R: Real>() -> R {
    R::from_f64(0.5)
}
