//! One run that was measured: what it cost, and how wrong it is.

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use super::asked::Asked;
use super::error::{position_error, velocity_error};
use super::probe::{LOOKS, Probe, Probed, probe, watched};
use super::reference::Reference;
use super::watch::Seen;
use crate::model::Model;
use crate::scene::Settings;
use crate::simulate::RunError;

/// Evenly spaced times at which runs are compared with the reference; the last is the end. Runs have a multiple of so many
/// steps. With few of them a run may be right by chance: where things turn round, being early or late hardly shows.
pub const CHECKPOINTS: u64 = 16;
/// A run is repeated until it has taken this long in all, s, and its shortest time counts.
const REPEATED: f64 = 0.1;
/// So often at most: what is shorter than a twentieth of that is repeated so often.
const MOST_REPEATS: u32 = 20;
/// When a run is compared with the reference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Compared {
    /// At each of its checkpoints, and the largest error counts.
    #[default]
    Throughout,
    /// At the end only, as peers are.
    AtEnd,
}

/// Farther off than so many times the size of the scene, a run is as good as diverged.
const LOST: f64 = 10.0;

/// One run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// What it was asked for.
    pub asked: Asked,
    /// How many it took.
    pub steps: u64,
    /// s, on average.
    pub time_step: f64,
    /// The largest distance of any particle from the reference when it is compared, m; nothing for a run that diverged.
    pub error: Option<f64>,
    /// The largest difference of any particle's velocity, m/s.
    pub velocity_error: Option<f64>,
    /// The most that the integrator added to the energy (or took from it) at any checkpoint, J.
    pub energy_residual: Option<f64>,
    /// The largest difference in the time of a bounce, s; nothing where there is none to compare.
    pub bounce_time_error: Option<f64>,
    /// The largest depth of a particle beyond a plane after any step, m; nothing without planes.
    pub penetration: Option<f64>,
    /// The part of the duration that it reached: 1, if it did not diverge.
    pub survived: f64,
    /// The shortest time of any repetition, s; of one that diverged until then.
    pub seconds: f64,
    /// Evaluations of all forces.
    pub force_evaluations: u64,
    /// Newton iterations.
    pub iterations: u64,
    /// Iterations of linear solvers, and factorisations.
    pub linear_work: u64,
    /// What the stepper and the collision form own besides the world, bytes.
    pub workspace: usize,
}

/// Measures one run of a scene as its settings say, to a tolerance or in so many steps, a multiple of [`CHECKPOINTS`]; nothing
/// if it was interrupted.
///
/// # Errors
/// If the scene cannot be run at all.
pub fn measure(
    model: &Model,
    settings: &Settings,
    asked: impl Into<Asked>,
    reference: &Reference,
    compared: Compared,
    interrupted: &AtomicBool,
) -> Result<Option<Point>, RunError> {
    let asked = asked.into();
    // What costs time to see is seen in a run of its own, which is not timed.
    let (first, seen) = match watched(model, settings, asked, CHECKPOINTS, interrupted)? {
        Probed::Finished(finished) => finished,
        Probed::Diverged { stepping, reached } => {
            return Ok(Some(diverged(settings.duration, asked, stepping, reached)));
        }
        Probed::Interrupted => return Ok(None),
    };
    let mut point = judged(settings.duration, asked, &first, &seen, reference, compared);
    let (mut spent, mut shortest) = (0.0, f64::INFINITY);
    for _ in 0..MOST_REPEATS {
        let Some(seconds) = time_again(model, settings, asked, interrupted)? else { return Ok(None) };
        shortest = seconds.min(shortest);
        spent += seconds;
        if spent >= REPEATED {
            break;
        }
    }
    point.seconds = shortest;
    Ok(Some(point))
}

/// The time of one more run, s; nothing if it was interrupted, or did not end this time.
pub(super) fn time_again(
    model: &Model,
    settings: &Settings,
    asked: Asked,
    interrupted: &AtomicBool,
) -> Result<Option<f64>, RunError> {
    // Steps that are chosen may end at checkpoints: they are to be those that were looked at.
    let checkpoints = if asked.tolerance().is_some() { CHECKPOINTS } else { 1 };
    Ok(match probe(model, settings, asked, checkpoints, interrupted)? {
        Probed::Finished(again) => Some(again.stepping.as_secs_f64()),
        Probed::Diverged { .. } | Probed::Interrupted => None,
    })
}

fn diverged(duration: f64, asked: Asked, stepping: Duration, reached: f64) -> Point {
    let steps = if let Asked::Steps(steps) = asked { steps } else { 0 };
    Point {
        asked,
        steps,
        time_step: duration / steps.max(1) as f64,
        error: None,
        velocity_error: None,
        energy_residual: None,
        bounce_time_error: None,
        penetration: None,
        survived: reached / duration,
        seconds: stepping.as_secs_f64(),
        force_evaluations: 0,
        iterations: 0,
        linear_work: 0,
        workspace: 0,
    }
}

fn judged(duration: f64, asked: Asked, probe: &Probe, seen: &Seen, reference: &Reference, compared: Compared) -> Point {
    let (mut states, mut trusted) = (probe.states.as_slice(), reference.at(CHECKPOINTS));
    if compared == Compared::AtEnd {
        states = states.last().map_or(&[], std::slice::from_ref);
        trusted = reference.at(1);
    }
    let time_step = duration / probe.steps.max(1) as f64;
    let looked_at_every = if asked.tolerance().is_some() { duration / (CHECKPOINTS * LOOKS) as f64 } else { time_step };
    let bounces = seen.bounces.as_ref().zip(reference.bounces.as_ref());
    let is_lost = |error: &f64| *error >= LOST * reference.size;
    let error = Some(position_error(states, &trusted)).filter(|error| !is_lost(error));
    Point {
        steps: probe.steps,
        time_step,
        error,
        velocity_error: error.map(|_| velocity_error(states, &trusted)),
        energy_residual: Some(seen.energy_residual()),
        bounce_time_error: bounces.and_then(|(found, trusted)| found.error(trusted, looked_at_every)),
        penetration: seen.bounces.as_ref().map(|bounces| bounces.penetration),
        survived: 1.0,
        force_evaluations: probe.force_evaluations,
        iterations: probe.iterations,
        linear_work: probe.linear_work,
        workspace: probe.workspace,
        ..diverged(duration, asked, probe.stepping, duration)
    }
}
