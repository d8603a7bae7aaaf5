//! Stepping a world: what its user calls.

use crate::Real;
use crate::roles::{Observer, Response, Stepper};
use crate::sleep::Sleeping;
use crate::types::{StepError, StepReport};
use crate::vectors::{at, fetch, read};
use crate::world::{Clock, Container, Storage, View};

impl<R: Real> View<'_, R> {
    /// The particles that no spring pulls at as they will be at a later `time` (s), before the end of the next step,
    /// if the stepper flies them exactly: number, position (m), velocity (m/s). Otherwise nothing. The current state
    /// stays as it is.
    pub fn free_at(
        &mut self,
        stepper: &mut (impl Stepper<R> + ?Sized),
        time: f64,
    ) -> Option<impl Iterator<Item = (u32, R::Vec3, R::Vec3)>> {
        if !stepper.look_ahead(&mut self.awake(), time) {
            return None;
        }
        let plan = self.system.plan.awake();
        let (position, velocity) = (read(&self.next.position), read(&self.next.velocity));
        let told = |vector: [R; 3]| vector.map(|component| component.told(R::NO_RESIDUAL)).into();
        let slots = plan.attached..plan.particles;
        let system = self.system;
        Some(
            slots.map(move |slot| {
                (at(system.particle_at, slot), told(fetch(position, slot)), told(fetch(velocity, slot)))
            }),
        )
    }

    /// Takes one step of `dt` seconds.
    ///
    /// # Errors
    /// If `dt` is not positive and finite, a workspace is too small, or the result would not be finite. The state is
    /// then as it was.
    pub fn step(
        &mut self,
        stepper: &mut (impl Stepper<R> + ?Sized),
        response: &mut impl Response<R>,
        dt: R,
    ) -> Result<StepReport, StepError> {
        self.step_observed(stepper, response, dt, &mut ())
    }

    /// Takes one step of `dt` seconds, followed by an observer such as the [`crate::Ledger`].
    ///
    /// # Errors
    /// Like [`View::step`].
    pub fn step_observed(
        &mut self,
        stepper: &mut (impl Stepper<R> + ?Sized),
        response: &mut impl Response<R>,
        dt: R,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        self.take(stepper, response, dt, self.clock.later(dt.to_f64()), observer)
    }

    /// Takes one step of `dt` seconds that ends at the time `end` (s), which `dt` is the length up to, but for its
    /// rounding to this precision: the thousandth step of 1e-3 s ends at 1 s, whatever 1e-3 rounds to. In
    /// [`crate::Compensated`] steps differ by a rounding, so that they add up to it.
    ///
    /// # Errors
    /// Like [`View::step`]; `end` must be finite and later than the current time.
    pub fn step_to(
        &mut self,
        stepper: &mut (impl Stepper<R> + ?Sized),
        response: &mut impl Response<R>,
        dt: R,
        end: f64,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        if !(end > self.time() && end.is_finite()) {
            return Err(StepError::TimeStep);
        }
        let mut clock = Clock::at(end);
        let mut dt = dt;
        if R::IS_COMPENSATED {
            // The roundings of steps would add up to what they are there not to.
            // But for those of one so short that they are all of it.
            let length = end - self.time();
            let owed = if self.clock.owed.abs() < 0.5 * length { self.clock.owed } else { 0.0 };
            dt = R::from_f64(length + owed);
            clock.owed = self.clock.owed + (length - dt.to_f64());
        }
        self.take(stepper, response, dt, clock, observer)
    }

    fn take(
        &mut self,
        stepper: &mut (impl Stepper<R> + ?Sized),
        response: &mut impl Response<R>,
        dt: R,
        end: Clock,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        if !(dt > R::ZERO && dt.is_finite()) {
            return Err(StepError::TimeStep);
        }
        stepper.accept(&self.system.plan)?;
        stepper.fit(&self.system.plan)?;
        response.fit(&self.system.plan)?;
        self.end = end;
        self.is_next_finite = false;
        stepper.begins(self);
        observer.begins();
        let stepped = match self.sleep {
            Some(Sleeping { step_awake, .. }) if self.system.plan.asleep > 0 => {
                step_awake(self, &mut |awake| respond(awake, stepper, response, dt, observer))
            }
            _ => respond(self, stepper, response, dt, observer),
        };
        if stepped.is_err() {
            observer.fails();
            stepper.fails(self);
            // What the stepper may remember of the state that was not to be must not pass for that of one to come.
            *self.epoch += 2;
        } else if self.rest_after(dt, observer) {
            // The next view moves them; until then every step remembers something anew.
            stepper.rearranged(self);
        }
        stepped
    }
}

/// A function of its own, so that there is one copy of it whether or not anything sleeps.
#[inline(never)]
fn respond<R: Real>(
    view: &mut View<'_, R>,
    stepper: &mut (impl Stepper<R> + ?Sized),
    response: &mut impl Response<R>,
    dt: R,
    observer: &mut impl Observer<R>,
) -> Result<StepReport, StepError> {
    response.step(view, stepper, dt, observer)
}

impl<R: Real, M: Storage> Container<R, M> {
    /// Takes one step of `dt` seconds.
    ///
    /// # Errors
    /// Like [`View::step`].
    pub fn step(
        &mut self,
        stepper: &mut (impl Stepper<R> + ?Sized),
        response: &mut impl Response<R>,
        dt: R,
    ) -> Result<StepReport, StepError> {
        self.view().step(stepper, response, dt)
    }
}
