//! The run itself: step, record, repeat.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use hooke::{Ledger, Observer, Plan, Real, StabilityBound, StepError, StepReport, View};

use super::build::{BuildError, HeapWorld, world_with};
use super::interpolate::{Moment, hermite};
use super::method::{AnyResponse, AnyStepper};
use super::schedule::{MOST, Schedule};
use super::summary::{Ending, Summary};
use super::time_step::choose_time_step;
use super::tracks::Tracks;
use crate::model::Model;
use crate::record::{Frame, RecordError, Recorder, Sample};
use crate::scene::Settings;

/// What a run does besides stepping.
pub struct Options<'a> {
    /// Whether the energy ledger is kept; it costs two passes over the springs a step.
    pub ledger: bool,
    /// Set from outside to end the run after the step that it is at.
    pub interrupted: &'a AtomicBool,
    /// Told of each step.
    pub progress: &'a dyn Progress,
}

/// Somebody who is told how far a run is.
pub trait Progress {
    /// It has reached this time (s) of `duration`.
    fn reached(&self, time: f64, duration: f64);
}

/// Why a run could not be made.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The model is out of the range of its precision.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// There are more steps or frames than can be counted. Nothing has been stepped.
    #[error("there are more than {MOST} steps or frames")]
    Endless(Box<Start>),
    /// A recording could not be begun. Nothing has been stepped.
    #[error(transparent)]
    Begin(RecordError),
    /// A frame could not be written.
    #[error("{error}")]
    Record {
        /// Why.
        error: RecordError,
        /// The frames that every recording has.
        frames: u64,
    },
}

/// What is known of a run before its first step.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// Its steps and frames.
    pub schedule: Schedule,
    /// What the world needs.
    pub plan: Plan,
    /// The stability bounds; nothing where no spring pulls at a free particle.
    pub bound: Option<StabilityBound>,
    /// The time step, s; nothing where particles fly from frame to frame.
    pub time_step: Option<f64>,
}

impl Start {
    /// Of a model that is stepped in the precision `R`.
    ///
    /// # Errors
    /// If the model does not fit that precision.
    pub fn of<R: Real>(model: &Model, settings: &Settings) -> Result<Self, BuildError> {
        Ok(Self::in_world(&mut world_with::<R>(model, settings)?, settings))
    }

    fn in_world<R: Real>(world: &mut HeapWorld<R>, settings: &Settings) -> Self {
        let view = world.view();
        let bound = view.stability();
        let time_step = choose_time_step(settings, view.plan(), bound.as_ref());
        let schedule = Schedule::new(settings.duration, time_step, settings.frame_rate);
        Self { schedule, plan: *view.plan(), bound, time_step }
    }
}

/// Steps a model through its duration and records its frames, as they are made, to what `begin` opens for them.
///
/// # Errors
/// If the model does not fit the precision `R`, the run has no end, or a frame cannot be written. That a simulation diverges is not an error
/// here: the summary tells, and the frames up to then are recorded.
pub fn run<R: Sample>(
    model: &Model,
    settings: &Settings,
    begin: impl FnOnce(&Start) -> Result<Vec<Box<dyn Recorder<R>>>, RecordError>,
    options: &Options<'_>,
) -> Result<Summary, RunError> {
    let mut world = world_with::<R>(model, settings)?;
    let tracks = Tracks::of(model);
    let start = Start::in_world(&mut world, settings);
    if !start.schedule.is_countable() {
        return Err(RunError::Endless(Box::new(start)));
    }
    let mut run = Run {
        recorders: begin(&start).map_err(RunError::Begin)?,
        position: Vec::with_capacity(model.particles.len()),
        velocity: Vec::with_capacity(model.particles.len()),
        summary: summary(start),
        method: Method {
            stepper: AnyStepper::named(settings.stepper, settings.tolerance),
            response: AnyResponse::named(settings.collision),
            ledger: options.ledger.then(|| Ledger::open(&world.view())),
        },
    };
    let began = Instant::now();
    let stepped = run.steps(&mut world, &tracks, options);
    let finished = run.recorders.into_iter().try_for_each(Recorder::finish);
    let frames = run.summary.frames;
    stepped.and(finished).map_err(|error| RunError::Record { error, frames })?;
    run.summary.stepping = began.elapsed().saturating_sub(run.summary.recording);
    let view = world.view();
    run.summary.time = view.time();
    run.summary.islands_asleep = view.plan().islands_asleep;
    run.summary.balance = run.method.ledger.map(|ledger| ledger.balance(&view));
    Ok(run.summary)
}

