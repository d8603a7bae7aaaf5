//! Reads scenes in a web page: texts in, flat arrays or a refusal out, both the desktop's.
//!
//! The caller asks for [`exports::room`], writes a request there, calls [`exports::read`], and finds the answer from
//! [`exports::answer`] on.

mod exports;
mod flat;
mod refusal;
mod request;

use flat::flat;
use refusal::Refusal;
use request::Request;

/// A scene may ask for this much, bytes: a page has 4 GiB at most, and steps the scene twice.
const AVAILABLE: u64 = 1 << 29;

/// The answer to a request: whether it is a scene, and its bytes.
fn answer(request: &[u8]) -> (bool, Vec<u8>) {
    match scene(request) {
        Ok(bytes) => (true, bytes),
        Err(refusal) => (false, refusal.bytes()),
    }
}

fn scene(request: &[u8]) -> Result<Vec<u8>, Refusal> {
    let request: Request = serde_json::from_slice(request).map_err(|error| Refusal::of_request(&error))?;
    let scene = request.scene()?;
    let model = scene.model_within(AVAILABLE)?;
    Ok(flat(scene.settings(), &model))
}
