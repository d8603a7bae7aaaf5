//! The textbook loop that Hooke is measured against, scenes, and a stopwatch that can be trusted.
#![allow(clippy::expect_used, reason = "a benchmark that cannot be set up has nothing to measure")]

pub mod avx2;
pub mod interleaved;
pub mod mesh;

pub mod scenes;
pub mod skips;
pub mod stamp;
pub mod textbook;
pub mod vector;
