//! Recorders on a thread of their own, so that frames are written while others are made.

use std::io;
use std::panic::resume_unwind;
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

use super::queue::{Giver, Stopped, Taker, queue};
use super::{BoxedRecorder, Frame, RecordError, Sample};

/// Frames of few particles are held up to this many.
const MOST_FRAMES: u64 = 64;
/// Frames of many particles are held up to this many bytes, but at least one.
const MOST_BYTES: u64 = 64 << 20;

/// Recorders at work on a thread of their own, behind a bounded queue of frames.
///
/// Whoever makes frames waits only while the queue is full. Frames reach each recorder in order. The first that cannot
/// be written is the last one tried: the recordings are then finished as they are.
pub struct Background<R> {
    frames: Giver<Held<R>>,
    thread: JoinHandle<Recorded>,
}

/// What became of a recording.
#[derive(Debug)]
pub struct Recorded {
    /// The frames that every recorder has.
    pub frames: u64,
    /// Time that the recorders took.
    pub took: Duration,
    /// Whether everything could be written.
    pub result: Result<(), RecordError>,
}

/// A frame on its way.
#[derive(Default)]
struct Held<R> {
    number: u64,
    time: f64,
    position: Vec<[R; 3]>,
    velocity: Vec<[R; 3]>,
}

/// How many frames of so many particles of the precision `R` are held at most, the one being written among them.
#[must_use]
pub fn frames_held<R: Sample>(particles: usize) -> usize {
    let bytes = (particles as u64).saturating_mul(6 * R::SIZE).max(1);
    (MOST_BYTES / bytes).clamp(1, MOST_FRAMES) as usize
}

impl<R: Sample> Background<R> {
    /// Starts the thread, for frames of so many particles.
    ///
    /// # Errors
    /// When the system has no thread to spare.
    pub fn start(recorders: Vec<BoxedRecorder<R>>, particles: usize) -> io::Result<Self> {
        let (frames, taker) = queue(frames_held::<R>(particles));
        let thread = Builder::new().name("recording".to_owned()).spawn(move || write(recorders, taker))?;
        Ok(Self { frames, thread })
    }

    /// The same, if there are recorders at all.
    ///
    /// # Errors
    /// As [`Background::start`].
    pub fn start_any(recorders: Vec<BoxedRecorder<R>>, particles: usize) -> io::Result<Option<Self>> {
        (!recorders.is_empty()).then(|| Self::start(recorders, particles)).transpose()
    }

    /// Hands over a frame: `fill` is to push all its positions (m) and velocities (m/s) to the two empty lists.
    /// Waits while as many frames as are held are on their way.
    ///
    /// # Errors
    /// When a recorder has failed; [`Background::finish`] says why.
    pub fn record(
        &mut self,
        number: u64,
        time: f64,
        fill: impl FnOnce(&mut Vec<[R; 3]>, &mut Vec<[R; 3]>),
    ) -> Result<(), Stopped> {
        let mut held = self.frames.empty()?;
        (held.number, held.time) = (number, time);
        held.position.clear();
        held.velocity.clear();
        fill(&mut held.position, &mut held.velocity);
        self.frames.give(held);
        Ok(())
    }

    /// Whether a recorder has failed, and further frames are in vain.
    #[must_use]
    pub fn has_stopped(&self) -> bool {
        self.frames.is_stopped()
    }

    /// Waits until every frame is written and the recordings are finished.
    ///
    /// # Panics
    /// If a recorder has.
    #[must_use]
    pub fn finish(self) -> Recorded {
        drop(self.frames);
        self.thread.join().unwrap_or_else(|panic| resume_unwind(panic))
    }
}

/// All that the thread does.
fn write<R: Sample>(mut recorders: Vec<BoxedRecorder<R>>, queue: Taker<Held<R>>) -> Recorded {
    let mut recorded = Recorded { frames: 0, took: Duration::ZERO, result: Ok(()) };
    let mut frames = Vec::new();
    while recorded.result.is_ok() {
        queue.take(&mut frames);
        if frames.is_empty() {
            break;
        }
        let began = Instant::now();
        recorded.result = frames.iter().try_for_each(|Held { number, time, position, velocity }| {
            let frame = Frame { number: *number, time: *time, position, velocity };
            recorders.iter_mut().try_for_each(|recorder| recorder.record(&frame))?;
            recorded.frames += 1;
            Ok(())
        });
        recorded.took += began.elapsed();
    }
    // From here on nobody is to wait for it.
    drop(queue);
    let began = Instant::now();
    let finished = recorders.into_iter().try_for_each(|recorder| recorder.finish());
    recorded.took += began.elapsed();
    recorded.result = recorded.result.and(finished);
    recorded
}
