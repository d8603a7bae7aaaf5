//! Particles that no spring pulls at, flown exactly from plane to plane: no stepping between the times that are asked
//! for and the bounces there are.

use super::coast::coast;
use super::due::{BLOCK, Due};
use super::events::Events;
use super::extent::Extent;
use super::pass::{Pass, settle};
use crate::types::{Full, StepReport};
use crate::world::{Column, Plan, State, Storage, View};
use crate::{Real, lanes};

/// The last event of every particle in free flight, and the next one: 10 reals and 20 bytes a particle, or 12 where
/// columns may be of different lengths, as on a heap.
///
/// A state at any time is worked out from the last event at once, so it does not depend on the times asked for before.
pub struct Flights<R: Real, M: Storage> {
    position: [M::Particles<R>; 3],
    velocity: [M::Particles<R>; 3],
    acceleration: [M::Particles<R>; 3],
    uniform: [bool; 3],
    still: [bool; 3],
    /// Which of the owner's two states hold what is still.
    holds_still: [bool; 2],
    /// The slot of the first of them when they were written last; nothing where that has not been since they began.
    first_slot: Option<u32>,
    since: M::Particles<f64>,
    tau: M::Particles<R>,
    plane: M::Particles<u32>,
    earliest: M::Particles<f64>,
    /// How far they can have come.
    extent: Extent,
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

impl<R: Real, M: Storage> Flights<R, M> {
    /// Without any particles yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            position: [const { Column::EMPTY }; 3],
            velocity: [const { Column::EMPTY }; 3],
            acceleration: [const { Column::EMPTY }; 3],
            uniform: [true; 3],
            still: [false; 3],
            holds_still: [false; 2],
            first_slot: None,
            since: Column::EMPTY,
            tau: Column::EMPTY,
            plane: Column::EMPTY,
            earliest: Column::EMPTY,
            extent: Extent::UNKNOWN,
            belongs: (f64::NAN, 0),
            lost: 0.0,
            told: 0.0,
            latest: f64::NAN,
            unreported: [0; 2],
        }
    }

    pub(crate) fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        let free = plan.free() as usize;
        let reals = self.position.iter_mut().chain(&mut self.velocity).chain(&mut self.acceleration);
        reals.into_iter().try_for_each(|column| column.fit(free))?;
        self.since.fit(free)?;
        self.tau.fit(free)?;
        self.plane.fit(free)?;
        self.earliest.fit(free.div_ceil(BLOCK))
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
        self.first_slot = None;
        self.extent = Extent::of(view, now);
        (self.lost, self.told) = (0.0, 0.0);
        self.unreported = [0; 2];
    }

    /// Writes the states at a time, and returns the energy lost since the last events before it.
    fn write(&mut self, view: &mut View<'_, R>, time: f64) -> f64 {
        self.latest = time;
        let system = &view.system;
        let [(_, position), (_, velocity)] =
            view.next.lend().apart().map(|columns| columns.split(system.plan.attached));
        let mut next = State::of([position, velocity]);
        // What is passed is looked at again right away, while it is in the caches.
        if self.first_slot.replace(system.plan.attached) != Some(system.plan.attached) {
            // Others have written the current state alone, or islands have fallen asleep: who was in whose slot has
            // changed then, and only the current state has followed.
            self.holds_still = [0, 1].map(|state| state == *view.front);
        }
        let axes = self.axes_to_write(*view.front ^ 1);
        let mut due = Due::NOTHING;
        let mut particles = 0..0;
        while particles.end < system.plan.free() {
            let block = particles.end / BLOCK as u32;
            let passed = lanes::run(system.lanes, Pass { system, time, events: self.events(), block, due: &mut due });
            particles = particles.end..passed.block.saturating_mul(BLOCK as u32).min(system.plan.free());
            coast(system, &self.events(), particles.clone(), time, axes, next.lend());
            self.lost += passed.lost;
            let [hits, capped] = &mut self.unreported;
            *hits = hits.saturating_add(passed.hits);
            *capped = capped.saturating_add(passed.capped);
        }
        let events = self.events();
        let pending = settle(system, &events, time, &mut next);
        view.is_next_finite = self.extent.is_finite_at::<R>(time);
        pending
    }

    /// Along which axes states are to be written to one of the owner's two.
    fn axes_to_write(&mut self, state: usize) -> [bool; 3] {
        let held = self.holds_still.get_mut(state).is_some_and(|held| core::mem::replace(held, true));
        self.still.map(|still| !(still && held))
    }

    fn events(&mut self) -> Events<'_, R> {
        Events {
            position: self.position.each_mut().map(Column::items_mut),
            velocity: self.velocity.each_mut().map(Column::items_mut),
            acceleration: self.acceleration.each_mut().map(Column::items_mut),
            uniform: &mut self.uniform,
            still: &mut self.still,
            since: self.since.items_mut(),
            tau: self.tau.items_mut(),
            plane: self.plane.items_mut(),
            earliest: self.earliest.items_mut(),
        }
    }
}

impl<R: Real, M: Storage> Default for Flights<R, M> {
    fn default() -> Self {
        Self::new()
    }
}
