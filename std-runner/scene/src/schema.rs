//! The scene format for editors and other tools.

use super::file::SceneFile;

/// The JSON Schema of scene files, made from the types that read them, with every key's meaning and default.
#[must_use]
pub fn schema() -> String {
    // A schema is a JSON value already: `#` prints one indented, and cannot fail.
    format!("{:#}", schemars::schema_for!(SceneFile).to_value())
}