fn summary(start: Start) -> Summary {
    Summary {
        ending: Ending::Finished,
        time: 0.0,
        schedule: start.schedule,
        steps: 0,
        frames: 0,
        plan: start.plan,
        bound: start.bound,
        time_step: start.time_step,
        choices: Vec::new(),
        stepping: Duration::ZERO,
        recording: Duration::ZERO,
        balance: None,
        islands_asleep: 0,
        hits: 0,
        capped: 0,
        degenerate_springs: 0,
        force_evaluations: 0,
        iterations: 0,
        linear_iterations: 0,
        unconverged: 0,
        residual: 0.0,
    }
}

struct Method<R: Sample> {
    stepper: AnyStepper<R>,
    response: AnyResponse<R>,
    ledger: Option<Ledger>,
}

struct Run<R: Sample> {
    recorders: Vec<Box<dyn Recorder<R>>>,
    /// Of the frame that is being recorded, by particle number.
    position: Vec<[R; 3]>,
    velocity: Vec<[R; 3]>,
    summary: Summary,
    method: Method<R>,
}

impl<R: Sample> Run<R> {
    fn steps(
        &mut self,
        world: &mut HeapWorld<R>,
        tracks: &Tracks<'_>,
        options: &Options<'_>,
    ) -> Result<(), RecordError> {
        let schedule = self.summary.schedule;
        self.record(0.0, moments(&world.view()))?;
        for step in 1..=schedule.steps() {
            if options.interrupted.load(Ordering::Relaxed) {
                self.summary.ending = Ending::Interrupted;
                return Ok(());
            }
            let early = self.frames_before_end(world, step);
            let before: Vec<Moment<R>> = if early.is_empty() { Vec::new() } else { moments(&world.view()).collect() };
            if let Err(error) = self.step(world, tracks, step) {
                self.summary.ending = match error {
                    StepError::NonFinite { particle } => Ending::NonFinite { particle },
                    other => Ending::Refused(other),
                };
                return Ok(());
            }
            self.summary.steps += 1;
            let (start, end) = (schedule.step_end(step - 1), schedule.step_end(step));
            for Early { time, free } in early {
                let part = (time - start) / (end - start);
                let mut between: Vec<Moment<R>> =
                    before.iter().zip(moments(&world.view())).map(|(a, b)| hermite(*a, b, end - start, part)).collect();
                for (particle, moment) in free {
                    if let Some(place) = between.get_mut(particle as usize) {
                        *place = moment;
                    }
                }
                self.record(time, between.into_iter())?;
            }
            let next = self.summary.frames;
            if next < schedule.frames() && schedule.is_at_end(next, step) {
                self.record(schedule.frame_time(next), moments(&world.view()))?;
            }
            options.progress.reached(end, schedule.step_end(schedule.steps()));
        }
        Ok(())
    }

    /// The frames that are taken within a step, with what flies exactly as it will be at them.
    fn frames_before_end(&mut self, world: &mut HeapWorld<R>, step: u64) -> Vec<Early<R>> {
        let schedule = self.summary.schedule;
        let frames = (self.summary.frames..schedule.frames()).take_while(|frame| schedule.is_before_end(*frame, step));
        let stepper = &mut self.method.stepper;
        let early = frames.map(|frame| {
            let time = schedule.frame_time(frame);
            let mut view = world.view();
            let free = view.free_at(stepper, time);
            let free = free.map(|free| free.map(|(number, x, v)| (number, (x.into(), v.into()))).collect());
            Early { time, free: free.unwrap_or_default() }
        });
        early.collect()
    }

