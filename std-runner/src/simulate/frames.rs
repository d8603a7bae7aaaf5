//! The frames of a run: taken as it is stepped, and handed over to be recorded.

use std::io;
use std::ops::Range;
use std::time::{Duration, Instant};

use hooke::{Stepper, View};

use super::Stepped;
use super::anchor::Anchor;
use super::build::HeapWorld;
use super::interpolate::{Moment, hermite};
use super::method::AnyStepper;
use super::schedule::Schedule;
use super::taken::Taken;
use crate::record::{Background, BoxedRecorder, Sample, Stopped};

/// Takes frames.
pub(super) struct Frames<R: Stepped> {
    schedule: Schedule,
    /// What states are relative to.
    anchor: Anchor,
    /// Nothing where no frame is recorded: then none is made.
    background: Option<Background<R::Coordinate>>,
    /// The number of the next frame.
    next: u64,
    /// Time that went by here rather than in steps.
    waiting: Duration,
    /// The frames within the step that is being taken.
    within: Vec<Within>,
    /// The particles in exact flight at each of them, by number.
    flights: Vec<(u32, Moment<R::Coordinate>)>,
    /// All particles before that step, if there are such frames.
    before: Vec<Moment<R::Coordinate>>,
}

/// A frame within a step.
struct Within {
    time: f64,
    flights: Range<usize>,
}

impl<R: Stepped> Frames<R> {
    /// Starts a thread for the recorders, if there are any.
    pub(super) fn new(
        schedule: Schedule,
        anchor: Anchor,
        recorders: Vec<BoxedRecorder<R::Coordinate>>,
        particles: usize,
    ) -> io::Result<Self> {
        let background = Background::start_any(recorders, particles)?;
        Ok(Self {
            schedule,
            anchor,
            background,
            next: 0,
            waiting: Duration::ZERO,
            within: Vec::new(),
            flights: Vec::new(),
            before: Vec::new(),
        })
    }

    /// Whether further steps are in vain, as a frame could not be written.
    pub(super) fn have_stopped(&self) -> bool {
        self.background.as_ref().is_some_and(Background::has_stopped)
    }

    /// The first frame: the world before its first step.
    pub(super) fn begin(&mut self, view: &View<'_, R>) -> Result<(), Stopped> {
        let Some(background) = &mut self.background else {
            self.next = 1;
            return Ok(());
        };
        let began = Instant::now();
        let recorded = hand_over(background, 0, 0.0, moments(view, self.anchor), &[]);
        self.next = 1;
        self.waiting += began.elapsed();
        recorded
    }

    /// Looks for frames within a step before it is taken, with what flies exactly as it will be at them.
    pub(super) fn before_step(&mut self, world: &mut HeapWorld<R>, stepper: &mut AnyStepper<R>, step: u64) {
        self.within.clear();
        if self.background.is_none() || !self.schedule.is_before_end(self.next, step) {
            return;
        }
        let began = Instant::now();
        let (schedule, anchor) = (self.schedule, self.anchor);
        self.flights.clear();
        for frame in (self.next..).take_while(|frame| schedule.is_before_end(*frame, step)) {
            let time = schedule.frame_time(frame);
            let first = self.flights.len();
            if let Some(free) = world.view().free_at(stepper.any(), time) {
                self.flights.extend(free.map(|(number, x, v)| (number, (anchor.in_scene(x.into()), v.into()))));
            }
            self.within.push(Within { time, flights: first..self.flights.len() });
        }
        self.before.clear();
        self.before.extend(moments(&world.view(), self.anchor));
        self.waiting += began.elapsed();
    }

    /// Takes the frames within a part of a step that has just been made, from the stepper itself.
    pub(super) fn within_part(
        &mut self,
        view: &mut View<'_, R>,
        dt: R,
        stepper: &mut (impl Stepper<R> + ?Sized),
        step: u64,
    ) {
        let Some(background) = &mut self.background else { return };
        let began = Instant::now();
        let start = view.time();
        while self.schedule.is_before_end(self.next, step) {
            let time = self.schedule.frame_time(self.next);
            let after = (time - start).max(0.0);
            if after >= dt.to_f64() {
                break;
            }
            let Some(between) = stepper.between(view, dt, R::from_f64(after)) else { break };
            if hand_over(background, self.next, time, moments(&between, self.anchor), &[]).is_err() {
                // What became of the frames says why.
                break;
            }
            self.next += 1;
        }
        self.waiting += began.elapsed();
    }

    /// Takes the frames within a step, and the one at its end, after it is taken.
    pub(super) fn after_step(&mut self, view: &View<'_, R>, step: u64) -> Result<(), Stopped> {
        let Some(background) = &mut self.background else {
            while self.schedule.is_before_end(self.next, step) {
                self.next += 1;
            }
            self.next += u64::from(self.schedule.is_at_end(self.next, step));
            return Ok(());
        };
        let at_end = self.schedule.is_at_end(self.next + self.within.len() as u64, step);
        if self.within.is_empty() && !at_end {
            return Ok(());
        }
        let began = Instant::now();
        let (start, end) = (self.schedule.step_end(step - 1), self.schedule.step_end(step));
        for Within { time, flights } in &self.within {
            let part = (time - start) / (end - start);
            let between =
                self.before.iter().zip(moments(view, self.anchor)).map(|(a, b)| hermite(*a, b, end - start, part));
            let flights = self.flights.get(flights.clone()).unwrap_or_default();
            hand_over(background, self.next, *time, between, flights)?;
            self.next += 1;
        }
        if at_end {
            hand_over(background, self.next, self.schedule.frame_time(self.next), moments(view, self.anchor), &[])?;
            self.next += 1;
        }
        self.waiting += began.elapsed();
        Ok(())
    }

    /// Waits for the last frames to be written.
    pub(super) fn finish(self) -> Taken {
        Taken::of(self.background, self.next, self.waiting)
    }
}

/// A frame of these particles, in the order of their numbers; those in exact flight are where they fly.
fn hand_over<S: Sample>(
    background: &mut Background<S>,
    number: u64,
    time: f64,
    moments: impl Iterator<Item = Moment<S>>,
    flights: &[(u32, Moment<S>)],
) -> Result<(), Stopped> {
    background.record(number, time, |positions, velocities| {
        for (position, velocity) in moments {
            positions.push(position);
            velocities.push(velocity);
        }
        for (particle, (position, velocity)) in flights {
            let particle = *particle as usize;
            if let (Some(x), Some(v)) = (positions.get_mut(particle), velocities.get_mut(particle)) {
                (*x, *v) = (*position, *velocity);
            }
        }
    })
}

/// All particles, in the order of their numbers.
fn moments<R: Stepped>(view: &View<'_, R>, anchor: Anchor) -> impl Iterator<Item = Moment<R::Coordinate>> {
    view.states().map(move |(position, velocity)| (anchor.in_scene(position.into()), velocity.into()))
}
