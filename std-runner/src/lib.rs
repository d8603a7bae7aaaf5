//! Runs Hooke's scenes from the desktop.

pub mod accuracy;
pub mod advice;
pub mod bench;
pub mod chart;
pub mod cli;
pub mod draw;
pub mod export;
pub mod record;
pub mod report;
pub mod simulate;
pub mod stress;
mod units;
pub mod view;

pub use hooke_scene as scene;
pub use hooke_scene::model;
