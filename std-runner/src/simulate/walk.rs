//! How a world is stepped: its stepper, what it does at planes, who follows it and who shares the work.

use std::ops::Range;

use hooke::{StepError, StepReport, View};

use super::Stepped;
use super::audit::Audit;
use super::build::HeapWorld;
use super::frames::Frames;
use super::looking::Looking;
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
    /// Before the first step of a scene of that size (m), which errors of steps that are chosen are relative to.
    pub fn new(settings: &Settings, size: f64, audit: Option<Audit>, threads: Option<&'a Threads>) -> Self {
        Self {
            stepper: AnyStepper::of(settings, size),
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
        self.step_within(world, tracks, span, length, None, count)
    }

    /// The same; the frames of that step of the schedule are taken within it, if any are given.
    pub(super) fn step_within(
        &mut self,
        world: &mut HeapWorld<R>,
        tracks: &Tracks<'_>,
        span: Range<f64>,
        length: f64,
        mut within: Option<(&mut Frames<R>, u64)>,
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
            let frames = within.as_mut().map(|(frames, step)| (&mut **frames, *step));
            count(&self.take(&mut view, R::from_f64(length), stop, frames)?);
            from = stop;
        }
        Ok(())
    }

    fn take(
        &mut self,
        view: &mut View<'_, R>,
        length: R,
        end: f64,
        within: Option<(&mut Frames<R>, u64)>,
    ) -> Result<StepReport, StepError> {
        let Self { stepper, response, audit, .. } = self;
        let stepper = stepper.any();
        match (within, audit) {
            (Some((frames, step)), audit) => {
                view.step_to(stepper, response, length, end, &mut Looking { frames, step, audit: audit.as_mut() })
            }
            (None, Some(audit)) => view.step_to(stepper, response, length, end, audit),
            (None, None) => view.step_to(stepper, response, length, end, &mut ()),
        }
    }
}
