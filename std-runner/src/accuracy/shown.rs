//! What pilots show of steppers.

use super::pilot::{FLIGHT_ROUNDING, Flown, Pilots, highest};
use crate::bench::position_error;
use crate::scene::{Precision, StepperName};
use crate::simulate::RunError;

/// The steps of what pilots are compared with, as a part of the longest stable ones.
const REFERENCE: f64 = 0.7;
/// A run of no more of its longest steps is over before pilots are: the method of highest order is taken, as if its error in
/// such steps came to this part of the size of the scene.
const SHORT_RUN: (f64, f64) = (100.0, 0.1);
/// Errors grow in proportion to time, and by this much more, where motion stays what it is.
const GROWTH: f64 = 1.5;
/// It seldom does: scenes begin at rest. The first steps are for errors that grow by this power of the time more, and who is
/// chosen is so if they grow by that one: methods of low order would have to shorten their steps the most.
const DOUBT: [i32; 2] = [1, 2];
/// Implicit methods are worth a look where explicit ones take more steps.
const MANY_STEPS: f64 = 1e5;

/// What is known of a stepper.
pub(super) struct Shown {
    pub(super) stepper: StepperName,
    /// s
    pub(super) time_step: f64,
    /// What its error in such steps becomes by the end, if motion stays what it is, m.
    error: f64,
    /// What the rounding of `f32` becomes, m.
    pub(super) rounding: f64,
    /// How many times longer than what was seen the run is.
    longer: f64,
}

/// What pilots came to.
pub(super) enum Seen {
    /// Those that may be the cheapest.
    Steppers(Vec<Shown>),
    /// What they are to be compared with left the finite numbers.
    Diverged,
    /// They were ended from outside.
    Interrupted,
}

impl Shown {
    /// The steps (s) in which its error is that many metres at the end: to begin with, and as they may have to become.
    pub(super) fn steps_for(&self, error: f64, order: u32) -> [f64; 2] {
        DOUBT.map(|doubt| {
            let expected = self.longer.powi(doubt) * self.error;
            self.time_step * (error / expected).powf(1.0 / f64::from(order))
        })
    }
}

/// Flies pilots of the steppers that may be the cheapest for a scene of that size (m), or of `only` these if there are any.
///
/// # Errors
/// If the scene cannot be run at all.
pub(super) fn show(pilots: &mut Pilots<'_>, only: &[StepperName], size: f64) -> Result<Seen, RunError> {
    let best = highest(pilots.model);
    let steps = pilots.duration / pilots.limit(best);
    if only.len() != 1 && steps < SHORT_RUN.0 {
        let (time_step, error) = (pilots.limit(best), SHORT_RUN.1 * size);
        pilots.settings.duration = 0.0;
        let rounding = FLIGHT_ROUNDING * size;
        return Ok(Seen::Steppers(vec![Shown { stepper: best, time_step, error, rounding, longer: 1.0 }]));
    }
    let step = REFERENCE * pilots.limit(best);
    let reference = match pilots.fly(best, Precision::F64, step)? {
        Flown::Finished(states, _) => states,
        Flown::Diverged => return Ok(Seen::Diverged),
        Flown::Interrupted => return Ok(Seen::Interrupted),
    };
    let longer = pilots.longer();
    let rounding = match pilots.fly(best, Precision::F32, step)? {
        Flown::Finished(states, _) => GROWTH * longer * position_error(&reference, &states),
        Flown::Diverged => f64::INFINITY,
        Flown::Interrupted => return Ok(Seen::Interrupted),
    };
    let candidates = if only.is_empty() { candidates(pilots, best, steps) } else { only.to_vec() };
    let mut shown = Vec::new();
    for stepper in candidates {
        match pilots.fly(stepper, Precision::F64, pilots.limit(stepper))? {
            Flown::Finished(states, time_step) => {
                let error = GROWTH * longer * position_error(&reference, &states).max(f64::EPSILON * size);
                shown.push(Shown { stepper, time_step, error, rounding, longer });
            }
            Flown::Diverged => {}
            Flown::Interrupted => return Ok(Seen::Interrupted),
        }
    }
    Ok(Seen::Steppers(shown))
}

/// Those that may be the cheapest, where the best of them takes so many steps.
fn candidates(pilots: &Pilots<'_>, best: StepperName, steps: f64) -> Vec<StepperName> {
    let mut steppers = vec![StepperName::VelocityVerlet, best];
    if pilots.model.damped_springs() == 0 {
        steppers.push(StepperName::BlanesMoanS6);
    }
    if steps > MANY_STEPS {
        steppers.push(StepperName::TrBdf2);
    }
    steppers
}
