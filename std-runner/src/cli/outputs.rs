//! Where a run is recorded to: checked before anything is written, opened after.

use std::fs::{self, OpenOptions};
use std::io::stdout;
use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::format::{Begin, Format, Recording};
use crate::record::{BoxedRecorder, CsvRecorder, RecordError, Sample};

/// What messages call it.
pub(super) const STANDARD_OUTPUT: &str = "standard output";

/// One place to record to.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Output {
    /// CSV.
    Standard,
    File {
        path: PathBuf,
        format: Format,
        /// Not there before the run.
        new: bool,
    },
}

/// All places of a run.
pub(super) struct Outputs(Vec<Output>);

impl Outputs {
    /// Refuses what cannot be recorded to, and the file that `scene` is read from.
    pub(super) fn check(paths: &[PathBuf], scene: &Path) -> Result<Self, Failure> {
        let scene = same_for_one_file(scene);
        let mut seen: Vec<PathBuf> = Vec::new();
        let mut outputs = Vec::new();
        for path in paths {
            outputs.push(Output::check(path)?);
            let place = same_for_one_file(path);
            if place == scene {
                let message = format!("--out {} leads to the scene file itself", path.display());
                return Err(Failure::input(message, "record to another file"));
            }
            if seen.contains(&place) {
                let message = format!("--out {} is given twice", path.display());
                return Err(Failure::input(message, "give every recording a file of its own"));
            }
            seen.push(place);
        }
        Ok(Self(outputs))
    }

    pub(super) fn to_standard_output(&self) -> bool {
        self.0.contains(&Output::Standard)
    }

    pub(super) fn only_to_standard_output(&self) -> bool {
        self.0 == [Output::Standard]
    }

    /// About how many bytes the recordings take on the disk.
    pub(super) fn bytes(&self, recording: Recording<'_>, bytes_per_number: u64) -> u128 {
        let bytes = |output: &Output| match output {
            Output::Standard => 0,
            Output::File { format, .. } => format.bytes(recording, bytes_per_number),
        };
        self.0.iter().map(bytes).sum()
    }

    /// Begins every recording, once all can be written to. If one cannot, the files that were made for the others are
    /// gone again, and those that were there before are as they were.
    pub(super) fn open<R: Sample>(&self, recording: Recording<'_>) -> Result<Vec<BoxedRecorder<R>>, RecordError> {
        let mut opened = Vec::new();
        for (index, output) in self.0.iter().enumerate() {
            match output.open(recording) {
                Ok(begin) => opened.push(begin),
                Err(error) => {
                    drop(opened);
                    self.0.iter().take(index + 1).for_each(Output::remove_if_new);
                    return Err(error);
                }
            }
        }
        let begun = opened.into_iter().map(|begin| begin()).collect::<Result<Vec<_>, _>>();
        if begun.is_err() {
            self.0.iter().for_each(Output::remove_if_new);
        }
        begun
    }

    /// The files, for the summary.
    pub(super) fn names(&self) -> Vec<String> {
        let name = |output: &Output| match output {
            Output::Standard => STANDARD_OUTPUT.to_owned(),
            Output::File { path, .. } => path.display().to_string(),
        };
        self.0.iter().map(name).collect()
    }
}

impl Output {
    fn check(path: &Path) -> Result<Self, Failure> {
        if is_standard_output(path) {
            return Ok(Self::Standard);
        }
        let shown = path.display();
        let Some(format) = Format::of(path) else {
            let endings: Vec<String> = Format::ALL.iter().map(|format| format!(".{}", format.ending())).collect();
            let found = path.extension().map_or_else(
                || "has no ending".to_owned(),
                |ending| format!("has the ending .{}, which names no format", ending.display()),
            );
            let message = format!("--out {shown} {found}: the known endings are {}", endings.join(", "));
            return Err(Failure::input(
                message,
                "end the file's name in one of them, or use - for CSV to standard output",
            ));
        };
        check_place(path, "--out")?;
        let found = fs::metadata(path);
        let new = found.is_err();
        if found.is_ok_and(|found| found.is_file()) {
            // An existing file is opened without changing it, to see whether it may be written.
            if let Err(error) = OpenOptions::new().write(true).open(path) {
                return Err(Failure::input(format!("--out {shown} cannot be written: {error}"), "choose another file"));
            }
        } else if !new && format == Format::Npz {
            // A pipe is opened only once: who reads it would take the second time for the end.
            let message = format!("--out {shown} is a pipe or a device, and NPZ is written at many places of a file");
            return Err(Failure::input(message, "choose a file, or another format"));
        }
        Ok(Self::File { path: path.to_owned(), format, new })
    }

    fn open<'a, R: Sample>(&self, recording: Recording<'a>) -> Result<Begin<'a, R>, RecordError> {
        match self {
            Self::Standard => Ok(Box::new(|| Ok(Box::new(CsvRecorder::new(stdout(), STANDARD_OUTPUT.to_owned()))))),
            Self::File { path, format, .. } => format.open(path, recording),
        }
    }

    fn remove_if_new(&self) {
        if let Self::File { path, new: true, .. } = self {
            // It may not have come to be; and what cannot be removed stays, an empty recording.
            let _ = fs::remove_file(path);
        }
    }
}

/// Whether a path asks for standard output.
pub(super) fn is_standard_output(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Refuses a path in a folder that does not exist, or that is a folder itself.
pub(super) fn check_place(path: &Path, what: &str) -> Result<(), Failure> {
    let shown = path.display();
    if path.is_dir() {
        return Err(Failure::input(format!("{what} {shown} is a folder"), "name a file in it"));
    }
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            let folder = folder.display();
            let message = format!("{what} {shown}: there is no folder {folder}");
            Err(Failure::input(message, format!("make it first: mkdir -p {folder}")))
        }
        _ => Ok(()),
    }
}

/// A name that two paths share if they lead to the same file.
fn same_for_one_file(path: &Path) -> PathBuf {
    if let Ok(real) = path.canonicalize() {
        return real;
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    folder.canonicalize().unwrap_or_else(|_| folder.to_owned()).join(path.file_name().unwrap_or_default())
}
