//! One run of a scene: where everything was at its checkpoints, and what that took.

use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use hooke::Compensated;

use super::asked::Asked;
use super::watch::{Seen, Watch};
use crate::model::Model;
use crate::record::{BoxedRecorder, Frame, RecordError, Recorder, Sample};
use crate::scene::{Precision, Settings};
use crate::simulate::{Ending, Options, Progress, RunError, Stepped, Summary, run};

/// Looks at what happens on planes between two checkpoints, where steps are chosen.
pub(super) const LOOKS: u64 = 64;

/// Positions or velocities by particle number, m or m/s.
pub type Vectors = Vec<[f64; 3]>;

/// Where everything was at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// m, by particle number.
    pub positions: Vectors,
    /// m/s, by particle number.
    pub velocities: Vectors,
}

/// What a run came to.
#[derive(Clone, Debug)]
pub struct Probe {
    /// At each checkpoint, the last at the end; without the start.
    pub states: Vec<State>,
    /// Time spent stepping.
    pub stepping: Duration,
    /// Steps that were taken; those that the stepper chose, if it did.
    pub steps: u64,
    /// Evaluations of all forces.
    pub force_evaluations: u64,
    /// Newton iterations.
    pub iterations: u64,
    /// Iterations of linear solvers, and factorisations.
    pub linear_work: u64,
    /// What the stepper and the collision form own, bytes.
    pub workspace: usize,
}

/// What became of it.
#[derive(Clone, Debug)]
pub enum Probed<P = Probe> {
    /// It reached the end.
    Finished(P),
    /// It left the finite numbers, or could not solve a step.
    Diverged {
        /// Time spent until then.
        stepping: Duration,
        /// The simulated time that it reached, s.
        reached: f64,
    },
    /// It was ended from outside.
    Interrupted,
}

/// Runs a scene as its settings say but in so many steps, or to a tolerance, with its state kept at so many evenly spaced
/// checkpoints, on one thread and without a ledger. Checkpoints fall on steps where their number divides that of the steps;
/// the others are interpolated.
///
/// # Errors
/// If it cannot be run at all: the precision cannot hold it, say.
pub fn probe(
    model: &Model,
    settings: &Settings,
    asked: impl Into<Asked>,
    checkpoints: u64,
    interrupted: &AtomicBool,
) -> Result<Probed, RunError> {
    let settings = asked.into().settings(settings, checkpoints);
    let kept = Kept::default();
    let options = Options { ledger: false, digest: false, threads: Some(1), interrupted, progress: &Silent };
    let summary = run_with(model, &settings, Keep { kept: Arc::clone(&kept), every: 1 }, &options)?;
    Ok(ended(&summary, &kept, checkpoints))
}

/// The same, with an energy ledger and with an eye on planes at every step: slower, and to the same bits.
///
/// # Errors
/// As [`probe`].
pub fn watched(
    model: &Model,
    settings: &Settings,
    asked: impl Into<Asked>,
    checkpoints: u64,
    interrupted: &AtomicBool,
) -> Result<Probed<(Probe, Seen)>, RunError> {
    let asked = asked.into();
    // On planes everything happens between checkpoints.
    let every = match asked {
        _ if model.planes.is_empty() => 1,
        Asked::Steps(steps) if steps.is_multiple_of(checkpoints) => steps / checkpoints,
        Asked::Steps(_) => 1,
        Asked::Tolerance(_) => LOOKS,
    };
    let settings = asked.settings(settings, checkpoints * every);
    let watch = Watch::new(model, &settings, checkpoints);
    let kept = Kept::default();
    let keep = Keep { kept: Arc::clone(&kept), every };
    let options = Options { ledger: true, digest: false, threads: Some(1), interrupted, progress: &watch };
    let summary = run_with(model, &settings, (keep, watch.on_planes()), &options)?;
    Ok(match ended(&summary, &kept, checkpoints) {
        Probed::Finished(probe) => Probed::Finished((probe, watch.seen())),
        Probed::Diverged { stepping, reached } => Probed::Diverged { stepping, reached },
        Probed::Interrupted => Probed::Interrupted,
    })
}

/// Something that sees the frames of a run in either precision.
pub(super) trait Eye: Send + 'static {
    /// A frame.
    fn see<R: Sample>(&mut self, frame: &Frame<'_, R>);
}

impl<A: Eye, B: Eye> Eye for (A, B) {
    fn see<R: Sample>(&mut self, frame: &Frame<'_, R>) {
        self.0.see(frame);
        self.1.see(frame);
    }
}

fn run_with(model: &Model, settings: &Settings, eye: impl Eye, options: &Options<'_>) -> Result<Summary, RunError> {
    fn run_in<R: Stepped>(
        model: &Model,
        settings: &Settings,
        eye: impl Eye,
        options: &Options<'_>,
    ) -> Result<Summary, RunError> {
        let begin = |_: &_| Ok(vec![Box::new(Looking(eye)) as BoxedRecorder<R::Coordinate>]);
        run::<R>(model, settings, begin, options)
    }
    match settings.precision {
        Precision::F32 => run_in::<f32>(model, settings, eye, options),
        Precision::F32Compensated => run_in::<Compensated>(model, settings, eye, options),
        Precision::F64 => run_in::<f64>(model, settings, eye, options),
    }
}

fn ended(summary: &Summary, kept: &Kept, checkpoints: u64) -> Probed {
    let states = std::mem::take(&mut *kept.lock().unwrap_or_else(PoisonError::into_inner));
    match summary.ending {
        Ending::Interrupted => Probed::Interrupted,
        Ending::Finished if summary.unconverged == 0 && states.len() as u64 == checkpoints => Probed::Finished(Probe {
            states,
            stepping: summary.stepping,
            steps: if summary.parts > 0 { summary.parts } else { summary.steps },
            force_evaluations: summary.force_evaluations,
            iterations: summary.iterations,
            linear_work: summary.linear_iterations + summary.factorisations,
            workspace: summary.workspace,
        }),
        _ => Probed::Diverged { stepping: summary.stepping, reached: summary.time },
    }
}

struct Looking<E>(E);

impl<R: Sample, E: Eye> Recorder<R> for Looking<E> {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        self.0.see(frame);
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Ok(())
    }
}

type Kept = Arc<Mutex<Vec<State>>>;

/// Keeps every so many frames, without the start.
struct Keep {
    kept: Kept,
    every: u64,
}

impl Eye for Keep {
    fn see<R: Sample>(&mut self, frame: &Frame<'_, R>) {
        if frame.number > 0 && frame.number.is_multiple_of(self.every) {
            let wide = |vectors: &[[R; 3]]| vectors.iter().map(|vector| vector.map(R::to_f64)).collect();
            let state = State { positions: wide(frame.position), velocities: wide(frame.velocity) };
            self.kept.lock().unwrap_or_else(PoisonError::into_inner).push(state);
        }
    }
}

/// Nobody who is told how far a run is.
struct Silent;

impl Progress for Silent {
    fn reached(&self, _time: f64, _duration: f64) {}
}
