//! Why a page gets no scene.

use hooke_scene::SceneError;
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use serde::Serialize;

/// A message, whole and in its parts.
#[derive(Serialize)]
pub(crate) struct Refusal {
    /// The place and the value.
    message: String,
    remedy: String,
    /// As the desktop prints it, lines of the file included.
    printed: String,
    /// Of the text, first byte and count, where there is such a place.
    bytes: Option<(usize, usize)>,
}

impl From<SceneError> for Refusal {
    fn from(error: SceneError) -> Self {
        Self::of(&error)
    }
}

impl Refusal {
    fn of(error: &dyn Diagnostic) -> Self {
        let handler =
            GraphicalReportHandler::new_themed(GraphicalTheme::none()).with_links(false).with_wrap_lines(false);
        let mut printed = String::new();
        if handler.render_report(&mut printed, error).is_err() {
            printed = error.to_string();
        }
        let label = error.labels().and_then(|mut labels| labels.next());
        Self {
            message: error.to_string(),
            remedy: error.help().map(|help| help.to_string()).unwrap_or_default(),
            printed,
            bytes: label.map(|label| (label.offset(), label.len())),
        }
    }

    /// Of a request that a page did not put well.
    pub(crate) fn of_request(error: &serde_json::Error) -> Self {
        let message = format!("the request is not one: {error}");
        let remedy = "ask with a name, a text and meshes".to_owned();
        Self { printed: message.clone(), message, remedy, bytes: None }
    }

    /// As JSON.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        // Texts and numbers: nothing in it can fail.
        serde_json::to_vec(self).unwrap_or_default()
    }
}
