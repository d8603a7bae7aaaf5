//! The scene that is shown, as a page reads it.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use serde::Serialize;

use crate::model::Model;
use crate::scene::{Scene, SceneError, Settings, text_of_file};

/// A scene with the texts that it was read from.
#[derive(Clone, Debug)]
pub struct Shown {
    /// Its particles, springs and planes.
    pub model: Model,
    /// How it is run, flags included.
    pub settings: Settings,
    texts: Texts,
}

/// What a page asks for first.
#[derive(Clone, Debug, Default, Serialize)]
struct Texts {
    /// Of the file: its ending says the format.
    name: String,
    text: Arc<str>,
    meshes: BTreeMap<String, Arc<str>>,
}

impl Shown {
    /// A scene that has been loaded from that file, whose texts are read again.
    ///
    /// # Errors
    /// If a file has gone or changed since.
    pub fn new(path: &Path, model: Model, settings: Settings) -> Result<Self, SceneError> {
        let mut texts = Texts { name: named(path), ..Texts::default() };
        let folder = path.parent().unwrap_or(Path::new(""));
        Scene::of(path, &mut |asked, what| {
            let text = text_of_file(asked, what)?;
            if asked == path {
                texts.text = Arc::clone(&text);
            } else {
                let name = asked.strip_prefix(folder).unwrap_or(asked).display().to_string();
                texts.meshes.insert(name, Arc::clone(&text));
            }
            Ok(text)
        })?;
        Ok(Self { model, settings, texts })
    }

    /// As JSON.
    pub(super) fn json(&self) -> Vec<u8> {
        // Texts by name: nothing in it can fail.
        serde_json::to_vec(&self.texts).unwrap_or_default()
    }
}

fn named(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}
