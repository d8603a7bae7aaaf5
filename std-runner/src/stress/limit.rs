//! The largest stable time step of a stepper, found by trying.

use std::sync::atomic::AtomicBool;

use hooke::StabilityBound;

use super::frequency::Frequency;
use super::frozen::Frozen;
use super::growth::{Growth, Trend, growth};
use super::theory::oscillator_limit;
use crate::scene::StepperName;
use crate::simulate::{BuildError, largest_stable_step};

/// The limit lies between two steps that differ by this part.
const TOLD_APART: f64 = 5e-4;
/// From one trial to the next, on the way to the first step that grows.
const STRIDE: f64 = 1.06;
/// The first trial, as a part of where theory has the limit.
const BELOW: f64 = 0.95;
/// The next ones: near a half turn of the fastest motion, methods of high order grow in a window as narrow as that, and are
/// stable again past it.
const ABOVE: [f64; 4] = [1.0005, 1.0015, 1.0025, 1.02];
/// Growth sets in slowly where at twice the limit its logarithm is no more than this.
const SLOW: f64 = 1e-3;
/// The longest steps that are tried, in radians of the highest frequency.
const LONGEST: f64 = 2000.0;
/// The shortest.
const SHORTEST: f64 = 2e-3;

/// What trying has shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Found {
    /// Steps up to this (s) are stable, and those past it grow.
    Limit(f64),
    /// Every step that was tried is stable, up to this one, s.
    Stable(f64),
    /// Every step that was tried grows, down to this one, s.
    Grows(f64),
}

/// A stepper's limit on the time step of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// Whose.
    pub stepper: StepperName,
    /// From the blocks, as `hooke check` has it, s: infinite where nothing limits it, 0 where every step may grow.
    pub bound: f64,
    /// From the measured highest frequency and its damping, s, by the formula of the damped oscillator where there is one.
    pub theory: f64,
    /// By bisection.
    pub found: Found,
    /// What a step does at 0.99 and at 1.01 times the limit; at the longest or shortest step tried where there is none.
    pub growth: [Growth; 2],
}

/// Finds the limit of a stepper; nothing if it was interrupted.
///
/// # Errors
/// If the scene cannot be stepped.
pub(super) fn limit(
    frozen: &Frozen,
    stepper: StepperName,
    frequency: &Frequency,
    blocks: &StabilityBound,
    work: f64,
    interrupted: &AtomicBool,
) -> Result<Option<Limit>, BuildError> {
    let bound = largest_stable_step(stepper, blocks);
    let theory = theory(stepper, frequency, blocks);
    let trial = |dt: f64| growth(frozen, frequency.highest, stepper, dt, work, interrupted);
    let Some(found) = search(theory, frequency.highest, trial)? else { return Ok(None) };
    let Some(found) = sharpened(found, trial)? else { return Ok(None) };
    let sides = match found {
        Found::Limit(limit) => [0.99 * limit, 1.01 * limit],
        Found::Stable(dt) | Found::Grows(dt) => [dt; 2],
    };
    let (Some(below), Some(above)) = (trial(sides[0])?, trial(sides[1])?) else { return Ok(None) };
    Ok(Some(Limit { stepper, bound, theory, found, growth: [below, above] }))
}

fn theory(stepper: StepperName, frequency: &Frequency, blocks: &StabilityBound) -> f64 {
    match stepper {
        // Measured with damping that need not follow stiffness.
        StepperName::SemiImplicitEuler | StepperName::VelocityVerlet => {
            largest_stable_step(stepper, &frequency.bound(blocks))
        }
        // What damps least limits it: that is known of every spring.
        StepperName::ExplicitEuler => blocks.explicit_euler,
        _ => oscillator_limit(stepper, frequency.damping_ratio).map_or_else(
            || largest_stable_step(stepper, &frequency.bound(blocks)),
            |radians| radians / frequency.highest,
        ),
    }
}

/// From where theory has it, up or down to a step on the other side, and in between.
fn search(
    theory: f64,
    frequency: f64,
    trial: impl Fn(f64) -> Result<Option<Growth>, BuildError>,
) -> Result<Option<Found>, BuildError> {
    let grows = |dt: f64| Ok(trial(dt)?.map(|growth| growth.trend == Trend::Growing));
    let [shortest, longest] = [SHORTEST, LONGEST].map(|radians| radians / frequency);
    let (mut stable, mut unstable) = (None, None);
    let mut dt = if theory.is_finite() { (BELOW * theory).max(shortest) } else { 2.0 / frequency };
    while stable.is_none() || unstable.is_none() {
        let Some(grows) = grows(dt)? else { return Ok(None) };
        let further = if grows {
            unstable = Some(dt);
            dt / STRIDE
        } else {
            stable = Some(dt);
            match theory {
                // Without a limit in theory it is enough to look at some.
                f64::INFINITY => dt * 10.0,
                theory => ABOVE.map(|part| part * theory).into_iter().find(|next| *next > dt).unwrap_or(dt * STRIDE),
            }
        };
        match (stable, unstable) {
            (None, Some(dt)) if further < shortest => return Ok(Some(Found::Grows(dt))),
            (Some(dt), None) if further > longest => return Ok(Some(Found::Stable(dt))),
            _ => dt = further,
        }
    }
    let (Some(mut stable), Some(mut unstable)) = (stable, unstable) else { return Ok(None) };
    while unstable / stable > 1.0 + TOLD_APART {
        let middle = (stable * unstable).sqrt();
        let Some(grows) = grows(middle)? else { return Ok(None) };
        if grows {
            unstable = middle;
        } else {
            stable = middle;
        }
    }
    Ok(Some(Found::Limit(stable)))
}

/// Past a limit where growth sets in slowly, as explicit Euler's does, the first that can be told of it is found too late:
/// the limit is where the parabola through zero and two larger growths crosses zero.
fn sharpened(
    found: Found,
    trial: impl Fn(f64) -> Result<Option<Growth>, BuildError>,
) -> Result<Option<Found>, BuildError> {
    let Found::Limit(limit) = found else { return Ok(Some(found)) };
    let steps = [2.0 * limit, 4.0 * limit];
    let (Some(at), Some(near)) = (trial(limit)?, trial(steps[0])?) else { return Ok(None) };
    if near.factor.ln() > SLOW.max(8.0 * at.resolution) {
        return Ok(Some(found));
    }
    let Some(far) = trial(steps[1])? else { return Ok(None) };
    let [near, far] = [near.factor.ln() / steps[0], far.factor.ln() / steps[1]];
    let crossing = steps[0] - near * (steps[1] - steps[0]) / (far - near);
    Ok(Some(if crossing > 0.3 * limit { Found::Limit(crossing.min(limit)) } else { Found::Grows(limit) }))
}
