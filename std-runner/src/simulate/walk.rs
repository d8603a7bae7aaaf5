//! How a world is stepped: its stepper, what it does at planes, who follows it and who shares the work.

use std::ops::Range;

use hooke::{Observer, StepError, StepReport, View};

use super::Stepped;
use super::audit::Audit;
use super::build::HeapWorld;
use super::method::{AnyResponse, AnyStepper};
use super::threads::Threads;
use super::tracks::Tracks;
use crate::scene::Settings;

/// What steps a world as its settings say.
pub struct Walk<'a, R: Stepped> {
    /// Remembers something of the world that it stepped last.
    pub stepper: AnyStepper<R>,
    response: AnyResponse<R>,
    /// Follows its energy, if anybody does.
    pub audit: Option<Audit>,
    threads: Option<&'a Threads>,
}

impl<'a, R: Stepped> Walk<'a, R> {
    /// Before the first step.
    pub fn new(settings: &Settings, audit: Option<Audit>, threads: Option<&'a Threads>) -> Self {
        Self {
            stepper: AnyStepper::named(settings.stepper, settings.tolerance),
            response: AnyResponse::named(settings.collision),
            audit,
            threads,
        }
    }

    /// One step of `length` seconds through a span of time (s), in parts if keys of tracks lie within it; each part is
    /// reported to `count`.
    pub fn step(
        &mut self,
        world: &mut HeapWorld<R>,
        tracks: &Tracks<'_>,
        span: Range<f64>,
        length: f64,
        count: &mut dyn FnMut(&StepReport),
    ) -> Result<(), StepError> {
        let mut from = span.start;
        for stop in tracks.stops(span.start, span.end) {
            tracks.drive(world, from, stop).map_err(|_| StepError::TimeStep)?;
            let length = if stop - from < span.end - span.start { stop - from } else { length };
            let mut view = world.view();
            if let Some(threads) = self.threads {
                view.share_among(threads);
            }
            count(&self.take(&mut view, R::from_f64(length), stop)?);
            from = stop;
        }
        Ok(())
    }

    fn take(&mut self, view: &mut View<'_, R>, length: R, end: f64) -> Result<StepReport, StepError> {
        fn take<R: Stepped>(
            view: &mut View<'_, R>,
            stepper: &mut AnyStepper<R>,
            response: &mut AnyResponse<R>,
            length: R,
            end: f64,
            observer: &mut impl Observer<R>,
        ) -> Result<StepReport, StepError> {
            view.step_to(stepper, response, length, end, observer)
        }
        match &mut self.audit {
            Some(audit) => take(view, &mut self.stepper, &mut self.response, length, end, audit),
            None => take(view, &mut self.stepper, &mut self.response, length, end, &mut ()),
        }
    }
}
