//! Particles that no spring pulls at, flown exactly from plane to plane: no stepping between the times that are asked
//! for and the bounces there are.

use super::bounce::{Bounces, Flight, MOST_BOUNCES, Path, half_square};
use crate::Real;
use crate::types::{Full, StepReport};
use crate::vectors::{ColumnsMut, at, dot, fetch, put, read, store};
use crate::world::{Column, Plan, Storage, System, View};

/// Bounces that would all end within this time, in s, are summed when the first of them comes. The sum is exact at
/// any value; this one decides only when it is taken, and does not depend on the times that are asked for, so that
/// neither do the results.
const SETTLING_TIME: f64 = 1e-3;

/// No bounce to come.
const NEVER: f64 = f64::INFINITY;

/// The last event of every particle in free flight, and the next one: 6 reals and 20 bytes a particle.
///
/// A state at any time is worked out from the last event at once, so it does not depend on the times asked for before.
pub struct Flights<R: Real, M: Storage> {
    position: [M::Particles<R>; 3],
    velocity: [M::Particles<R>; 3],
    /// When the last event was, s.
    since: M::Particles<f64>,
    /// How long after that the next one will be, s.
    tau: M::Particles<f64>,
    /// The plane of the next one; with [`SETTLES`] added, that on which it comes to rest then.
    plane: M::Particles<u32>,
    /// The state that they were flown to last: its time, and how often it had been changed from outside.
    belongs: (f64, u64),
    /// The kinetic energy lost up to the last events, J.
    lost: f64,
    /// The same up to the time last asked for.
    told: f64,
    /// The latest time asked for, s: events have been passed up to then.
    latest: f64,
    /// Bounces on the way there that no step has reported yet, and the particles that had too many.
    unreported: [u32; 2],
}

/// Marks the plane on which a particle comes to rest at its next event.
const SETTLES: u32 = 1 << 31;

/// The columns of [`Flights`] as slices.
struct Events<'a, R> {
    position: ColumnsMut<'a, R>,
    velocity: ColumnsMut<'a, R>,
    since: &'a mut [f64],
    tau: &'a mut [f64],
    plane: &'a mut [u32],
}

impl<R: Real, M: Storage> Flights<R, M> {
    /// Without any particles yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            position: [const { Column::EMPTY }; 3],
            velocity: [const { Column::EMPTY }; 3],
            since: Column::EMPTY,
            tau: Column::EMPTY,
            plane: Column::EMPTY,
            belongs: (f64::NAN, 0),
            lost: 0.0,
            told: 0.0,
            latest: f64::NAN,
            unreported: [0; 2],
        }
    }

    pub(crate) fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        let free = plan.free() as usize;
        self.position.iter_mut().chain(&mut self.velocity).try_for_each(|column| column.fit(free))?;
        self.since.fit(free)?;
        self.tau.fit(free)?;
        self.plane.fit(free)
    }

    /// Writes the states at the end of the step to the view's next state, given that its current state, as far as
    /// particles in free flight go, is that at the time `from`. Returns the kinetic energy lost on the way.
    pub(crate) fn fly(&mut self, view: &mut View<'_, R>, from: f64, report: &mut StepReport) -> f64 {
        let to = view.end.seconds();
        if self.belongs != (from, view.changes) || self.latest > to {
            // It is not the state that they came to, or they have been followed too far.
            self.begin(view, from);
        }
        self.belongs = (to, view.changes);
        let pending = self.write(view, to);
        let [hits, capped] = core::mem::take(&mut self.unreported);
        report.hits = report.hits.saturating_add(hits);
        report.capped = report.capped.saturating_add(capped);
        let lost = self.lost + pending - self.told;
        self.told = self.lost + pending;
        lost
    }

    /// Writes the states at a `time` before the end of the next step to the view's next state; false where they have
    /// not been flown to the current one, or it is past. What happens and what is lost by then is told with that step.
    ///
    /// Asked for times that go back, or beyond the end of the next step, all flights begin anew from the current state.
    pub(crate) fn look_ahead(&mut self, view: &mut View<'_, R>, time: f64) -> bool {
        let now = view.time();
        if self.belongs != (now, view.changes) || !(time >= now && time.is_finite()) {
            return false;
        }
        if self.latest > time {
            self.begin(view, now);
        }
        self.write(view, time);
        true
    }

    /// All flights begin anew from the current state, at the time `now`.
    fn begin(&mut self, view: &View<'_, R>, now: f64) {
        self.events().begin(view, now);
        (self.lost, self.told) = (0.0, 0.0);
        self.unreported = [0; 2];
    }

    /// Writes the states at a time, and returns the energy lost since the last events before it.
    fn write(&mut self, view: &mut View<'_, R>, time: f64) -> f64 {
        self.latest = time;
        let mut lost = 0.0;
        let mut pending = 0.0;
        let [mut hits, mut capped] = self.unreported;
        let mut events = self.events();
        for index in 0..view.system.plan.free() {
            let slot = view.system.plan.attached + index;
            let (flight, bounces, unfinished) = events.state_at(&view.system, index, slot, time);
            store(&mut view.next.position, slot, flight.position);
            store(&mut view.next.velocity, slot, flight.velocity);
            let mass = at(view.system.mass, slot).to_f64();
            lost += mass * bounces.lost;
            pending += mass * unfinished;
            hits = hits.saturating_add(bounces.hits);
            capped = capped.saturating_add(u32::from(bounces.capped));
        }
        self.unreported = [hits, capped];
        self.lost += lost;
        pending
    }

    fn events(&mut self) -> Events<'_, R> {
        Events {
            position: self.position.each_mut().map(Column::items_mut),
            velocity: self.velocity.each_mut().map(Column::items_mut),
            since: self.since.items_mut(),
            tau: self.tau.items_mut(),
            plane: self.plane.items_mut(),
        }
    }
}

