//! A case run by one stepper in one precision, and looked at after every step.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use hooke::{Compensated, Real, StepError};

use super::case::{CHECKPOINTS, Case};
use super::runner::Runner;
use crate::bench::Vectors;
use crate::scene::Precision;
use crate::simulate::{AnyResponse, AnyStepper, HeapWorld, world};

/// Between two looks at whether somebody interrupts.
const LOOK: Duration = Duration::from_millis(20);
/// A run that has been told to end, and has not by then, is left to itself: a single step takes too long, or hangs.
const GRACE: Duration = Duration::from_secs(20);
/// What implicit steps are solved to: in `f64`, and where there are fewer digits.
const TOLERANCES: [f64; 2] = [1e-9, 1e-6];

/// Vectors and velocities of all particles.
#[derive(Clone, Debug, Default)]
pub struct Moment {
    /// m
    pub position: Vectors,
    /// m/s
    pub velocity: Vectors,
}

/// What a run came to.
#[derive(Clone, Debug)]
pub enum Observed {
    /// It was not begun, for this reason.
    Refused(String),
    /// It was begun.
    Ran {
        /// The start, then each checkpoint that it reached.
        moments: Vec<Moment>,
        /// How it ended.
        end: End,
        /// Bounces.
        hits: u64,
        /// Steps whose equation was not solved to the tolerance.
        unconverged: u64,
        /// The most springs that a step counted as without length.
        degenerate: u32,
    },
    /// A single step took longer than anybody waits.
    Hung,
    /// It was interrupted.
    Interrupted,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// After its duration.
    Finished,
    /// A step was refused, at this time (s), and the state is as it was before.
    Refused {
        /// s
        time: f64,
        /// Why.
        error: StepError,
    },
    /// At this time (s) it had taken as long as it may.
    TookTooLong {
        /// s
        time: f64,
    },
    /// Something went wrong that nobody told of.
    Silent(String),
}

/// Runs a case, for so long at most.
pub fn observe(case: &Arc<Case>, runner: Runner, longest: Duration, interrupted: &AtomicBool) -> Observed {
    let ended = Arc::new(AtomicBool::new(false));
    let (sender, receiver) = channel();
    let (begun, other, flag) = (Instant::now(), Arc::clone(case), Arc::clone(&ended));
    thread::spawn(move || {
        let observed = match runner.precision {
            Precision::F32 => follow::<f32>(&other, runner, &flag),
            Precision::F32Compensated => follow::<Compensated>(&other, runner, &flag),
            Precision::F64 => follow::<f64>(&other, runner, &flag),
        };
        // Nobody may be waiting any more.
        let _ = sender.send(observed);
    });
    loop {
        match receiver.recv_timeout(LOOK) {
            Ok(_) if interrupted.load(Ordering::Relaxed) => return Observed::Interrupted,
            Ok(observed) => return observed,
            Err(RecvTimeoutError::Timeout) if begun.elapsed() > longest + GRACE => return Observed::Hung,
            Err(RecvTimeoutError::Timeout) => {
                let is_over = begun.elapsed() > longest || interrupted.load(Ordering::Relaxed);
                ended.store(is_over, Ordering::Relaxed);
            }
            Err(RecvTimeoutError::Disconnected) => {
                let end = End::Silent("it panicked".to_owned());
                return Observed::Ran { moments: Vec::new(), end, hits: 0, unconverged: 0, degenerate: 0 };
            }
        }
    }
}

fn follow<R: Real>(case: &Case, runner: Runner, ended: &AtomicBool) -> Observed {
    let mut world = match world::<R>(&case.model, case.gravity) {
        Ok(world) => world,
        Err(error) => return Observed::Refused(format!("{}: {}", error.place, error.reason)),
    };
    let [fine, coarse] = TOLERANCES;
    let tolerance = if runner.precision == Precision::F64 { fine } else { coarse };
    let mut stepper = AnyStepper::<R>::named(runner.stepper, tolerance);
    let mut response = AnyResponse::<R>::named(case.collision);
    let dt = case.time_step();
    let mut now = Moment::default();
    read(&mut world, &mut now);
    let mut moments = vec![now.clone()];
    let (mut hits, mut unconverged, mut degenerate) = (0, 0, 0);
    let mut end = End::Finished;
    for step in 1..=case.steps {
        let time = world.time();
        if ended.load(Ordering::Relaxed) {
            end = End::TookTooLong { time };
            break;
        }
        let until = step as f64 * dt;
        match world.view().step_to(stepper.any(), &mut response, R::from_f64(dt), until, &mut ()) {
            Ok(report) => {
                hits += u64::from(report.hits);
                unconverged += u64::from(!report.converged);
                degenerate = degenerate.max(report.degenerate_springs);
            }
            Err(error) => {
                let mut kept = Moment::default();
                read(&mut world, &mut kept);
                end = if same(&kept, &now) && world.time() == time {
                    End::Refused { time, error }
                } else {
                    End::Silent(format!("the step after {time} s was refused, and the state has changed all the same"))
                };
                break;
            }
        }
        if let Some(number) = read(&mut world, &mut now) {
            end =
                End::Silent(format!("particle {number} is not finite after the step to {until} s, and nobody said so"));
            break;
        }
        if step % (case.steps / CHECKPOINTS) == 0 {
            moments.push(now.clone());
        }
    }
    Observed::Ran { moments, end, hits, unconverged, degenerate }
}

/// Reads all states, and tells of the first particle whose state is not finite.
fn read<R: Real>(world: &mut HeapWorld<R>, moment: &mut Moment) -> Option<usize> {
    moment.position.clear();
    moment.velocity.clear();
    for (position, velocity) in world.view().states() {
        let (position, velocity): ([R::Coordinate; 3], [R::Coordinate; 3]) = (position.into(), velocity.into());
        moment.position.push(position.map(Real::to_f64));
        moment.velocity.push(velocity.map(Real::to_f64));
    }
    let is_finite = |vector: &[f64; 3]| vector.iter().all(|component| component.is_finite());
    let mut states = moment.position.iter().zip(&moment.velocity);
    states.position(|(position, velocity)| !is_finite(position) || !is_finite(velocity))
}

/// To the bit.
fn same(left: &Moment, right: &Moment) -> bool {
    let bits = |vectors: &Vectors| vectors.iter().flatten().map(|value| value.to_bits()).collect::<Vec<_>>();
    bits(&left.position) == bits(&right.position) && bits(&left.velocity) == bits(&right.velocity)
}
