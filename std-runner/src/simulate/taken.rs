//! What became of the frames of a run.

use std::time::{Duration, Instant};

use crate::record::{Background, RecordError, Sample};

/// The frames of a run, after it.
pub struct Taken {
    /// Those that were made, and that every recording has.
    pub frames: u64,
    /// Time that stepping waited for them.
    pub waiting: Duration,
    /// Time that recorders took.
    pub recording: Duration,
    /// Whether they could be written.
    pub result: Result<(), RecordError>,
}

impl Taken {
    /// Waits for the last ones to be written, if they are recorded; so many have been made, and stepping has waited so long.
    pub fn of<S: Sample>(background: Option<Background<S>>, made: u64, waiting: Duration) -> Self {
        let Some(background) = background else {
            return Self { frames: made, waiting, recording: Duration::ZERO, result: Ok(()) };
        };
        let began = Instant::now();
        let recorded = background.finish();
        let waiting = waiting + began.elapsed();
        Self { frames: recorded.frames, waiting, recording: recorded.took, result: recorded.result }
    }
}
