//! Frames that may have to be taken back: held until the run is sure to keep them.

use std::io;
use std::ops::Range;
use std::time::{Duration, Instant};

use crate::record::{Background, BoxedRecorder, Element, Sample, Stopped};
use crate::simulate::{Anchor, Schedule, Taken};

/// Frames that are held take this many bytes at most.
const MOST_BYTES: u64 = 256 << 20;

/// Where something is (m), and how fast it moves (m/s).
pub(super) type Moment = ([f64; 3], [f64; 3]);

/// The frames of a run.
pub(super) struct Frames<S> {
    schedule: Schedule,
    /// What states are relative to.
    anchor: Anchor,
    /// Nothing where no frame is recorded: then none is made.
    background: Option<Background<S>>,
    /// The number of the next frame.
    next: u64,
    held: Vec<Held<S>>,
    waiting: Duration,
}

struct Held<S> {
    number: u64,
    time: f64,
    position: Vec<[S; 3]>,
    velocity: Vec<[S; 3]>,
}

impl<S: Sample> Frames<S> {
    pub(super) fn new(
        schedule: Schedule,
        anchor: Anchor,
        recorders: Vec<BoxedRecorder<S>>,
        particles: usize,
    ) -> io::Result<Self> {
        let background = Background::start_any(recorders, particles)?;
        Ok(Self { schedule, anchor, background, next: 0, held: Vec::new(), waiting: Duration::ZERO })
    }

    /// Whether further steps are in vain, as a frame could not be written.
    pub(super) fn have_stopped(&self) -> bool {
        self.background.as_ref().is_some_and(Background::has_stopped)
    }

    /// The times (s) of those frames that lie within a span, and whether one lies at its end.
    pub(super) fn within(&self, span: &Range<f64>) -> (Vec<f64>, bool) {
        let margin = 1e-9 * (span.end - span.start);
        let times = (self.next..self.schedule.frames()).map(|frame| self.schedule.frame_time(frame));
        let mut times: Vec<f64> = times.take_while(|time| *time <= span.end + margin).collect();
        let at_end = times.pop_if(|time| *time >= span.end - margin).is_some();
        (times, at_end)
    }

    /// Whether frames are recorded at all.
    pub(super) fn are_recorded(&self) -> bool {
        self.background.is_some()
    }

    /// The next frame: all particles, in the order of their numbers.
    pub(super) fn hold(&mut self, moments: impl Iterator<Item = Moment>) {
        let number = self.next;
        self.next += 1;
        if self.background.is_none() {
            return;
        }
        let began = Instant::now();
        let (mut position, mut velocity) = (Vec::new(), Vec::new());
        for (x, v) in moments {
            position.push(self.anchor.in_scene(x).map(S::from_f64));
            velocity.push(v.map(S::from_f64));
        }
        self.held.push(Held { number, time: self.schedule.frame_time(number), position, velocity });
        self.waiting += began.elapsed();
    }

    /// Passes over a frame that nobody records.
    pub(super) fn skip(&mut self, frames: usize) {
        self.next += frames as u64;
    }

    /// Whether no more can be held.
    pub(super) fn are_full(&self) -> bool {
        let bytes = |held: &Held<S>| 6 * <S as Element>::SIZE * held.position.len() as u64;
        self.held.iter().map(bytes).sum::<u64>() > MOST_BYTES
    }

    /// Those that are held are sure.
    pub(super) fn hand_over(&mut self) -> Result<(), Stopped> {
        let Some(background) = &mut self.background else { return Ok(()) };
        let began = Instant::now();
        for Held { number, time, position, velocity } in self.held.drain(..) {
            background.record(number, time, |positions, velocities| {
                *positions = position;
                *velocities = velocity;
            })?;
        }
        self.waiting += began.elapsed();
        Ok(())
    }

    /// Those after a time (s) are none.
    pub(super) fn take_back(&mut self, time: f64) {
        self.held.clear();
        while self.next > 0 && self.schedule.frame_time(self.next - 1) > time {
            self.next -= 1;
        }
    }

    /// Waits for the last ones to be written.
    pub(super) fn finish(self) -> Taken {
        Taken::of(self.background, self.next, self.waiting)
    }
}
