//! How error and energy go with time, for runs that cost about the same.

use super::Course;
use super::asked::Asked;
use super::contender::Contender;
use super::error::position_error;
use super::point::Point;
use super::probe::{Probed, watched};
use super::reference::Reference;
use super::sweep::Swept;
use super::winners::fastest;
use crate::scene::{CollisionForm, Precision};
use crate::simulate::RunError;

/// The error, as a part of the scene's size, whose cheapest run says what the others may cost.
const AIM: f64 = 1e-4;
/// Runs that cost more than so many times as much, or as little, are no match.
const ALIKE: f64 = 3.0;
/// Moments at most: a power of two, and a divisor of those of references.
const MOST: u64 = 32;

/// One run, moment by moment.
#[derive(Clone, Debug)]
pub struct Trace {
    /// Who ran.
    pub contender: Contender,
    /// Nearly what the run that was measured was asked for, so that every moment is the end of a step.
    pub asked: Asked,
    /// s, on average.
    pub time_step: f64,
    /// What it takes, about, s.
    pub seconds: f64,
    /// s
    pub times: Vec<f64>,
    /// The largest distance of a particle from the reference, m.
    pub errors: Vec<f64>,
    /// What the integrator has added to the energy (lost, if negative), J.
    pub energy: Vec<f64>,
}

/// The run that the others are compared with: the cheapest whose error is at most a ten-thousandth of the scene's size.
#[must_use]
pub fn yardstick(swept: &[Swept], reference: &Reference) -> Option<(Contender, Point)> {
    (0..=10).find_map(|exponent| fastest(swept, AIM * reference.size * 10.0_f64.powi(exponent)))
}

/// The run of every stepper, in `f64`, that costs most nearly what the yardstick costs; nothing if it was interrupted.
pub(super) fn traces(
    course: &Course<'_>,
    reference: &Reference,
    swept: &[Swept],
) -> Result<Option<Vec<Trace>>, RunError> {
    let mut traces = Vec::new();
    let Some((_, yardstick)) = yardstick(swept, reference) else { return Ok(Some(traces)) };
    for swept in swept.iter().filter(|swept| is_shown(swept.contender)) {
        let finished = swept.points.iter().filter(|point| point.error.is_some());
        let ratio = |point: &Point| (point.seconds / yardstick.seconds).ln().abs();
        let nearest = finished.min_by(|left, right| ratio(left).total_cmp(&ratio(right)));
        let Some(point) = nearest.filter(|point| ratio(point) <= ALIKE.ln()) else { continue };
        match trace(course, reference, swept.contender, point)? {
            Some(trace) => traces.extend(trace),
            None => return Ok(None),
        }
    }
    Ok(Some(traces))
}

fn is_shown(contender: Contender) -> bool {
    contender.precision == Precision::F64
        && contender.collision.is_none_or(|collision| collision == CollisionForm::TimeOfImpact)
}

/// Nothing in it if it diverges, nothing if it was interrupted.
fn trace(
    course: &Course<'_>,
    reference: &Reference,
    contender: Contender,
    point: &Point,
) -> Result<Option<Option<Trace>>, RunError> {
    let settings = contender.settings(course.settings);
    let moments = if contender.is_adaptive { MOST } else { MOST.min(1 << point.steps.max(1).ilog2()) };
    let asked = match point.asked {
        Asked::Steps(steps) => Asked::Steps(steps.next_multiple_of(moments)),
        tolerance => tolerance,
    };
    let (probe, seen) = match watched(course.model, &settings, asked, moments, course.interrupted)? {
        Probed::Finished(finished) => finished,
        Probed::Diverged { .. } => return Ok(Some(None)),
        Probed::Interrupted => return Ok(None),
    };
    let pairs = probe.states.iter().zip(reference.at(moments));
    let errors = pairs.map(|(state, trusted)| position_error(std::slice::from_ref(state), &[trusted])).collect();
    let times = (1..=moments).map(|moment| settings.duration * moment as f64 / moments as f64).collect();
    let steps = probe.steps.max(1) as f64;
    let (time_step, seconds) = (settings.duration / steps, point.seconds * steps / point.steps.max(1) as f64);
    Ok(Some(Some(Trace { contender, asked, time_step, seconds, times, errors, energy: seen.energy })))
}
