//! The run itself: step, record, repeat.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use hooke::{Balance, LinearSolver, Plan, Real, StabilityBound, StepError, StepReport};

use super::Stepped;
use super::anchor::Anchor;
use super::audit::Audit;
use super::build::{BuildError, HeapWorld, world_with};
use super::frames::Frames;
use super::heap::bytes_filled;
use super::method::AnyStepper;
use super::schedule::{MOST, Schedule};
use super::summary::{Ending, Summary};
use super::threads::Threads;
use super::time_step::{choose_time_step, looked_at_every, tells_between};
use super::tracks::Tracks;
use super::walk::Walk;
use crate::model::Model;
use crate::record::{BoxedRecorder, RecordError, Stopped};
use crate::scene::Settings;

/// What a run does besides stepping.
pub struct Options<'a> {
    /// Whether the energy ledger is kept; it costs two passes over the springs a step.
    pub ledger: bool,
    /// Whether the digest of the last state is told; it costs a pass over the particles at the end.
    pub digest: bool,
    /// Threads that share the work of each step; nothing for as many as there are where that gains time.
    pub threads: Option<u32>,
    /// Set from outside to end the run after the step that it is at.
    pub interrupted: &'a AtomicBool,
    /// Told of each step.
    pub progress: &'a dyn Progress,
}

/// Somebody who is told how far a run is.
pub trait Progress: Sync {
    /// It has reached this time (s) of `duration`.
    fn reached(&self, time: f64, duration: f64);

    /// Where a ledger is kept: its balance at this time (s), which is made up only if it is asked for.
    fn balanced(&self, _time: f64, _balance: &mut dyn FnMut() -> Balance) {}

    /// Where a ledger is kept: when hits of particles with springs have cut the last step, s, if any have.
    fn cut(&self, _times: &mut dyn Iterator<Item = f64>) {}
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
    /// The system has no threads to step on. Nothing has been stepped.
    #[error("no threads can be started to step on: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// The system has no thread to record on. Nothing has been stepped.
    #[error("no thread can be started to record on: {0}")]
    Thread(std::io::Error),
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
    /// The time step, s; nothing where particles fly from frame to frame, and where the stepper chooses its steps.
    pub time_step: Option<f64>,
    /// What solves the linear systems of a step; nothing for explicit steppers.
    pub linear_solver: Option<LinearSolver>,
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
        let every = looked_at_every(settings, view.plan(), time_step);
        let schedule = Schedule::new(settings.duration, every, settings.frame_rate);
        let linear_solver = time_step.and_then(|dt| {
            // There is always room on the heap.
            AnyStepper::<R>::named(settings.stepper, settings.tolerance).linear_solver(&view, dt).ok().flatten()
        });
        Self { schedule, plan: *view.plan(), bound, time_step, linear_solver }
    }
}

/// Steps a model through its duration and records its frames to what `begin` opens for them: in order, on a thread of its
/// own, while further steps are taken. All that were made are recorded when this returns.
///
/// # Errors
/// If the model does not fit the precision `R`, the run has no end, or a frame cannot be written, which ends the run soon
/// after. That a simulation diverges is not an error here: the summary tells, and the frames up to then are recorded.
pub fn run<R: Stepped>(
    model: &Model,
    settings: &Settings,
    begin: impl FnOnce(&Start) -> Result<Vec<BoxedRecorder<R::Coordinate>>, RecordError>,
    options: &Options<'_>,
) -> Result<Summary, RunError> {
    let mut world = world_with::<R>(model, settings)?;
    let anchor = Anchor::of(model);
    let relative = anchor.relative(model);
    let tracks = Tracks::of(&relative);
    let start = Start::in_world(&mut world, settings);
    if !start.schedule.is_countable() {
        return Err(RunError::Endless(Box::new(start)));
    }
    let threads = Threads::of(options.threads, &start.plan)?;
    let recorders = begin(&start).map_err(RunError::Begin)?;
    let mut run = Run {
        frames: Frames::new(start.schedule, anchor, recorders, model.particles.len()).map_err(RunError::Thread)?,
        is_dense: tells_between(settings, &start.plan),
        summary: Summary::before(start),
        walk: Walk::new(settings, model.size(), options.ledger.then(|| Audit::open(&world.view())), threads.as_ref()),
    };
    let began = Instant::now();
    // Where recording has stopped, what became of the frames says why.
    let _ = match &threads {
        Some(threads) => threads.during(|| run.steps(&mut world, &tracks, options)),
        None => run.steps(&mut world, &tracks, options),
    };
    let taken = run.frames.finish();
    run.summary.close(taken, began.elapsed(), threads.as_ref(), &world.view(), run.walk.audit.as_ref())?;
    run.summary.digest = options.digest.then(|| hooke_digest::of(&world.view()));
    Ok(run.summary)
}

struct Run<'a, R: Stepped> {
    frames: Frames<R>,
    /// Whether frames within steps come from the stepper.
    is_dense: bool,
    summary: Summary,
    walk: Walk<'a, R>,
}

impl<R: Stepped> Run<'_, R> {
    fn steps(&mut self, world: &mut HeapWorld<R>, tracks: &Tracks<'_>, options: &Options<'_>) -> Result<(), Stopped> {
        let held = bytes_filled();
        let stepped = self.all_steps(world, tracks, options);
        self.summary.workspace = bytes_filled().saturating_sub(held);
        stepped
    }

    fn all_steps(
        &mut self,
        world: &mut HeapWorld<R>,
        tracks: &Tracks<'_>,
        options: &Options<'_>,
    ) -> Result<(), Stopped> {
        let schedule = self.summary.schedule;
        self.frames.begin(&world.view())?;
        for step in 1..=schedule.steps() {
            if options.interrupted.load(Ordering::Relaxed) {
                self.summary.ending = Ending::Interrupted;
                return Ok(());
            }
            if self.frames.have_stopped() {
                return Err(Stopped);
            }
            if !self.is_dense {
                self.frames.before_step(world, &mut self.walk.stepper, step);
            }
            if let Err(error) = self.step(world, tracks, step) {
                self.summary.ending = match error {
                    StepError::NonFinite { particle } => Ending::NonFinite { particle },
                    other => Ending::Refused(other),
                };
                return Ok(());
            }
            self.summary.steps += 1;
            self.frames.after_step(&world.view(), step)?;
            let time = schedule.step_end(step);
            options.progress.reached(time, schedule.step_end(schedule.steps()));
            if let Some(audit) = &mut self.walk.audit {
                options.progress.cut(&mut audit.cuts());
                options.progress.balanced(time, &mut || audit.balance(&world.view()));
            }
        }
        Ok(())
    }

    /// One step of the schedule, in parts if keys of tracks lie within it.
    fn step(&mut self, world: &mut HeapWorld<R>, tracks: &Tracks<'_>, step: u64) -> Result<(), StepError> {
        let schedule = self.summary.schedule;
        let (start, end) = (schedule.step_end(step - 1), schedule.step_end(step));
        let summary = &mut self.summary;
        let count = &mut |report: &StepReport| summary.count(report);
        let within = self.is_dense.then_some((&mut self.frames, step));
        self.walk.step_within(world, tracks, start..end, schedule.step_length(step), within, count)?;
        // A shortened last step may be within bounds that the others are not: it says nothing of the run.
        let whole = schedule.short_step().is_none() || step < schedule.steps();
        if let Some(choice) = self.walk.stepper.choice()
            && whole
            && self.summary.choices.iter().all(|other| other.chosen != choice.chosen)
        {
            self.summary.choices.push(choice);
        }
        Ok(())
    }
}
