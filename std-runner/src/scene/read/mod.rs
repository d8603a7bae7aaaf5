//! From text to the entries of a scene, by way of a tree that remembers where everything stood.
//!
//! TOML and JSON become the same tree, so a scene means the same, and is refused in the same words, in both.

mod deserialize;
mod json;
mod key_path;
mod source;
mod toml;
mod tree;
mod words;

pub(super) use key_path::KeyPath;
pub(super) use source::{Source, read_text};
