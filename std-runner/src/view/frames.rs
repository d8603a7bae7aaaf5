//! The frames of a run as a stream of bytes, each made when there is room for it.

use std::io::{self, Read};
use std::sync::atomic::AtomicBool;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use hooke::{Balance, Compensated};

use super::server::Tell;
use super::shown::Shown;
use crate::record::{BoxedRecorder, Frame, RecordError, Recorder, Sample};
use crate::scene::Precision;
use crate::simulate::{Ending, Options, Progress, RunError, Stepped, Summary, run};

/// Frames that are made and not yet sent.
const AHEAD: usize = 32;
/// A frame does not wait longer for its energies: where many lie within one step, those come after them.
const PATIENCE: Duration = Duration::from_millis(20);
/// Time and ledger.
const NUMBERS: usize = 8;

/// Begins a run of a scene and reads its frames: eight `f64` (time; kinetic, elastic and gravitational energy, lost to
/// damping and in impacts, made by the stepper, total; NaN where not known), then positions in `f32`, by particle number.
///
/// After the last frame comes one whose time is NaN where the run did not reach its end; then the next numbers are the
/// particle whose state would have been no number, −1 if it was not that, and the time of the last whole step. `tell` hears
/// why.
pub(super) fn frames(shown: Arc<Shown>, tell: Tell, interrupted: &'static AtomicBool) -> impl Read {
    let (send, receive) = sync_channel(AHEAD);
    let (balance, balances) = channel();
    thread::spawn(move || {
        let last = send.clone();
        let particles = shown.model.particles.len();
        let ran = match shown.settings.precision {
            Precision::F32 => stepped::<f32>(&shown, send, balance, interrupted),
            Precision::F32Compensated => stepped::<Compensated>(&shown, send, balance, interrupted),
            Precision::F64 => stepped::<f64>(&shown, send, balance, interrupted),
        };
        tell(&shown, &ran);
        if let Some(end) = early_end(&ran, particles) {
            // Nobody may be there any more to read it.
            let _ = last.send(end);
        }
    });
    Stream { receive, told: balances, row: None, bytes: Vec::new(), at: 0 }
}

fn stepped<R: Stepped>(
    shown: &Shown,
    send: SyncSender<Made>,
    tell: Sender<(f64, Balance)>,
    interrupted: &AtomicBool,
) -> Result<Summary, RunError> {
    let balances = Balances { tell: Mutex::new((tell, 1)), frame_rate: shown.settings.frame_rate };
    let options = Options { ledger: true, digest: false, threads: None, interrupted, progress: &balances };
    let recorder: BoxedRecorder<R::Coordinate> = Box::new(StreamRecorder { send });
    run::<R>(&shown.model, &shown.settings, |_| Ok(vec![recorder]), &options)
}

/// What says that a run ended before its time.
fn early_end(ran: &Result<Summary, RunError>, particles: usize) -> Option<Made> {
    let (particle, reached) = match ran {
        Ok(summary) => {
            let particle = match summary.ending {
                Ending::NonFinite { particle } => f64::from(particle),
                Ending::Refused(_) => -1.0,
                _ => return None,
            };
            (particle, summary.schedule.step_end(summary.steps))
        }
        // Nobody reads any more.
        Err(RunError::Record { .. }) => return None,
        // Nothing has been stepped.
        Err(_) => (-1.0, 0.0),
    };
    let positions = vec![0; 12 * particles];
    Some(Made { time: f64::NAN, end: Some([particle, reached]), positions })
}

/// A frame on its way.
struct Made {
    time: f64,
    end: Option<[f64; 2]>,
    positions: Vec<u8>,
}

struct StreamRecorder {
    send: SyncSender<Made>,
}

impl<R: Sample> Recorder<R> for StreamRecorder {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        let numbers = frame.position.iter().flatten().map(|coordinate| coordinate.to_f64() as f32);
        let positions = numbers.flat_map(f32::to_le_bytes).collect();
        self.send
            .send(Made { time: frame.time, end: None, positions })
            .map_err(|_| RecordError { path: "the page".to_owned(), source: io::ErrorKind::BrokenPipe.into() })
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Ok(())
    }
}

/// Tells the ledger once for each frame, and the number of the next frame to tell it for.
struct Balances {
    tell: Mutex<(Sender<(f64, Balance)>, u64)>,
    frame_rate: f64,
}

impl Progress for Balances {
    fn reached(&self, _: f64, _: f64) {}

    fn balanced(&self, time: f64, balance: &mut dyn FnMut() -> Balance) {
        let mut state = self.tell.lock().unwrap_or_else(PoisonError::into_inner);
        let (tell, next) = &mut *state;
        if time * self.frame_rate < *next as f64 * (1.0 - 1e-9) {
            return;
        }
        *next = (time * self.frame_rate) as u64 + 1;
        // Where nobody reads any more, the recorder ends the run.
        let _ = tell.send((time, balance()));
    }
}

/// The bytes of one frame after the other.
struct Stream {
    receive: Receiver<Made>,
    told: Receiver<(f64, Balance)>,
    /// The last ledger that was read, of this time or before it.
    row: Option<(f64, Balance)>,
    bytes: Vec<u8>,
    at: usize,
}

impl Stream {
    /// The ledger at a time (s), as soon as it is known.
    fn balance(&mut self, time: f64) -> Option<Balance> {
        let same = 1e-9 * time.abs();
        while self.row.is_none_or(|(of, _)| of < time - same) {
            self.row = Some(self.told.recv_timeout(PATIENCE).ok()?);
        }
        self.row.map(|(_, balance)| balance)
    }

    fn numbers(&mut self, made: &Made) -> [f64; NUMBERS] {
        if let Some([particle, reached]) = made.end {
            return [f64::NAN, particle, reached, 0.0, 0.0, 0.0, 0.0, 0.0];
        }
        // At the start nothing has been told yet.
        let Some(known) = (made.time > 0.0).then(|| self.balance(made.time)).flatten() else {
            let mut unknown = [f64::NAN; NUMBERS];
            unknown[0] = made.time;
            return unknown;
        };
        let Balance { kinetic, elastic, gravitational, lost_to_damping, lost_in_impacts, .. } = known;
        let total = kinetic + elastic + gravitational;
        [made.time, kinetic, elastic, gravitational, lost_to_damping, lost_in_impacts, known.remainder(), total]
    }
}

impl Read for Stream {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.at == self.bytes.len() {
            // All recorders are gone: that was the last frame.
            let Ok(made) = self.receive.recv() else { return Ok(0) };
            let numbers = self.numbers(&made);
            self.bytes.clear();
            self.bytes.extend(numbers.into_iter().flat_map(f64::to_le_bytes));
            self.bytes.extend_from_slice(&made.positions);
            self.at = 0;
        }
        let count = self.bytes.len().saturating_sub(self.at).min(buffer.len());
        buffer[..count].copy_from_slice(&self.bytes[self.at..self.at + count]);
        self.at += count;
        Ok(count)
    }
}
