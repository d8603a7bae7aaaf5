//! The formats that frames are recorded in.

use std::fs::{File, OpenOptions};
use std::path::Path;

use crate::draw::{Picture, Scenery};
use crate::model::Model;
use crate::record::{BoxedRecorder, CsvRecorder, GifRecorder, NpzRecorder, PngRecorder, RecordError, Sample};
use crate::scene::Settings;
use crate::simulate::Start;

/// What the ending of a file chooses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Csv,
    Npz,
    Gif,
    /// A picture a frame, numbered.
    Png,
}

/// What is recorded: all that a recorder may have to know before the first frame.
#[derive(Clone, Copy)]
pub(super) struct Recording<'a> {
    pub(super) model: &'a Model,
    pub(super) settings: &'a Settings,
    pub(super) start: &'a Start,
}

/// Of a compressed picture of the default size, more or less.
const BYTES_PER_PICTURE: u128 = 60_000;

impl Recording<'_> {
    fn picture(&self) -> Picture {
        let Settings { gravity, name, camera, .. } = self.settings;
        Picture::new(Scenery::new(self.model, *gravity, name, camera))
    }
}

/// Begins a recording: what was there before is gone.
pub(super) type Begin<'a, R> = Box<dyn FnOnce() -> Result<BoxedRecorder<R>, RecordError> + 'a>;

/// A file that still has what it had.
struct Opened {
    file: File,
    name: String,
}

impl Opened {
    fn at(path: &Path) -> Result<Self, RecordError> {
        let name = path.display().to_string();
        match OpenOptions::new().write(true).create(true).truncate(false).open(path) {
            Ok(file) => Ok(Self { file, name }),
            Err(source) => Err(RecordError { path: name, source }),
        }
    }

    /// Empties it for a recorder.
    fn empty<R>(
        self,
        begin: impl FnOnce(File, String) -> Result<BoxedRecorder<R>, RecordError>,
    ) -> Result<BoxedRecorder<R>, RecordError> {
        let Self { file, name } = self;
        // A pipe or a device keeps nothing, and cannot be emptied.
        let emptied = file.metadata().and_then(|found| if found.is_file() { file.set_len(0) } else { Ok(()) });
        match emptied {
            Ok(()) => begin(file, name),
            Err(source) => Err(RecordError { path: name, source }),
        }
    }
}

impl Format {
    pub(super) const ALL: [Self; 4] = [Self::Csv, Self::Npz, Self::Gif, Self::Png];

    pub(super) const fn ending(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Npz => "npz",
            Self::Gif => "gif",
            Self::Png => "png",
        }
    }

    /// The format of a file, by the ending of its name.
    pub(super) fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_lowercase();
        Self::ALL.into_iter().find(|format| format.ending() == ending)
    }

    /// Opens what a recording is to go to, and leaves what is there until it begins.
    pub(super) fn open<'a, R: Sample>(
        self,
        path: &Path,
        recording: Recording<'a>,
    ) -> Result<Begin<'a, R>, RecordError> {
        let Recording { model, settings, start } = recording;
        let file = || Opened::at(path);
        Ok(match self {
            Self::Csv => {
                let file = file()?;
                Box::new(|| file.empty(|file, name| Ok(Box::new(CsvRecorder::new(file, name)))))
            }
            Self::Gif => {
                let (file, picture) = (file()?, recording.picture());
                Box::new(|| {
                    file.empty(|file, name| Ok(Box::new(GifRecorder::new(file, name, picture, settings.frame_rate))))
                })
            }
            Self::Png => {
                let recorder = PngRecorder::create(path, recording.picture())?;
                Box::new(|| Ok(Box::new(recorder)))
            }
            Self::Npz => {
                let file = file()?;
                let springs: Vec<[u32; 2]> = model.springs.iter().map(|spring| spring.between).collect();
                let (particles, frames) = (model.particles.len(), start.schedule.frames());
                Box::new(move || {
                    file.empty(|file, name| {
                        Ok(Box::new(NpzRecorder::<R>::begin(file, name, particles, &springs, frames)?))
                    })
                })
            }
        })
    }

    /// About how many bytes a recording takes.
    pub(super) fn bytes(self, recording: Recording<'_>, bytes_per_number: u64) -> u128 {
        let frames = u128::from(recording.start.schedule.frames());
        let particles = recording.model.particles.len() as u128;
        let number = u128::from(bytes_per_number);
        match self {
            // Three short numbers, and six of as many digits as they have bits for.
            Self::Csv => frames * particles * (15 + 6 * (5 + 2 * number)),
            Self::Npz => frames * (8 + particles * 6 * number),
            Self::Gif | Self::Png => frames * BYTES_PER_PICTURE,
        }
    }
}
