//! Why a scene was refused: where, what stands there, and what to do about it.

use std::fmt;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use miette::{Diagnostic, SourceSpan};

use super::excerpt::Excerpt;
use super::read::KeyPath;

/// A scene that cannot be run: the place, the value found there, and the remedy.
///
/// Printed alone it names the place and the value; as a [`Diagnostic`] it adds the lines of the file and the remedy.
#[derive(Debug, thiserror::Error, Diagnostic)]
#[error(transparent)]
#[diagnostic(transparent)]
pub struct SceneError(Box<Refused>);

/// Boxed, so that the happy path does not carry its size.
#[derive(Debug, thiserror::Error, Diagnostic)]
struct Refused {
    /// Such as `scene.toml:3:9`, or empty where there is no such place.
    place: String,
    message: String,
    label: String,
    #[help]
    remedy: String,
    #[source_code]
    text: Option<Excerpt>,
    #[label("{label}")]
    span: Option<SourceSpan>,
}

impl fmt::Display for Refused {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.place.is_empty() {
            write!(formatter, "{}: ", self.place)?;
        }
        formatter.write_str(&self.message)
    }
}

impl SceneError {
    /// About something that is not text in a file.
    pub(super) fn plain(place: impl fmt::Display, message: String, remedy: String) -> Self {
        Self(Box::new(Refused {
            place: place.to_string(),
            message,
            label: String::new(),
            remedy,
            text: None,
            span: None,
        }))
    }

    /// About these bytes of a file.
    pub(super) fn in_text(path: &Path, text: &Arc<str>, refusal: Refusal) -> Self {
        let file = path.display().to_string();
        let Some(span) = refusal.span else {
            return Self::plain(file, refusal.message, refusal.remedy);
        };
        let (line, column) = line_and_column(text, span.start);
        Self(Box::new(Refused {
            place: format!("{file}:{line}:{column}"),
            message: refusal.message,
            label: refusal.label,
            remedy: refusal.remedy,
            text: Some(Excerpt::new(file, text)),
            span: Some(Excerpt::underlined(text, span.start, span.end)),
        }))
    }
}

/// Counted from 1, as editors do.
fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = 1 + before.matches('\n').count();
    (line, 1 + before[line_start..].chars().count())
}

/// Why a text was refused, before it is known which file the text is from.
#[derive(Debug)]
pub(super) struct Refusal {
    pub(super) span: Option<Range<usize>>,
    pub(super) message: String,
    pub(super) label: String,
    pub(super) remedy: String,
}

/// A value that was read well but that no scene can hold.
#[derive(Debug)]
pub(super) struct Problem {
    pub(super) path: KeyPath,
    /// As a person would write it.
    pub(super) value: String,
    /// What the value breaks, as the end of a sentence that begins with the value.
    pub(super) rule: String,
    pub(super) remedy: String,
}

impl Problem {
    /// With the value of `key`.
    pub(super) fn new(key: &str, value: impl fmt::Debug, rule: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { path: KeyPath::key(key), value: format!("{value:?}"), rule: rule.into(), remedy: remedy.into() }
    }

    /// With item number `index` of the list `key`.
    pub(super) fn item(
        key: &str,
        index: usize,
        value: impl fmt::Debug,
        rule: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        let path = KeyPath::default().inside_index(index).inside_key(key);
        Self { path, ..Self::new(key, value, rule, remedy) }
    }

    /// With a key that is needed and not there.
    pub(super) fn absent(key: &str, rule: &str, remedy: &str) -> Self {
        Self { value: "left out".to_owned(), ..Self::new(key, (), rule, remedy) }
    }

    /// The same problem, seen from the table that holds it under `key`.
    pub(super) fn inside(mut self, key: &str) -> Self {
        self.path = self.path.inside_key(key);
        self
    }

    /// The same problem, seen from outside number `index` of the list `key`.
    pub(super) fn inside_item(mut self, key: &str, index: usize) -> Self {
        self.path = self.path.inside_index(index).inside_key(key);
        self
    }

    /// One sentence, with `place` for the path.
    pub(super) fn message(&self, place: &str) -> String {
        format!("`{place}` is {}: {}", self.value, self.rule)
    }

    /// As the fault of a flag on the command line.
    #[cfg(feature = "desktop")]
    pub(super) fn of_flag(self) -> SceneError {
        let message = self.message(&self.path.flag());
        SceneError::plain("", message, self.remedy)
    }
}
