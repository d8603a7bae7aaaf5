//! One run of a scene: where everything was at its checkpoints, and what that took.

use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use hooke::Compensated;

use crate::model::Model;
use crate::record::{BoxedRecorder, Frame, RecordError, Recorder, Sample};
use crate::scene::{Precision, Settings, TimeStep};
use crate::simulate::{Ending, Options, Progress, RunError, Stepped, run};

/// Evenly spaced times at which states are compared; the last is the end. Runs have a multiple of so many steps.
pub const CHECKPOINTS: u64 = 4;

/// Positions by particle number, m.
pub type Positions = Vec<[f64; 3]>;

/// What a run came to.
#[derive(Clone, Debug)]
pub struct Probe {
    /// At each checkpoint.
    pub positions: Vec<Positions>,
    /// Time spent stepping.
    pub stepping: Duration,
    /// Evaluations of all forces.
    pub force_evaluations: u64,
    /// Iterations of linear solvers, and factorisations.
    pub linear_work: u64,
}

/// What became of it.
pub enum Probed {
    /// It reached the end.
    Finished(Probe),
    /// It left the finite numbers, or could not solve a step; after this time.
    Diverged(Duration),
    /// It was ended from outside.
    Interrupted,
}

/// Runs a scene in so many steps, on one thread, without a ledger.
pub fn probe(model: &Model, settings: &Settings, steps: u64, interrupted: &AtomicBool) -> Result<Probed, RunError> {
    let settings = Settings {
        time_step: TimeStep::Seconds(settings.duration / steps as f64),
        frame_rate: CHECKPOINTS as f64 / settings.duration,
        ..settings.clone()
    };
    match settings.precision {
        Precision::F32 => probe_in::<f32>(model, &settings, interrupted),
        Precision::F32Compensated => probe_in::<Compensated>(model, &settings, interrupted),
        Precision::F64 => probe_in::<f64>(model, &settings, interrupted),
    }
}

fn probe_in<R: Stepped>(model: &Model, settings: &Settings, interrupted: &AtomicBool) -> Result<Probed, RunError> {
    let kept = Arc::new(Mutex::new(Vec::new()));
    let recorder = Keep(Arc::clone(&kept));
    let begin = |_: &_| Ok(vec![Box::new(recorder) as BoxedRecorder<R::Coordinate>]);
    let options = Options { ledger: false, threads: Some(1), interrupted, progress: &Silent };
    let summary = run::<R>(model, settings, begin, &options)?;
    let mut positions = std::mem::take(&mut *kept.lock().unwrap_or_else(PoisonError::into_inner));
    // The start tells nothing.
    positions.drain(..1.min(positions.len()));
    Ok(match summary.ending {
        Ending::Interrupted => Probed::Interrupted,
        Ending::Finished if summary.unconverged == 0 && positions.len() as u64 == CHECKPOINTS => {
            Probed::Finished(Probe {
                positions,
                stepping: summary.stepping,
                force_evaluations: summary.force_evaluations,
                linear_work: summary.linear_iterations + summary.factorisations,
            })
        }
        _ => Probed::Diverged(summary.stepping),
    })
}

/// The largest distance between two particles of one number at any checkpoint, m.
pub fn distance(left: &[Positions], right: &[Positions]) -> f64 {
    let pairs = left.iter().flatten().zip(right.iter().flatten());
    let squares = pairs.map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>());
    // What is not a number is no small distance.
    squares.fold(0.0, |largest: f64, square| if square.is_nan() { f64::INFINITY } else { largest.max(square) }).sqrt()
}

struct Keep(Arc<Mutex<Vec<Positions>>>);

impl<R: Sample> Recorder<R> for Keep {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        let positions = frame.position.iter().map(|position| position.map(R::to_f64)).collect();
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(positions);
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Ok(())
    }
}

/// Nobody who is told how far a run is.
struct Silent;

impl Progress for Silent {
    fn reached(&self, _time: f64, _duration: f64) {}
}
