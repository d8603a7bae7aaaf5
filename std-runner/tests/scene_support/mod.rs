//! Scenes in temporary folders, and everything that an error tells a person.

use std::path::PathBuf;

use hooke_runner::model::Model;
use hooke_runner::scene::{Scene, SceneError};
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use tempfile::TempDir;

/// A folder that scenes and meshes are written into, gone when dropped.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.path().join(name);
        std::fs::write(&path, content).unwrap();
        path
    }
}

/// Loads a scene that stands alone.
pub fn load(name: &str, content: &str) -> Result<Scene, SceneError> {
    let folder = Folder::new();
    Scene::load(&folder.write(name, content))
}

/// The model of a sound TOML scene.
#[allow(dead_code, reason = "not every test file makes models")]
pub fn model(toml: &str) -> Model {
    match load("scene.toml", toml) {
        Ok(scene) => scene.model().unwrap(),
        Err(error) => panic!("{}", printed(&error)),
    }
}

/// The error, the label on the file's line, and the remedy, as a terminal without colours shows them.
pub fn printed(error: &SceneError) -> String {
    let mut out = String::new();
    let theme = GraphicalTheme::none();
    GraphicalReportHandler::new_themed(theme)
        .with_width(400)
        .render_report(&mut out, error)
        .unwrap();
    out
}

/// What an error must say.
#[allow(dead_code, reason = "not every test file refuses")]
pub fn assert_says(error: &SceneError, place: &str, value: &str, remedy: &str) {
    let message = error.to_string();
    let help = error
        .help()
        .map(|help| help.to_string())
        .unwrap_or_default();
    let all = printed(error);
    assert!(message.contains(place), "no place {place:?} in\n{all}");
    assert!(message.contains(value), "no value {value:?} in\n{all}");
    assert!(help.contains(remedy), "no remedy {remedy:?} in\n{all}");
}
