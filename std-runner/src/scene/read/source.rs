//! A scene file as it was read, kept to point at its lines.

use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::de::DeserializeOwned;

use super::super::error::{Problem, Refusal, SceneError};
use super::tree::{Node, Value};
use super::{deserialize, json, toml};

/// The two ways to write a scene.
#[derive(Clone, Copy, Debug)]
enum Format {
    Toml,
    Json,
}

/// A scene's text.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Source {
    path: PathBuf,
    text: Arc<str>,
    format: Format,
}

impl Source {
    /// Reads the file at `path`, in the format that its ending says.
    pub(in crate::scene) fn load(path: &Path) -> Result<Self, SceneError> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let format = match ending.as_str() {
            "toml" => Format::Toml,
            "json" => Format::Json,
            _ => {
                return Err(SceneError::plain(
                    path.display(),
                    format!("the ending {ending:?} names no scene format"),
                    "name the file `….toml` or `….json`, and write it so".to_owned(),
                ));
            }
        };
        let text = read_text(path, "a scene")
            .map_err(|(message, remedy)| SceneError::plain(path.display(), message, remedy))?;
        Ok(Self { path: path.to_owned(), text, format })
    }

    /// The file.
    pub(in crate::scene) fn path(&self) -> &Path {
        &self.path
    }

    /// What the text says.
    pub(in crate::scene) fn parse<T: DeserializeOwned>(&self) -> Result<T, SceneError> {
        let tree = self.tree().map_err(|refusal| self.refused(refusal))?;
        if matches!(&tree.value, Value::Table(entries) if entries.is_empty()) {
            return Err(SceneError::plain(
                self.path.display(),
                "the file is empty".to_owned(),
                "start from one of `hooke new`'s scenes".to_owned(),
            ));
        }
        T::deserialize(&tree).map_err(|fault: deserialize::Fault| self.refused(fault.into()))
    }

    /// The problem, with the line that it is on.
    pub(in crate::scene) fn problem(&self, problem: Problem) -> SceneError {
        // Read again rather than kept: a tree is several times the size of its text, and most scenes have no problem.
        let span = self.tree().ok().map(|tree| tree.locate(&problem.path));
        self.refused(Refusal {
            span,
            message: problem.message(&problem.path.to_string()),
            label: problem.rule,
            remedy: problem.remedy,
        })
    }

    fn refused(&self, refusal: Refusal) -> SceneError {
        SceneError::in_text(&self.path, &self.text, refusal)
    }

    fn tree(&self) -> Result<Node, Refusal> {
        if self.text.trim().is_empty() {
            let span = 0..0;
            return Ok(Node { span, value: Value::Table(Vec::new()) });
        }
        match self.format {
            Format::Toml => toml::parse(&self.text),
            Format::Json => json::parse(&self.text),
        }
    }
}

/// No scene or mesh is longer than this, bytes: what is read on and on is none.
const LONGEST: u64 = 1 << 28;

/// The text of a file, or what is wrong with it and what to do; `what` says what the file should be.
pub(in crate::scene) fn read_text(path: &Path, what: &str) -> Result<Arc<str>, (String, String)> {
    let bytes = read(path).map_err(|error| {
        let remedy = match error.kind() {
            io::ErrorKind::NotFound => "check the spelling, and the folder it is looked for in",
            _ if path.is_dir() => "name a file, not a folder",
            io::ErrorKind::FileTooLarge => {
                "check that it is the file you mean; make large scenes of ropes, cloths, blocks and clouds"
            }
            _ => "check that the file may be read",
        };
        (format!("cannot read {what} here: {error}"), remedy.to_owned())
    })?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let offset = error.utf8_error().valid_up_to();
        let byte = error.as_bytes().get(offset).copied().unwrap_or_default();
        (format!("not UTF-8 text: byte {offset} is 0x{byte:02x}"), format!("save it as UTF-8, if it is {what} at all"))
    })?;
    // Some editors begin a file with a mark that no format here knows.
    Ok(text.strip_prefix('\u{feff}').unwrap_or(&text).into())
}

fn read(path: &Path) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let too_long = || io::Error::new(io::ErrorKind::FileTooLarge, format!("it is longer than {} MiB", LONGEST >> 20));
    // What a device or a pipe holds is only known once it has been read.
    let length = file.metadata()?.len();
    if length > LONGEST {
        return Err(too_long());
    }
    let mut bytes = Vec::with_capacity(length as usize);
    file.take(LONGEST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LONGEST { Err(too_long()) } else { Ok(bytes) }
}

impl Refusal {
    /// A number that no machine number can hold.
    pub(super) fn not_a_number(span: Range<usize>, written: impl fmt::Display) -> Self {
        Self {
            span: Some(span),
            message: format!("{written} is too large a number to hold"),
            label: "too large".to_owned(),
            remedy: "write a number that is less than 1.8e308 either way, and a whole number less than 9.2e18"
                .to_owned(),
        }
    }
}
