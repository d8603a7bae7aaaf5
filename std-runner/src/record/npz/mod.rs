//! Frames as NumPy arrays in one archive: `time` (F), `position` (F, P, 3), `velocity` (F, P, 3), `springs` (S, 2).
//!
//! The number of frames is known when a recording begins, so every array has its place in the file from the start, and
//! the archive's directory its place at the end; what lies between and is not written yet is a hole, which takes no
//! room on the disk. Each frame is written to its places as it is made. It becomes part of the recording in an order
//! that keeps the file a valid archive, checksums included, after each single write:
//!
//! 1. The frame's data goes behind the rows there are: nothing speaks of it yet.
//! 2. One write replaces the directory. Every entry is a row longer now, while the header inside each still says that
//!    its array has a row less: readers of arrays stop there. The checksum is right for both headers (see `npy`).
//! 3. One write an array replaces its headers: `position`, `velocity`, then `time`. In between, the lengths of the
//!    arrays differ by the one frame, and `time` is never the longest.
//!
//! Each of the writes in 2 and 3 lies within one page of memory, so a process that is killed has made it or not. A
//! machine that loses power may lose what its file system had not yet put on the disk, here as in any file. A program
//! that reads while frames are written may see one part from before a frame and one from after it, and must try again.

mod array;
mod little_endian;
mod npy;
mod zip;

use std::fs::File;
use std::io::{self, ErrorKind, Seek, SeekFrom, Write};
use std::marker::PhantomData;
use std::path::Path;

use super::{Frame, RecordError, Recorder, Sample};
use array::{Array, Progress};

/// The directory takes less than this in its widest form, and begins at a multiple of it: it lies in one sector.
const DIRECTORY_ALIGNMENT: u64 = 512;
/// A narrow archive's directory begins before this, and so everything else in it does.
const NARROW_END: u64 = u32::MAX as u64;

/// Records to a file that `numpy.load` reads, positions (m) and velocities (m/s) in the run's own precision, times (s)
/// as `f64`. Whenever the run is killed, the file is a valid archive, up to its last whole frame.
///
/// While it is being made, and after a run that ended early, the file has the length of the whole recording, but takes
/// only the room of the frames it has, on a file system that knows holes.
pub struct NpzRecorder<R, W = File> {
    file: W,
    path: String,
    /// The frames there is room for.
    frames: u64,
    particles: usize,
    springs: (Array, Progress),
    frame_arrays: FrameArrays,
    written: Written,
    /// The number of recorded frames.
    recorded: u64,
    /// Where the directory is, bytes from the start of the file.
    directory: u64,
    /// Whether sizes and offsets take 64 bits.
    wide: bool,
    /// What is about to be written.
    bytes: Vec<u8>,
    precision: PhantomData<R>,
}

/// The arrays with a row for each frame.
struct FrameArrays {
    time: Array,
    position: Array,
    velocity: Array,
}

/// How far they are.
#[derive(Clone, Default)]
struct Written {
    time: Progress,
    position: Progress,
    velocity: Progress,
}

impl<R: Sample> NpzRecorder<R> {
    /// Begins a recording of up to `frames` frames in a new file, or in place of the file that is there.
    /// An array is written at many places of a file, so there is no recording to a pipe.
    ///
    /// # Errors
    /// When the file can't be made, or no file can be long enough.
    pub fn create(path: &Path, particles: usize, springs: &[[u32; 2]], frames: u64) -> Result<Self, RecordError> {
        let name = path.display().to_string();
        match File::create(path) {
            Ok(file) => Self::begin(file, name, particles, springs, frames),
            Err(source) => Err(RecordError { path: name, source }),
        }
    }
}

impl<R: Sample, W: Write + Seek> NpzRecorder<R, W> {
    /// Begins a recording of up to `frames` frames in an empty file, or in what stands for one; `path` is what error
    /// messages call it. `file` must not hold writes back: what it was given is to survive the process.
    ///
    /// # Errors
    /// When it can't be written, or no file can be long enough.
    pub fn begin(
        file: W,
        path: String,
        particles: usize,
        springs: &[[u32; 2]],
        frames: u64,
    ) -> Result<Self, RecordError> {
        let Some(mut recorder) = Self::lay_out(file, &path, particles, springs.len(), frames) else {
            let source = io::Error::new(
                ErrorKind::FileTooLarge,
                format!("{frames} frames of {particles} particles are more than a file can hold"),
            );
            return Err(RecordError { path, source });
        };
        match recorder.write_beginning(springs) {
            Ok(()) => Ok(recorder),
            Err(source) => Err(RecordError { path, source }),
        }
    }

