//! A scene file as it was read, kept to point at its lines.

use std::fmt;
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

/// Why there is no text of a file.
#[derive(Clone, Debug)]
pub struct Unreadable {
    /// Such as `cannot read a mesh here: …`.
    pub message: String,
    /// What to do about it.
    pub remedy: String,
}

/// Gives the text of the file at a path, given what that file should be.
pub type Texts<'a> = &'a mut dyn FnMut(&Path, &str) -> Result<Arc<str>, Unreadable>;

/// A scene's text.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    path: PathBuf,
    text: Arc<str>,
    format: Format,
}

impl Source {
    /// The text of the file at `path` as `text` gives it, in the format that its ending says.
    pub(crate) fn of(path: &Path, text: Texts<'_>) -> Result<Self, SceneError> {
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
        let text = text(path, "a scene")
            .map_err(|Unreadable { message, remedy }| SceneError::plain(path.display(), message, remedy))?;
        // Some editors begin a file with a mark that no format here knows.
        let text = text.strip_prefix('\u{feff}').map_or_else(|| Arc::clone(&text), Arc::from);
        Ok(Self { path: path.to_owned(), text, format })
    }

    /// The file.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// What the text says.
    pub(crate) fn parse<T: DeserializeOwned>(&self) -> Result<T, SceneError> {
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
    pub(crate) fn problem(&self, problem: Problem) -> SceneError {
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
