//! Scenes in temporary folders, and everything that an error tells a person.
#![allow(dead_code, reason = "no test file uses all of it")]

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
    GraphicalReportHandler::new_themed(theme).with_width(400).render_report(&mut out, error).unwrap();
    out
}

/// What an error must say.
#[track_caller]
pub fn assert_says(error: &SceneError, place: &str, value: &str, remedy: &str) {
    let message = error.to_string();
    let help = error.help().map(|help| help.to_string()).unwrap_or_default();
    let all = printed(error);
    assert!(message.contains(place), "no place {place:?} in\n{all}");
    assert!(message.contains(value), "no value {value:?} in\n{all}");
    assert!(help.contains(remedy), "no remedy {remedy:?} in\n{all}");
}

/// A sound scene to break one thing in; what is added stands on line 6 and later.
pub const SOUND: &str = r#"
[[particle]]
position = [0, 0, 1]
[[particle]]
position = [1, 0, 1]
"#;

/// The scene is refused, and the error says these.
#[track_caller]
pub fn refuses(toml: &str, place: &str, value: &str, remedy: &str) {
    let error = load("scene.toml", toml).err().unwrap_or_else(|| panic!("loaded:\n{toml}"));
    assert_says(&error, place, value, remedy);
}

/// The sound scene is refused with these lines added, and the error says these.
#[track_caller]
pub fn refuses_after(lines: &str, place: &str, value: &str, remedy: &str) {
    refuses(&format!("{SOUND}{lines}"), place, value, remedy);
}
