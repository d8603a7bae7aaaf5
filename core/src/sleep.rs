//! Falling asleep: what rests is looked at now and then, and left out of the steps to come once it has rested for long.

use crate::Real;
use crate::forces::energy::kinetic_of;
use crate::roles::Observer;
use crate::types::{Sleep, StepError, StepReport};
use crate::vectors::{at, difference, dot, is_zero, put, store};
use crate::world::{Mark, View};

/// Looks in a row that must find an island calm; they are spread evenly over the time that is asked for.
const LOOKS: u8 = 8;

/// What counts as calm: squares of a speed and of its change in a step.
struct Calm<R> {
    speed: R,
    change: R,
}

/// When what rests falls asleep, and what sees to it: a program that lets nothing sleep does not contain that.
#[derive(Clone, Copy)]
pub struct Sleeping<R: Real> {
    pub sleep: Sleep<R>,
    fall_asleep: fn(&mut View<'_, R>, Sleep<R>, R) -> Option<f64>,
    /// Takes a step without what sleeps.
    pub step_awake: fn(&mut View<'_, R>, Step<'_, R>) -> Result<StepReport, StepError>,
}

/// Takes a step.
type Step<'a, R> = &'a mut dyn FnMut(&mut View<'_, R>) -> Result<StepReport, StepError>;

impl<R: Real> Sleeping<R> {
    pub fn new(sleep: Sleep<R>) -> Self {
        Self {
            sleep,
            fall_asleep: |view, sleep, dt| view.fall_asleep(sleep, dt),
            step_awake: |view, step| view.step_awake(step),
        }
    }
}

impl<R: Real> View<'_, R> {
    /// After a step of `dt`: what rests falls asleep, if it may. Returns whether any has, or is about to be moved since.
    #[inline(always)]
    pub(crate) fn rest_after(&mut self, dt: R, observer: &mut impl Observer<R>) -> bool {
        let Some(Sleeping { sleep, fall_asleep, .. }) = self.sleep else { return false };
        if let Some(lost) = fall_asleep(self, sleep, dt) {
            observer.fell_asleep(lost);
        }
        self.watch.fell_asleep
    }

    /// Takes a step without what sleeps.
    fn step_awake(&mut self, step: Step<'_, R>) -> Result<StepReport, StepError> {
        let front = *self.front;
        let mut stepped = step(&mut self.awake());
        if *self.front != front {
            core::mem::swap(&mut self.current, &mut self.next);
        }
        if let Ok(report) = &mut stepped {
            report.islands_asleep = self.system.plan.islands_asleep;
        }
        stepped
    }

    /// After a step of `dt`, puts what has rested for long enough to sleep, if it is time to look. Returns the kinetic energy
    /// that was left in it, J, if any did.
    fn fall_asleep(&mut self, sleep: Sleep<R>, dt: R) -> Option<f64> {
        self.watch.since += dt.to_f64();
        let interval = sleep.time.to_f64() / f64::from(LOOKS);
        // A rounding less: so many steps may add up to a little less than the time that they make up.
        if self.watch.since < (1.0 - 1e-6) * interval {
            return None;
        }
        self.watch.since = 0.0;
        let change = sleep.speed * (dt / R::from_f64(interval));
        let calm = Calm { speed: sleep.speed * sleep.speed, change: change * change };
        self.stir_what_hangs_on_movers();
        let lost = self.look(&calm);
        self.watch.fell_asleep |= lost.is_some();
        lost
    }

    /// A held particle that moves keeps everything awake that hangs on it.
    fn stir_what_hangs_on_movers(&mut self) {
        let system = &self.system;
        let awake = system.plan.awake();
        if awake.held == 0 {
            return;
        }
        for (slot, incidences) in system.springs.by_slot(awake.attached) {
            if system.is_dynamic(slot) || is_zero(self.current.velocity_of(slot)) {
                continue;
            }
            for incidence in incidences {
                let particle = at(system.particle_at, incidence.neighbour);
                put(self.rest, particle, Mark::from_byte(at(self.rest, particle)).stirred().to_byte());
            }
        }
    }

    /// Looks at all islands that are awake. Returns the kinetic energy that was left in those that fell asleep, J.
    fn look(&mut self, calm: &Calm<R>) -> Option<f64> {
        let mut lost = None;
        let (mut first, mut all_calm, mut any_dynamic) = (0, true, false);
        for slot in 0..self.system.plan.awake().attached {
            let particle = at(self.system.particle_at, slot);
            let mark = Mark::from_byte(at(self.rest, particle));
            all_calm &= self.is_calm(slot, calm) && !mark.is_stirred();
            any_dynamic |= self.system.is_dynamic(slot);
            if !mark.is_last() {
                put(self.rest, particle, mark.looked_at(0).to_byte());
                continue;
            }
            let looks = if all_calm && any_dynamic { mark.looks() + 1 } else { 0 };
            put(self.rest, particle, mark.looked_at(looks).to_byte());
            if looks >= LOOKS {
                *lost.get_or_insert(0.0) += self.put_to_sleep(first, slot);
            }
            (first, all_calm, any_dynamic) = (slot + 1, true, false);
        }
        lost
    }

    /// Just after a step the next state still is the one before it.
    fn is_calm(&self, slot: u32, calm: &Calm<R>) -> bool {
        let velocity = self.current.velocity_of(slot);
        if !self.system.is_dynamic(slot) {
            return is_zero(velocity);
        }
        let change = difference(velocity, self.next.velocity_of(slot));
        dot(velocity, velocity) < calm.speed && dot(change, change) < calm.change
    }

    /// The island in these slots. Returns the kinetic energy that was left in it, J.
    fn put_to_sleep(&mut self, first: u32, last: u32) -> f64 {
        let mut lost = 0.0;
        for slot in first..=last {
            lost += kinetic_of(&self.system, &self.current, slot);
            self.current.put_velocity(slot, [R::ZERO; 3]);
            store(&mut self.current.velocity_residual, slot, [R::NO_RESIDUAL; 3]);
            let particle = at(self.system.particle_at, slot);
            put(self.rest, particle, Mark::from_byte(at(self.rest, particle)).sleeping().to_byte());
        }
        lost
    }
}
