//! The formats that frames are recorded in.

use std::fs::File;
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

    /// Begins a recording in a file.
    pub(super) fn create<R: Sample>(
        self,
        path: &Path,
        recording: Recording<'_>,
    ) -> Result<BoxedRecorder<R>, RecordError> {
        let Recording { model, settings, start } = recording;
        let name = path.display().to_string();
        let file = || File::create(path).map_err(|source| RecordError { path: name.clone(), source });
        Ok(match self {
            Self::Csv => Box::new(CsvRecorder::new(file()?, name)),
            Self::Gif => Box::new(GifRecorder::new(file()?, name, recording.picture(), settings.frame_rate)),
            Self::Png => Box::new(PngRecorder::create(path, recording.picture())?),
            Self::Npz => {
                let springs: Vec<[u32; 2]> = model.springs.iter().map(|spring| spring.between).collect();
                Box::new(NpzRecorder::<R>::create(path, model.particles.len(), &springs, start.schedule.frames())?)
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
