//! All events that particles in free flight have up to a time.

use super::due::{BLOCK, Due};
use super::events::Events;
use crate::Real;
use crate::lanes::{Kernel, Set};
use crate::vectors::{at, store};
use crate::world::{State, System};

/// Passes what is due, for as many particles as can be listed together.
pub struct Pass<'a, R: Real> {
    pub system: &'a System<'a, R>,
    /// s
    pub time: f64,
    /// Up to then, once this has run.
    pub events: Events<'a, R>,
    /// The block of particles to begin with.
    pub block: u32,
    pub due: &'a mut Due,
}

/// What happened on the way.
#[derive(Clone, Copy, Debug, Default)]
pub struct Passed {
    /// The kinetic energy lost, J.
    pub lost: f64,
    /// Bounces.
    pub hits: u32,
    /// Particles that had too many of them.
    pub capped: u32,
    /// The block that this did not come to.
    pub block: u32,
}

impl<R: Real> Kernel for Pass<'_, R> {
    type Output = Passed;

    #[inline(always)]
    fn run(mut self, _set: impl Set) -> Passed {
        let Self { system, time, due, .. } = self;
        let block = due.list(&mut self.events, self.block, time);
        let mut passed = Passed { block, ..Passed::default() };
        if !cfg!(feature = "compact") {
            self.events.pass_together(system, due, time);
        }
        for (index, bounces) in due.each() {
            if self.events.due(index) <= time {
                self.events.pass_until(system, index, time, bounces);
            }
        }
        let Some(mut events) = self.events.lend() else { return passed };
        for (index, bounces) in due.each() {
            passed.lost += at(system.mass, system.plan.attached + index).to_f64() * bounces.lost;
            passed.hits = passed.hits.saturating_add(bounces.hits);
            passed.capped = passed.capped.saturating_add(u32::from(bounces.capped));
            events.foresee(index);
        }
        passed
    }
}

/// Writes the states at a `time` of those particles that are about to come to rest: once all has been passed, nothing
/// else is due still. Returns the kinetic energy lost since their last events, J.
pub fn settle<R: Real>(system: &System<'_, R>, events: &Events<'_, R>, time: f64, next: &mut State<'_, R>) -> f64 {
    let mut pending = 0.0;
    for (block, earliest) in (0..).zip(&*events.earliest) {
        if *earliest <= time {
            let start = block * BLOCK as u32;
            for index in start..start.saturating_add(BLOCK as u32).min(system.plan.free()) {
                let Some((flight, lost)) = events.settling(system, index, time) else { continue };
                store(&mut next.position, index, flight.position);
                store(&mut next.velocity, index, flight.velocity);
                pending += at(system.mass, system.plan.attached + index).to_f64() * lost;
            }
        }
    }
    pending
}
