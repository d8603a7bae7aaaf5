//! One stepper in one precision, from the longest time step that it is stable at to where shorter ones gain nothing.

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use super::probe::{Probe, Probed, distance, probe};
use super::reference::{Reference, steps_of};
use crate::model::Model;
use crate::scene::{Precision, Settings, StepperName};
use crate::simulate::{RunError, largest_stable_step};

/// A run is repeated until it has taken this long in all, and its shortest time counts.
const REPEATED: Duration = Duration::from_millis(30);
/// So often at most.
const MOST_REPEATS: u32 = 9;
/// Steps are doubled so often at most.
const MOST_DOUBLINGS: u32 = 20;
/// The part of the stability bound that a sweep begins at.
const EDGE: f64 = 0.9;
/// Steps to begin with where nothing bounds them.
const UNBOUNDED: f64 = 16.0;

/// What runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contender {
    /// How it steps.
    pub stepper: StepperName,
    /// In which numbers.
    pub precision: Precision,
}

/// One run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// How many.
    pub steps: u64,
    /// s
    pub time_step: f64,
    /// The largest distance of any particle from the reference at any checkpoint, m; nothing for a run that diverged.
    pub error: Option<f64>,
    /// The shortest time of any repetition, s; of one that diverged until then.
    pub seconds: f64,
    /// Evaluations of all forces.
    pub force_evaluations: u64,
    /// Iterations of linear solvers, and factorisations.
    pub linear_work: u64,
}

/// All runs of a contender.
#[derive(Clone, Debug)]
pub struct Swept {
    /// Who ran.
    pub contender: Contender,
    /// From the longest time step to the shortest.
    pub points: Vec<Point>,
}

impl Contender {
    /// All that can step a scene.
    pub(super) fn all(model: &Model) -> Vec<Self> {
        let is_damped = model.damped_springs() > 0;
        let steppers = StepperName::ALL.iter().copied().filter(|stepper| !is_damped || stepper.knows_damping());
        steppers
            .flat_map(|stepper| Precision::ALL.iter().map(move |precision| Self { stepper, precision: *precision }))
            .collect()
    }
}

/// Nothing if it was interrupted.
pub(super) fn sweep(
    model: &Model,
    settings: &Settings,
    contender: Contender,
    reference: &Reference,
    longest: Duration,
    interrupted: &AtomicBool,
) -> Result<Option<Swept>, RunError> {
    let settings = Settings { stepper: contender.stepper, precision: contender.precision, ..settings.clone() };
    let mut swept = Swept { contender, points: Vec::new() };
    let mut steps = first_steps(&settings, reference);
    let mut worse = 0;
    for _ in 0..MOST_DOUBLINGS {
        let Some(point) = measure(model, &settings, steps, reference, interrupted)? else { return Ok(None) };
        let best = swept.points.iter().filter_map(|point| point.error).fold(f64::INFINITY, f64::min);
        worse = if point.error.is_some_and(|error| error > 0.7 * best) { worse + 1 } else { 0 };
        swept.points.push(point);
        let known = point.error.is_some_and(|error| error <= reference.floor());
        if known || worse == 2 || point.seconds > longest.as_secs_f64() {
            break;
        }
        steps *= 2;
    }
    Ok(Some(swept))
}

fn first_steps(settings: &Settings, reference: &Reference) -> u64 {
    let unbounded = settings.duration / UNBOUNDED;
    let limit = reference.bound.map_or(f64::INFINITY, |bound| match settings.stepper {
        // It has none of its own where anything is undamped.
        StepperName::ExplicitEuler => bound.semi_implicit_euler,
        stepper => largest_stable_step(stepper, &bound),
    });
    steps_of(settings.duration, unbounded.min(EDGE * limit))
}

/// Nothing if it was interrupted.
fn measure(
    model: &Model,
    settings: &Settings,
    steps: u64,
    reference: &Reference,
    interrupted: &AtomicBool,
) -> Result<Option<Point>, RunError> {
    let time_step = settings.duration / steps as f64;
    let mut point = Point { steps, time_step, error: None, seconds: 0.0, force_evaluations: 0, linear_work: 0 };
    let (mut spent, mut shortest) = (Duration::ZERO, Duration::MAX);
    for _ in 0..MOST_REPEATS {
        let Probe { positions, stepping, force_evaluations, linear_work } =
            match probe(model, settings, steps, interrupted)? {
                Probed::Finished(probe) => probe,
                Probed::Diverged(stepping) => return Ok(Some(Point { seconds: stepping.as_secs_f64(), ..point })),
                Probed::Interrupted => return Ok(None),
            };
        shortest = shortest.min(stepping);
        spent += stepping;
        let error = distance(&positions, &reference.positions);
        // Farther off than the scene is large, it is as good as diverged.
        point.error = Some(error).filter(|error| *error < 10.0 * reference.size);
        (point.force_evaluations, point.linear_work) = (force_evaluations, linear_work);
        if spent >= REPEATED {
            break;
        }
    }
    point.seconds = shortest.as_secs_f64();
    Ok(Some(point))
}
