//! A scene in the browser: the web page, served from this program, and the frames of a run as they are made.

mod files;
mod frames;
mod server;
mod shown;

pub use server::{Server, ServerError};
pub use shown::Shown;
