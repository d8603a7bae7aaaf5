//! What a page asks.

use std::collections::HashMap;
use std::path::Path;

use hooke_scene::{Scene, SceneError, Unreadable};
use serde::Deserialize;

/// The texts that a scene is read from.
#[derive(Deserialize)]
pub(crate) struct Request {
    /// Of the scene's file, such as `rope.toml`; the ending says the format.
    name: String,
    text: String,
    /// The texts of mesh files, by their names in the scene.
    #[serde(default)]
    meshes: HashMap<String, String>,
}

impl Request {
    /// The scene, or why it is refused.
    pub(crate) fn scene(&self) -> Result<Scene, SceneError> {
        let path = Path::new(&self.name);
        Scene::of(path, &mut |asked, _| {
            if asked == path {
                return Ok(self.text.as_str().into());
            }
            self.meshes.get(&*asked.to_string_lossy()).map(|text| text.as_str().into()).ok_or_else(|| Unreadable {
                message: "a page cannot look for files".to_owned(),
                remedy: "give the mesh file to the page together with the scene".to_owned(),
            })
        })
    }
}
