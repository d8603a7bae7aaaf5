//! Recording frames: one file an output format, behind one trait.

use hooke::Real;

mod background;
mod csv;
mod decimal;
mod gif;
mod npz;
mod png;
mod queue;
mod sample;

pub use background::{Background, Recorded, frames_held};
pub use csv::CsvRecorder;
pub use gif::GifRecorder;
pub use npz::NpzRecorder;
pub use png::PngRecorder;
pub use queue::Stopped;
pub use sample::{Element, Sample};

/// One moment of a run.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a, R> {
    /// 0 is the start.
    pub number: u64,
    /// s
    pub time: f64,
    /// m, by particle number.
    pub position: &'a [[R; 3]],
    /// m/s, by particle number.
    pub velocity: &'a [[R; 3]],
}

/// Something that frames are written to, in order, as they are made.
pub trait Recorder<R: Real> {
    /// Writes one frame.
    ///
    /// # Errors
    /// When it can't be written: the disk is full, say. The frames before it stay readable.
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError>;

    /// Writes what belongs after the last frame.
    ///
    /// # Errors
    /// When it can't be written.
    fn finish(self: Box<Self>) -> Result<(), RecordError>;
}

/// A recorder that can work on a thread of its own.
pub type BoxedRecorder<R> = Box<dyn Recorder<R> + Send>;

/// A frame could not be written.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {path}: {source}")]
pub struct RecordError {
    /// Where to.
    pub path: String,
    /// Why.
    pub source: std::io::Error,
}
