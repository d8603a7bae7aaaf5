//! Frames as comma-separated values: one row for each particle of each frame.

use std::io::{self, Write};

use super::{Frame, RecordError, Recorder, Sample};

const HEADER: &[u8] = b"frame,time,particle,x,y,z,vx,vy,vz\n";

/// Records to a file or to standard output, as text.
///
/// Each frame goes out in one piece when it is complete, so a recording that is cut short between two frames ends with
/// a whole one. Numbers are the shortest text that reads back to the same bits: time (s) as an `f64`, positions (m)
/// and velocities (m/s) in the run's own precision.
pub struct CsvRecorder<W> {
    writer: W,
    path: String,
    /// The frame being put together, with the header before the first one.
    text: Vec<u8>,
}

impl<W: Write> CsvRecorder<W> {
    /// Records to `writer`; `path` is what error messages call it.
    pub fn new(writer: W, path: String) -> Self {
        Self { writer, path, text: HEADER.to_vec() }
    }

    fn send(&mut self) -> Result<(), RecordError> {
        let sent = self.writer.write_all(&self.text).and_then(|()| self.writer.flush());
        self.text.clear();
        sent.map_err(|source| RecordError { path: self.path.clone(), source })
    }

    fn append<R: Sample>(&mut self, frame: &Frame<'_, R>) -> io::Result<()> {
        let text = &mut self.text;
        // Every row of a frame begins alike: made once, then copied.
        let start = text.len();
        write!(text, "{},", frame.number)?;
        frame.time.append_text(text);
        text.push(b',');
        let beginning = start..text.len();
        for (particle, (position, velocity)) in frame.position.iter().zip(frame.velocity).enumerate() {
            if particle > 0 {
                text.extend_from_within(beginning.clone());
            }
            write!(text, "{particle}")?;
            for coordinate in position.iter().chain(velocity) {
                text.push(b',');
                coordinate.append_text(text);
            }
            text.push(b'\n');
        }
        if frame.position.is_empty() {
            text.truncate(start);
        }
        Ok(())
    }
}

impl<R: Sample, W: Write> Recorder<R> for CsvRecorder<W> {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        self.append(frame).map_err(|source| RecordError { path: self.path.clone(), source })?;
        self.send()
    }

    fn finish(mut self: Box<Self>) -> Result<(), RecordError> {
        // A recording of no frame has its header still to come.
        self.send()
    }
}
