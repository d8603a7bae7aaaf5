//! Runs Hooke's scenes from the desktop.

pub mod accuracy;
pub mod advice;
pub mod bench;
pub mod chart;
pub mod cli;
pub mod draw;
pub mod export;
pub mod model;
pub mod record;
pub mod report;
pub mod scene;
pub mod simulate;
pub mod stress;
mod units;
