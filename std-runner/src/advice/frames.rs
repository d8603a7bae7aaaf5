//! How often the run is looked at, and what that costs.

use super::{Advice, Subject, Topic};
use crate::units::{bytes, counted, seconds, short};

/// Bytes of recordings that are worth a word.
const LARGE: u128 = 1_000_000_000;

/// More frames than steps: they show curves between the steps, not more of the physics.
pub(super) fn between_steps(subject: &Subject<'_>) -> Option<Advice> {
    let rate = subject.settings.frame_rate;
    let time_step = subject.start.time_step?;
    if rate * time_step <= 1.0 + 1e-9 {
        return None;
    }
    let message = format!(
        "{} frames per second are more than the {} steps per second that steps of {} make: frames between steps are \
         interpolated",
        short(rate),
        short(1.0 / time_step),
        seconds(time_step)
    );
    let remedy =
        format!("use --frame-rate {:.0} or less, or a shorter --time-step", (1.0 / time_step).floor().max(1.0));
    Some(Advice { topic: Topic::FramesBetweenSteps, message, remedy })
}

/// Recordings that may not fit.
pub(super) fn large(subject: &Subject<'_>) -> Option<Advice> {
    if subject.recorded_bytes < LARGE {
        return None;
    }
    let message = format!(
        "{} of {} take about {} of disk",
        counted(subject.start.schedule.frames(), "frame"),
        counted(subject.model.particles.len() as u64, "particle"),
        bytes(subject.recorded_bytes)
    );
    Some(Advice { topic: Topic::LargeRecordings, message, remedy: "use a lower --frame-rate".to_owned() })
}
