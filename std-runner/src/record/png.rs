//! A numbered sequence of PNG pictures, for a film editor or an encoder of one's choice.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use ::png::{BitDepth, ColorType, Compression, Encoder, EncodingError};
use hooke::Real;

use super::{Frame, RecordError, Recorder};
use crate::draw::{Canvas, Picture};

/// What each picture says of itself, as keyword and text, so that no other is taken for one.
const MADE_BY: (&str, &str) = ("Software", "Hooke");
/// A picture says it within so many bytes.
const FRONT: u64 = 128;

/// Writes each frame into a file of its own: for `frames/cloth.png`, into `frames/cloth-00000.png` and so on.
///
/// Pictures that an earlier run recorded under the same name go when the first frame comes.
pub struct PngRecorder {
    path: PathBuf,
    picture: Picture,
    rows: Vec<u8>,
}

impl PngRecorder {
    /// Makes the folder for the pictures, if it is not there.
    ///
    /// # Errors
    /// When the folder can't be made, or no file in it.
    pub fn create(path: &Path, picture: Picture) -> Result<Self, RecordError> {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(|source| failure(folder, source))?;
        }
        let first = Self::numbered(path, 0);
        let partial = partial(&first);
        fs::write(&partial, []).and_then(|()| fs::remove_file(&partial)).map_err(|source| failure(&first, source))?;
        Ok(Self { path: path.to_owned(), picture, rows: Vec::new() })
    }

    /// A longer run would leave its last pictures behind a shorter one's.
    fn remove_earlier(&self) {
        // They are numbered without a gap. One that cannot be removed is written over, or stays.
        let all = (0..).map(|number| Self::numbered(&self.path, number));
        all.take_while(|path| is_ours(path) && fs::remove_file(path).is_ok()).for_each(drop);
    }

    /// The file of a frame.
    #[must_use]
    pub fn numbered(path: &Path, number: u64) -> PathBuf {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let ending = path.extension().unwrap_or("png".as_ref()).to_string_lossy();
        path.with_file_name(format!("{stem}-{number:05}.{ending}"))
    }
}

impl<R: Real> Recorder<R> for PngRecorder {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        if frame.number == 0 {
            self.remove_earlier();
        }
        let canvas = self.picture.draw(frame.time, frame.position);
        let path = Self::numbered(&self.path, frame.number);
        let written = encode(canvas, &mut self.rows)
            .map_err(|error| match error {
                EncodingError::IoError(error) => error,
                other => io::Error::other(other),
            })
            .and_then(|bytes| {
                // Under its own name, a picture is always a whole one.
                let partial = partial(&path);
                fs::write(&partial, bytes).and_then(|()| fs::rename(&partial, &path)).inspect_err(|_| {
                    // It may not have come to be.
                    let _ = fs::remove_file(&partial);
                })
            });
        written.map_err(|source| failure(&path, source))
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Ok(())
    }
}

fn encode(canvas: &Canvas, rows: &mut Vec<u8>) -> Result<Vec<u8>, EncodingError> {
    rows.clear();
    rows.extend(canvas.pixels().iter().flat_map(|[red, green, blue, _]| [*red, *green, *blue]));
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, canvas.width(), canvas.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Fast);
    encoder.add_text_chunk(MADE_BY.0.to_owned(), MADE_BY.1.to_owned())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(rows)?;
    writer.finish()?;
    Ok(bytes)
}

/// Whether a file is a picture that was recorded here.
fn is_ours(path: &Path) -> bool {
    let mut front = Vec::new();
    let said = format!("tEXt{}\0{}", MADE_BY.0, MADE_BY.1);
    let read = File::open(path).and_then(|file| file.take(FRONT).read_to_end(&mut front));
    read.is_ok() && front.windows(said.len()).any(|bytes| bytes == said.as_bytes())
}

/// What a picture is called while it is written.
fn partial(path: &Path) -> PathBuf {
    path.with_extension("part")
}

fn failure(path: &Path, source: io::Error) -> RecordError {
    RecordError { path: path.display().to_string(), source }
}
