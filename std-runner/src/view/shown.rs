//! The scene that is shown, as a page reads it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Serialize;

use crate::model::Model;
use crate::scene::{Settings, Unreadable, text_of_file};

/// A scene with the texts that it was read from.
#[derive(Clone, Debug)]
pub struct Shown {
    /// Its particles, springs and planes.
    pub model: Model,
    /// How it is run, flags included.
    pub settings: Settings,
    /// What it was read from.
    pub texts: Kept,
}

/// Texts of a scene and of its meshes, kept as they were read: files may change while they are shown.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Kept {
    #[serde(skip)]
    path: PathBuf,
    /// Of the file: its ending says the format.
    name: String,
    text: Arc<str>,
    meshes: BTreeMap<String, Arc<str>>,
}

impl Kept {
    /// Nothing yet of the scene at a path.
    #[must_use]
    pub fn of(path: &Path) -> Self {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Self { path: path.to_owned(), name, ..Self::default() }
    }

    /// The text of a file, told what it should be.
    ///
    /// # Errors
    /// If it cannot be read, or is no text.
    pub fn read(&mut self, asked: &Path, what: &str) -> Result<Arc<str>, Unreadable> {
        let text = text_of_file(asked, what)?;
        if asked == self.path {
            self.text = Arc::clone(&text);
        } else {
            let folder = self.path.parent().unwrap_or(Path::new(""));
            let name = asked.strip_prefix(folder).unwrap_or(asked).display().to_string();
            self.meshes.insert(name, Arc::clone(&text));
        }
        Ok(text)
    }

    /// As JSON, which a page asks for first.
    pub(super) fn json(&self) -> Vec<u8> {
        // Texts by name: nothing in it can fail.
        serde_json::to_vec(self).unwrap_or_default()
    }
}
