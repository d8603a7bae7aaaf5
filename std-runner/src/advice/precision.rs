//! Whether the numbers of `f32` lie close enough together.

use super::{Advice, Subject, Topic};
use crate::model::{Hold, Model};
use crate::scene::{Precision, Settings};
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
    let coarse = (0_usize..).zip(springs).filter_map(|(number, spring)| {
        let ends = spring.between.map(|end| particles.get(end as usize).map_or(0.0, |end| farthest(end.position)));
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
    let free = || model.particles.iter().filter(|particle| particle.hold == Hold::Free);
    let fastest = free().map(|particle| length(particle.velocity)).fold(0.0, f64::max);
    let speed = fastest.max(length(settings.gravity) * settings.duration);
    let distance = free().map(|particle| farthest(particle.position)).fold(0.0, f64::max);
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

/// Whether a time step (s) is no positive number any more in the precision of the run: no step can be taken.
#[must_use]
pub fn vanishing_time_step(settings: &Settings, time_step: f64) -> bool {
    settings.precision != Precision::F64 && !(time_step as f32 > 0.0 && (time_step as f32).is_finite())
}
