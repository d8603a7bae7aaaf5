//! From text to the entries of a scene, by way of a tree that remembers where everything stood.
//!
//! TOML and JSON become the same tree, so a scene means the same, and is refused in the same words, in both.

mod deserialize;
#[cfg(feature = "desktop")]
mod files;
mod json;
mod key_path;
mod source;
mod toml;
mod tree;
mod words;

#[cfg(feature = "desktop")]
pub use files::text_of_file;
pub(super) use key_path::KeyPath;
pub(super) use source::Source;
pub use source::{Texts, Unreadable};
