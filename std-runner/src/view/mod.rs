//! A scene in the browser: the web page, served from this program, and the frames of a run as they are made.

mod asker;
mod files;
mod frames;
mod server;
mod shown;

pub use asker::{is_for_here, is_own_page};
pub use server::{Server, ServerError, Tell};
pub use shown::{Kept, Shown};
