//! Runs Hooke's scenes from the desktop.

pub mod advice;
pub mod bench;
pub mod cli;
pub mod draw;
pub mod model;
pub mod record;
pub mod scene;
pub mod simulate;
mod units;
