//! Animated GIF: plays everywhere, and shows the run in real time.
//!
//! A GIF counts time in hundredths of a second, and most viewers slow down frames shorter than two of them.
//! So each frame is shown from its own time, rounded, and what one frame loses the next one gains; above
//! 50 frames per second, frames are left out evenly. The last frame is always kept, and shown for a second.

use std::borrow::Cow;
use std::io::{self, Write};

use ::gif::{Encoder, EncodingError, Repeat};
use hooke::Real;

use self::clock::Clock;
use self::palette::Palette;
use super::{Frame, RecordError, Recorder};
use crate::draw::Picture;

mod clock;
mod palette;

/// How long the last frame is shown, hundredths of a second.
const LAST_DELAY: u16 = 100;

/// Writes an animated GIF as its frames are made.
///
/// Whatever has been written can be played, even if the rest is never written.
pub struct GifRecorder<W: Write> {
    path: String,
    picture: Picture,
    clock: Clock,
    output: Output<W>,
    palette: Palette,
    /// What a viewer has on screen after all frames so far.
    shown: Vec<u8>,
    /// The last frame, not written before it is known how long it lasts.
    waiting: Option<Waiting>,
    /// The positions of a frame left out, in case it is the last.
    left_out: Option<(f64, Vec<[f64; 3]>)>,
}

/// The first frame decides the colours, which come first in the file.
enum Output<W: Write> {
    Untouched(W),
    Begun(Box<Encoder<W>>),
    /// Writing the beginning failed.
    Lost,
}

struct Waiting {
    frame: ::gif::Frame<'static>,
    slot: i64,
}

impl<W: Write> GifRecorder<W> {
    /// Writes to `writer`, which messages call `path`, at this many frames per second.
    pub fn new(writer: W, path: String, picture: Picture, frame_rate: f64) -> Self {
        Self {
            path,
            picture,
            clock: Clock::new(frame_rate),
            output: Output::Untouched(writer),
            palette: Palette::default(),
            shown: Vec::new(),
            waiting: None,
            left_out: None,
        }
    }

    /// Draws a frame and writes the one before it, which lasted until this one's slot of time.
    fn show<R: Real>(&mut self, time: f64, position: &[[R; 3]], slot: i64) -> io::Result<()> {
        self.picture.draw(time, position);
        let canvas = self.picture.canvas();
        let size = [canvas.width() as u16, canvas.height() as u16];
        if let Some(last) = self.waiting.take() {
            let delay = self.clock.delay(last.slot, slot);
            self.output.write(last.frame, delay)?;
        } else {
            self.palette = Palette::new(self.picture.palette_seeds(), canvas.pixels());
            self.output.begin(size, &self.palette)?;
        }
        let frame = changes(canvas.pixels(), size, &mut self.palette, &mut self.shown);
        self.waiting = Some(Waiting { frame, slot });
        Ok(())
    }

    fn end(mut self) -> io::Result<()> {
        if let (Some((time, position)), Some(last)) = (self.left_out.take(), &self.waiting) {
            let slot = last.slot.saturating_add(self.clock.shortest());
            self.show(time, &position, slot)?;
        }
        if let Some(last) = self.waiting.take() {
            self.output.write(last.frame, LAST_DELAY)?;
        }
        match self.output {
            Output::Begun(encoder) => encoder.into_inner().map_err(plain)?.flush(),
            Output::Untouched(mut writer) => writer.flush(),
            Output::Lost => Ok(()),
        }
    }

    fn explain(path: &str, result: io::Result<()>) -> Result<(), RecordError> {
        result.map_err(|source| RecordError { path: path.to_owned(), source })
    }
}

impl<W: Write, R: Real> Recorder<R> for GifRecorder<W> {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        let slot = self.clock.slot(frame.time);
        if self.waiting.as_ref().is_some_and(|last| slot <= last.slot) {
            let position = frame.position.iter().map(|point| point.map(R::to_f64));
            let (time, kept) = self.left_out.get_or_insert_default();
            *time = frame.time;
            kept.clear();
            kept.extend(position);
            return Ok(());
        }
        self.left_out = None;
        let result = self.show(frame.time, frame.position, slot);
        Self::explain(&self.path, result)
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        let path = self.path.clone();
        Self::explain(&path, self.end())
    }
}

impl<W: Write> Output<W> {
    fn begin(&mut self, [width, height]: [u16; 2], palette: &Palette) -> io::Result<()> {
        if let Self::Untouched(writer) = std::mem::replace(self, Self::Lost) {
            let mut encoder = Encoder::new(writer, width, height, &palette.bytes()).map_err(plain)?;
            encoder.set_repeat(Repeat::Infinite).map_err(plain)?;
            *self = Self::Begun(Box::new(encoder));
        }
        Ok(())
    }

    fn write(&mut self, mut frame: ::gif::Frame<'static>, delay: u16) -> io::Result<()> {
        let Self::Begun(encoder) = self else {
            return Err(io::Error::other("the file could not be begun"));
        };
        frame.delay = delay;
        encoder.write_frame(&frame).map_err(plain)?;
        // Whoever looks at the file while it is written, or after an interruption, has this frame.
        encoder.get_mut().flush()
    }
}

/// The smallest rectangle that has changed, with what has not changed inside it left transparent.
fn changes(
    pixels: &[[u8; 4]],
    [width, height]: [u16; 2],
    palette: &mut Palette,
    shown: &mut Vec<u8>,
) -> ::gif::Frame<'static> {
    let columns = usize::from(width).max(1);
    let is_first = shown.is_empty();
    shown.resize(pixels.len(), 0);
    let mut buffer = vec![Palette::UNCHANGED; pixels.len()];
    let (mut left, mut right, mut top, mut bottom) = (columns, 0, usize::from(height), 0);
    let rows = pixels.chunks(columns).zip(shown.chunks_mut(columns)).zip(buffer.chunks_mut(columns));
    for (row, ((pixels, shown), buffer)) in rows.enumerate() {
        let mut last = ([0; 4], palette.nearest([0; 3]));
        for (column, ((pixel, shown), new)) in pixels.iter().zip(shown).zip(buffer).enumerate() {
            if *pixel != last.0 {
                last = (*pixel, palette.nearest([pixel[0], pixel[1], pixel[2]]));
            }
            if is_first || *shown != last.1 {
                *shown = last.1;
                *new = last.1;
                (left, right) = (left.min(column), right.max(column));
                (top, bottom) = (top.min(row), bottom.max(row));
            }
        }
    }
    // Even a frame in which nothing changes takes its time: one pixel of nothing.
    let (left, top) = (left.min(right), top.min(bottom));
    let rows = buffer.chunks(columns).skip(top).take(bottom - top + 1);
    let inside: Vec<u8> = rows.flat_map(|row| row.iter().skip(left).take(right - left + 1).copied()).collect();
    ::gif::Frame {
        left: left as u16,
        top: top as u16,
        width: (right - left + 1) as u16,
        height: (bottom - top + 1) as u16,
        transparent: (!is_first).then_some(Palette::UNCHANGED),
        buffer: Cow::Owned(inside),
        ..::gif::Frame::default()
    }
}

fn plain(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        other => io::Error::other(other),
    }
}
