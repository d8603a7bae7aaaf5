//! One contender, from the longest time step that it is stable at, or the loosest tolerance, to where less gains nothing.

use super::Course;
use super::asked::Asked;
use super::contender::Contender;
use super::point::{CHECKPOINTS, Point, measure};
use super::reference::{Reference, steps_of};
use crate::scene::{Precision, Settings, StepperName};
use crate::simulate::{RunError, largest_stable_step};

/// Steps are doubled so often at most.
const MOST_DOUBLINGS: u32 = 20;
/// The part of the stability bound that a sweep begins at.
const EDGE: f64 = 0.9;
/// Steps to begin with where nothing bounds them.
const UNBOUNDED: f64 = 16.0;
/// A run whose error is not less than this part of the best is no gain.
const GAIN: f64 = 0.7;
/// After so many runs without gain a contender is done, where rounding explains it.
const IN_VAIN: u32 = 2;
/// And after so many where nothing does: steps may still be too long for what moves fastest.
const PUZZLING: u32 = 4;
/// An error of this part of the scene's size is all that there is to be wrong by: it says nothing of gain.
const ALL: f64 = 0.1;
/// Roundings add up to at most about so many times what the square root of their number makes of one.
const ROUNDINGS: f64 = 10.0;

/// All runs of a contender.
#[derive(Clone, Debug)]
pub struct Swept {
    /// Who ran.
    pub contender: Contender,
    /// From the longest time step, or the loosest tolerance, to the shortest or the tightest.
    pub points: Vec<Point>,
}

/// Puts the runs of a contender into `swept`, one by one, and tells of each; whether it came to its end.
pub(super) fn sweep(
    course: &Course<'_>,
    reference: &Reference,
    swept: &mut Swept,
    mut tell: impl FnMut(&Point),
) -> Result<bool, RunError> {
    let settings = swept.contender.settings(course.settings);
    let mut asked = match swept.contender.is_adaptive {
        true => Asked::LOOSEST,
        false => Asked::Steps(first_steps(&settings, reference)),
    };
    let mut in_vain = 0;
    for _ in 0..MOST_DOUBLINGS {
        let point = match course.kept.find(swept.contender, asked) {
            Some(kept) => kept,
            None => match measure(course.model, &settings, asked, reference, course.compared, course.interrupted)? {
                Some(measured) => measured,
                None => return Ok(false),
            },
        };
        let best = swept.points.iter().filter_map(|point| point.error).fold(f64::INFINITY, f64::min);
        let is_in_vain = |error: f64| error > GAIN * best && best < ALL * reference.size;
        in_vain = if point.error.is_some_and(is_in_vain) { in_vain + 1 } else { 0 };
        tell(&point);
        swept.points.push(point);
        let is_known = point.error.is_some_and(|error| error <= reference.floor());
        let is_rounding = in_vain >= IN_VAIN && best <= rounding(settings.precision, point.steps, reference);
        if is_known || is_rounding || in_vain >= PUZZLING || point.seconds > course.longest.as_secs_f64() {
            break;
        }
        let Some(finer) = asked.finer() else { break };
        asked = finer;
    }
    Ok(true)
}

/// What roundings may come to, m: a random walk of them, each grown as a change of the start does.
fn rounding(precision: Precision, steps: u64, reference: &Reference) -> f64 {
    let epsilon = if precision == Precision::F64 { f64::EPSILON } else { f64::from(f32::EPSILON) };
    ROUNDINGS * epsilon * reference.size * reference.growth.max(1.0) * (steps as f64).sqrt()
}

fn first_steps(settings: &Settings, reference: &Reference) -> u64 {
    let unbounded = settings.duration / UNBOUNDED;
    let limit = reference.bound.map_or(f64::INFINITY, |bound| match settings.stepper {
        // It has none of its own where anything is undamped.
        StepperName::ExplicitEuler => bound.semi_implicit_euler,
        stepper => largest_stable_step(stepper, &bound),
    });
    steps_of(settings.duration, unbounded.min(EDGE * limit), CHECKPOINTS)
}