    /// `None` if no file can be long enough.
    fn lay_out(file: W, path: &str, particles: usize, springs: usize, frames: u64) -> Option<Self> {
        let mut free = 0;
        let particle_count = u64::try_from(particles).ok()?;
        let spring_count = u64::try_from(springs).ok()?;
        let shape = [particle_count, 3];
        let springs = Array::reserve::<u32>("springs.npy", spring_count, &[2], &mut free)?;
        let frame_arrays = FrameArrays {
            time: Array::reserve::<f64>("time.npy", frames, &[], &mut free)?,
            position: Array::reserve::<R>("position.npy", frames, &shape, &mut free)?,
            velocity: Array::reserve::<R>("velocity.npy", frames, &shape, &mut free)?,
        };
        let directory = free.checked_next_multiple_of(DIRECTORY_ALIGNMENT)?;
        // Offsets within a file are signed on most systems.
        i64::try_from(directory.checked_add(DIRECTORY_ALIGNMENT)?).ok()?;
        Some(Self {
            file,
            path: path.to_owned(),
            frames,
            particles,
            springs: (springs, Progress::default()),
            frame_arrays,
            written: Written::default(),
            recorded: 0,
            directory,
            wide: directory >= NARROW_END,
            bytes: Vec::new(),
            precision: PhantomData,
        })
    }

    fn write_beginning(&mut self, springs: &[[u32; 2]]) -> io::Result<()> {
        let (array, progress) = &mut self.springs;
        let (file, bytes) = (&mut self.file, &mut self.bytes);
        array.write_rows(springs.len() as u64, springs.as_flattened(), progress, file, bytes)?;
        array.write_front(progress, self.wide, file, bytes)?;
        let nothing = Written::default();
        self.write_fronts(&nothing)?;
        // Last, as it is what makes the file an archive.
        self.write_directory(&nothing)
    }

    fn write_directory(&mut self, written: &Written) -> io::Result<()> {
        let entries = [
            self.springs.0.entry(&self.springs.1),
            self.frame_arrays.time.entry(&written.time),
            self.frame_arrays.position.entry(&written.position),
            self.frame_arrays.velocity.entry(&written.velocity),
        ];
        self.bytes.clear();
        zip::append_directory(&entries, self.directory, self.wide, &mut self.bytes);
        self.file.seek(SeekFrom::Start(self.directory))?;
        self.file.write_all(&self.bytes)
    }

    fn write_fronts(&mut self, written: &Written) -> io::Result<()> {
        let FrameArrays { time, position, velocity } = &self.frame_arrays;
        let (file, bytes) = (&mut self.file, &mut self.bytes);
        position.write_front(&written.position, self.wide, file, bytes)?;
        velocity.write_front(&written.velocity, self.wide, file, bytes)?;
        time.write_front(&written.time, self.wide, file, bytes)
    }

    fn write_frame(&mut self, frame: &Frame<'_, R>) -> io::Result<()> {
        self.check(frame)?;
        // A frame that fails leaves `self.written` as it was, and the next one takes its place.
        let mut written = self.written.clone();
        let FrameArrays { time, position, velocity } = &self.frame_arrays;
        let (file, bytes) = (&mut self.file, &mut self.bytes);
        time.write_rows(1, &[frame.time], &mut written.time, file, bytes)?;
        position.write_rows(1, frame.position.as_flattened(), &mut written.position, file, bytes)?;
        velocity.write_rows(1, frame.velocity.as_flattened(), &mut written.velocity, file, bytes)?;
        self.write_directory(&written)?;
        self.write_fronts(&written)?;
        self.written = written;
        self.recorded += 1;
        Ok(())
    }

    fn check(&self, frame: &Frame<'_, R>) -> io::Result<()> {
        let message = if self.recorded == self.frames {
            format!("the recording is full: it has room for {} frames", self.frames)
        } else if frame.position.len() != self.particles || frame.velocity.len() != self.particles {
            format!(
                "a frame of {} positions and {} velocities in a recording of {} particles",
                frame.position.len(),
                frame.velocity.len(),
                self.particles
            )
        } else {
            return Ok(());
        };
        Err(io::Error::new(ErrorKind::InvalidInput, message))
    }
}

impl<R: Sample, W: Write + Seek> Recorder<R> for NpzRecorder<R, W> {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        self.write_frame(frame).map_err(|source| RecordError { path: self.path.clone(), source })
    }

    /// Nothing is left to write: the file is whole after every frame.
    fn finish(mut self: Box<Self>) -> Result<(), RecordError> {
        let path = self.path;
        self.file.flush().map_err(|source| RecordError { path, source })
    }
}