    /// One step of the schedule, in parts if keys of tracks lie within it.
    fn step(&mut self, world: &mut HeapWorld<R>, tracks: &Tracks<'_>, step: u64) -> Result<(), StepError> {
        let schedule = self.summary.schedule;
        let (start, end) = (schedule.step_end(step - 1), schedule.step_end(step));
        let mut from = start;
        for stop in tracks.stops(start, end) {
            tracks.drive(world, from, stop).map_err(|_| StepError::TimeStep)?;
            let length = if stop - from < end - start { stop - from } else { schedule.step_length(step) };
            let report = self.method.step(&mut world.view(), R::from_f64(length), stop)?;
            self.count(&report);
            from = stop;
        }
        // A shortened last step may be within bounds that the others are not: it says nothing of the run.
        let whole = schedule.short_step().is_none() || step < schedule.steps();
        if let Some(choice) = self.method.stepper.choice()
            && whole
            && self.summary.choices.iter().all(|other| other.chosen != choice.chosen)
        {
            self.summary.choices.push(choice);
        }
        Ok(())
    }

    fn count(&mut self, report: &StepReport) {
        let summary = &mut self.summary;
        summary.hits += u64::from(report.hits);
        summary.capped += u64::from(report.capped);
        summary.degenerate_springs = summary.degenerate_springs.max(report.degenerate_springs);
        summary.force_evaluations += u64::from(report.force_evaluations);
        summary.iterations += u64::from(report.iterations);
        summary.linear_iterations += u64::from(report.linear_iterations);
        summary.unconverged += u64::from(!report.converged);
        summary.residual = summary.residual.max(report.residual);
    }

    fn record(&mut self, time: f64, moments: impl Iterator<Item = Moment<R>>) -> Result<(), RecordError> {
        let number = self.summary.frames;
        if self.recorders.is_empty() {
            self.summary.frames += 1;
            return Ok(());
        }
        let began = Instant::now();
        self.position.clear();
        self.velocity.clear();
        for (position, velocity) in moments {
            self.position.push(position);
            self.velocity.push(velocity);
        }
        let frame = Frame { number, time, position: &self.position, velocity: &self.velocity };
        let recorded = self.recorders.iter_mut().try_for_each(|recorder| recorder.record(&frame));
        self.summary.recording += began.elapsed();
        self.summary.frames += u64::from(recorded.is_ok());
        recorded
    }
}

impl<R: Sample> Method<R> {
    fn step(&mut self, view: &mut View<'_, R>, length: R, end: f64) -> Result<StepReport, StepError> {
        fn take<R: Sample>(
            view: &mut View<'_, R>,
            stepper: &mut AnyStepper<R>,
            response: &mut AnyResponse<R>,
            length: R,
            end: f64,
            observer: &mut impl Observer<R>,
        ) -> Result<StepReport, StepError> {
            view.step_to(stepper, response, length, end, observer)
        }
        match &mut self.ledger {
            Some(ledger) => take(view, &mut self.stepper, &mut self.response, length, end, ledger),
            None => take(view, &mut self.stepper, &mut self.response, length, end, &mut ()),
        }
    }
}

/// A frame within a step.
struct Early<R> {
    time: f64,
    /// The particles in exact flight, by number.
    free: Vec<(u32, Moment<R>)>,
}

/// All particles, in the order of their numbers.
fn moments<R: Sample>(view: &View<'_, R>) -> impl Iterator<Item = Moment<R>> {
    view.states().map(|(position, velocity)| (position.into(), velocity.into()))
}
