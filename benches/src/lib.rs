//! The textbook loop that Hooke is measured against, and its scenes.

pub mod mesh;
pub mod textbook;
pub mod vector;
