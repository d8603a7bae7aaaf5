//! Scenes that tests read from files, and their models.

use crate::trusted;
use hooke_runner::model::Model;
use hooke_runner::scene::{Scene, Settings};

/// The model and the settings of a scene file in `tests/reference`, given without its ending.
///
/// # Panics
/// There is no such file, or the scene is refused.
#[must_use]
pub fn load(name: &str) -> (Model, Settings) {
    let scene = Scene::load(&trusted::path(&format!("{name}.toml"))).expect("a scene that can be read");
    (scene.model().expect("a scene that fits the memory"), scene.settings().clone())
}
