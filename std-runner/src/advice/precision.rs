//! Whether the numbers of `f32` lie close enough together.

use super::{Advice, Subject, Topic};
use crate::model::{Hold, Model};
use crate::scene::{Precision, Settings};
use crate::simulate::{Anchor, AnyStepper, chooses_steps};
use crate::units::{metres, seconds};

/// The part of a spring's length that rounding may take before it is worth a word.
const COARSE: f64 = 1e-4;

/// Neighbouring `f32` near a value lie this far apart.
fn spacing(value: f64) -> f64 {
    let value = value.abs() as f32;
    f64::from(value.next_up()) - f64::from(value)
}

fn farthest(position: [f64; 3]) -> f64 {
    position.iter().fold(0.0, |farthest, coordinate| farthest.max(coordinate.abs()))
}

/// Springs so far from the origin that their lengths are mostly rounding.
pub(super) fn coarse_positions(subject: &Subject<'_>) -> Option<Advice> {
    if subject.settings.precision != Precision::F32 {
        return None;
    }
    let Model { particles, springs, .. } = subject.model;
    let anchor = Anchor::of(subject.model);
    let coarse = (0_usize..).zip(springs).filter_map(|(number, spring)| {
        let ends = spring
            .between
            .map(|end| particles.get(end as usize).map_or(0.0, |end| farthest(anchor.from_there(end.position))));
        let distance = ends[0].max(ends[1]);
        let gap = spacing(distance);
        (spring.rest_length > 0.0).then(|| (gap / spring.rest_length, number, distance, gap, spring.rest_length))
    });
    let (part, number, distance, gap, length) = coarse.max_by(|a, b| a.0.total_cmp(&b.0))?;
    if part <= COARSE {
        return None;
    }
    let message = format!(
        "positions near {} are {} apart in f32, 1 part in {:.0} of the length of spring {number}, {}: its force will \
         be that rough",
        metres(distance),
        metres(gap),
        1.0 / part,
        metres(length),
    );
    let remedy = "use --precision f64 or f32-compensated, or move the scene closer to the origin".to_owned();
    Some(Advice { topic: Topic::CoarsePositions, message, remedy })
}

/// Steps so short that `x + dt v` is `x`, at any speed that the run could reach by falling.
pub(super) fn lost_motion(subject: &Subject<'_>) -> Option<Advice> {
    let Subject { model, settings, start, .. } = subject;
    if settings.precision != Precision::F32 {
        return None;
    }
    let time_step = start.time_step?;
    let length = |[x, y, z]: [f64; 3]| x.hypot(y).hypot(z);
    let anchor = Anchor::of(model);
    let free = || model.particles.iter().filter(|particle| particle.hold == Hold::Free);
    let fastest = free().map(|particle| length(particle.velocity)).fold(0.0, f64::max);
    let speed = fastest.max(length(settings.gravity) * settings.duration);
    let distance = free().map(|particle| farthest(anchor.from_there(particle.position))).fold(0.0, f64::max);
    let gap = spacing(distance);
    if speed == 0.0 || speed * time_step >= gap {
        return None;
    }
    let message = format!(
        "a step of {} moves no particle by more than about {}, and positions near {} are {} apart in f32: the motion \
         there is lost in rounding",
        seconds(time_step),
        metres(speed * time_step),
        metres(distance),
        metres(gap),
    );
    let remedy = "use --precision f64 or f32-compensated, or a longer --time-step".to_owned();
    Some(Advice { topic: Topic::LostMotion, message, remedy })
}

/// Steps so short that what their roundings add up to is more than what the stepper is wrong by, even if everything
/// swings as far and as fast as it can: shorter ones still make it worse.
///
/// The error of order p is (ω dt)ᵖ/(p + 2)! of a swing, for each of the ωT radians of the run (it is that of an oscillator
/// but for a factor near 1); T/dt roundings of places walk as far as the root of their number.
pub(super) fn below_rounding(subject: &Subject<'_>) -> Option<Advice> {
    let Subject { model, settings, start, .. } = subject;
    if settings.precision != Precision::F32 {
        return None;
    }
    let (time_step, bound) = (start.time_step?, start.bound?);
    let mut stepper = AnyStepper::<f32>::named(settings.stepper, settings.tolerance);
    let order = f64::from(stepper.any().order());
    let factorial: f64 = (1..=order as u32 + 2).map(f64::from).product();
    let anchor = Anchor::of(model);
    let distance =
        model.particles.iter().map(|particle| farthest(anchor.from_there(particle.position))).fold(0.0, f64::max);
    let rounding = 0.5 * f64::from(f32::EPSILON) * distance * settings.duration.sqrt();
    let swing = bound.frequency.powf(order + 1.0) * settings.duration * widest(model);
    let best = (rounding * factorial / swing).powf(1.0 / (order + 0.5));
    // Past it by a factor, as the estimate is one.
    if !(time_step < 0.5 * best && best.is_finite()) {
        return None;
    }
    let message = format!(
        "in f32, steps of {} add more rounding than they take away error: {} gains nothing below about {}",
        seconds(time_step),
        settings.stepper,
        seconds(best),
    );
    let remedy = format!("use --precision f32-compensated or f64, or --time-step {best:.1e}");
    Some(Advice { topic: Topic::BelowRounding, message, remedy })
}

/// Errors of steps that are to be smaller than the roundings of places.
pub(super) fn fine_tolerance(subject: &Subject<'_>) -> Option<Advice> {
    let Settings { precision, stepper, tolerance, .. } = subject.settings;
    let rounding = f64::from(f32::EPSILON);
    if *precision != Precision::F32 || !chooses_steps(subject.settings) || *tolerance >= rounding {
        return None;
    }
    let message = format!(
        "{stepper} is to keep errors below {tolerance:e} of the scene's size, and f32 rounds places by {rounding:.0e} of \
         it in every step"
    );
    let remedy = "use --precision f32-compensated or f64, or a looser --tolerance".to_owned();
    Some(Advice { topic: Topic::FineTolerance, message, remedy })
}

/// The longest edge of the box around all particles, m.
fn widest(model: &Model) -> f64 {
    model.extents().into_iter().map(|(least, most)| most - least).fold(0.0, f64::max)
}

/// Whether a time step (s) is no positive number any more in the precision of the run: no step can be taken.
#[must_use]
pub fn vanishing_time_step(settings: &Settings, time_step: f64) -> bool {
    settings.precision != Precision::F64 && !(time_step as f32 > 0.0 && (time_step as f32).is_finite())
}