impl<R: Real, M: Storage> Default for Flights<R, M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real> Events<'_, R> {
    fn begin(&mut self, view: &View<'_, R>, now: f64) {
        for index in 0..view.system.plan.free() {
            let slot = view.system.plan.attached + index;
            let flight = Flight {
                position: fetch(read(&view.current.position), slot),
                velocity: fetch(read(&view.current.velocity), slot),
            };
            self.set(&Path::of(&view.system, slot, half()), index, flight, now);
        }
    }

    /// Records an event, and finds the next one.
    fn set(&mut self, path: &Path<'_, R>, index: u32, flight: Flight<R>, now: f64) {
        store(&mut self.position, index, flight.position);
        store(&mut self.velocity, index, flight.velocity);
        put(self.since, index, now);
        let next = path.next_hit(&flight, path.acceleration(&flight));
        let (tau, plane) = next.map_or((NEVER, 0), |(tau, _, plane)| (tau.to_f64(), plane));
        put(self.tau, index, tau);
        put(self.plane, index, plane);
    }

    /// The state at a time, the bounces up to the last event before it, and the energy lost after that, over the mass.
    fn state_at(&mut self, system: &System<'_, R>, index: u32, slot: u32, time: f64) -> (Flight<R>, Bounces, f64) {
        let path = Path::of(system, slot, half());
        let mut bounces = Bounces::default();
        while at(self.since, index) + at(self.tau, index) <= time {
            if bounces.hits == MOST_BOUNCES {
                bounces.capped = true;
                let mut stopped = self.last(index);
                bounces.lost += path.stop(&mut stopped);
                // It stays there until then: nobody has looked what it would meet on the way.
                self.set(&path, index, stopped, time);
                break;
            }
            self.pass_event(&path, index, &mut bounces);
        }
        let flight = self.last(index);
        let elapsed = R::from_f64(time - at(self.since, index));
        if at(self.plane, index) & SETTLES != 0 {
            let mut bouncing = flight;
            let later = path.fly(&mut bouncing, elapsed);
            return (bouncing, bounces, later.lost);
        }
        (flight.after(elapsed, path.acceleration(&flight), path.curvature), bounces, 0.0)
    }

    fn last(&self, index: u32) -> Flight<R> {
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
        let a = path.acceleration(&flight);
        let (speed, impact) = path.impact(&flight, elapsed, plane, a);
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
        }
    }
}

/// β of the exact path.
fn half<R: Real>() -> R {
    R::from_f64(0.5)
}
