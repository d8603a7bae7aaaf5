//! One step: the stepper advances the state, the response answers collisions, the observer looks on.

use crate::Real;
use crate::collisions::{Answer, Response};
use crate::steppers::Stepper;
use crate::types::{StepError, StepReport};
use crate::vectors::at;
use crate::world::{Clock, Container, Storage, View};

/// Somebody who follows a world through its steps, part by part. `()` looks away, and costs nothing.
pub trait Observer<R: Real> {
    /// Whether anything is done with what it is told.
    fn watches(&self) -> bool;

    /// The stepper has written the state `dt` seconds after the current one to the next one; collisions have not been
    /// answered yet.
    fn advanced(&mut self, view: &mut View<'_, R>, dt: R);

    /// Impacts have taken this energy, J.
    fn lost_in_impacts(&mut self, energy: f64);

    /// A step begins.
    fn begins(&mut self) {}

    /// It has failed: whatever it has been told since the step began has not been.
    fn fails(&mut self) {}
}

impl<R: Real> Observer<R> for () {
    fn watches(&self) -> bool {
        false
    }
    fn advanced(&mut self, _view: &mut View<'_, R>, _dt: R) {}
    fn lost_in_impacts(&mut self, _energy: f64) {}
}

impl<R: Real> View<'_, R> {
    /// Takes one step of `dt` seconds.
    ///
    /// # Errors
    /// If `dt` is not positive and finite, a workspace is too small, or the result would not be finite. The state is
    /// then as it was.
    pub fn step(
        &mut self,
        stepper: &mut impl Stepper<R>,
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
        stepper: &mut impl Stepper<R>,
        response: &mut impl Response<R>,
        dt: R,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        self.take(stepper, response, dt, self.clock.later(dt.to_f64()), observer)
    }

    /// Takes one step of `dt` seconds that ends at the time `end` (s), which `dt` is the length up to, but for its
    /// rounding to this precision: the thousandth step of 1e-3 s ends at 1 s, whatever 1e-3 rounds to.
    ///
    /// # Errors
    /// Like [`View::step`]; `end` must be finite and later than the current time.
    pub fn step_to(
        &mut self,
        stepper: &mut impl Stepper<R>,
        response: &mut impl Response<R>,
        dt: R,
        end: f64,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        if !(end > self.time() && end.is_finite()) {
            return Err(StepError::TimeStep);
        }
        self.take(stepper, response, dt, Clock::at(end), observer)
    }

    fn take(
        &mut self,
        stepper: &mut impl Stepper<R>,
        response: &mut impl Response<R>,
        dt: R,
        end: Clock,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        if !(dt > R::ZERO && dt.is_finite()) {
            return Err(StepError::TimeStep);
        }
        stepper.fit(&self.system.plan)?;
        response.fit(&self.system.plan)?;
        self.end = end;
        observer.begins();
        let stepped = response.step(self, stepper, dt, observer);
        if stepped.is_err() {
            observer.fails();
            // What the stepper may remember of the state that was not to be must not pass for that of one to come.
            *self.epoch += 2;
        }
        stepped
    }
}

impl<R: Real, M: Storage> Container<R, M> {
    /// Takes one step of `dt` seconds.
    ///
    /// # Errors
    /// Like [`View::step`].
    pub fn step(
        &mut self,
        stepper: &mut impl Stepper<R>,
        response: &mut impl Response<R>,
        dt: R,
    ) -> Result<StepReport, StepError> {
        self.view().step(stepper, response, dt)
    }
}

/// Makes the next state, in which collisions have been answered, the current one.
pub(crate) fn finish<R: Real>(
    view: &mut View<'_, R>,
    report: &mut StepReport,
    answer: &Answer,
    observer: &mut impl Observer<R>,
) {
    report.hits += answer.hits;
    if answer.hits > 0 {
        observer.lost_in_impacts(answer.lost);
    }
    view.commit(view.end, answer.hits > 0);
}

/// Refuses a next state that is not finite, naming the first particle by number.
pub(crate) fn refuse_non_finite<R: Real>(view: &View<'_, R>) -> Result<(), StepError> {
    let columns = || view.next.position.iter().chain(&view.next.velocity);
    let finite = columns().all(|column| column.iter().fold(true, |finite, value| finite & value.is_finite()));
    if finite {
        return Ok(());
    }
    let particles = columns().flat_map(|column| {
        let slots = (0..).zip(column.iter()).filter(|(_, value)| !value.is_finite());
        slots.map(|(slot, _)| at(view.system.particle_at, slot))
    });
    Err(StepError::NonFinite { particle: particles.min().unwrap_or(0) })
}
