//! What Hooke is held against: problems with their exact solutions, a reference integrator,
//! trusted trajectories, and the measures that compare a stepper with them.
//!
//! Nothing here knows how Hooke steps; [`runs`] alone lets it.
// A yardstick that cannot be made is a mistake in a test, and a test says so by stopping.
#![allow(clippy::expect_used)]

pub mod accuracies;
pub mod bounce_runs;
pub mod dense;
pub mod drawn;
pub mod energy;
pub mod graphs;
pub mod linearisation;
pub mod measure;
pub mod moment;
pub mod order;
pub mod problems;
pub mod random;
pub mod random_scenes;
pub mod reference;
pub mod right_hand_side;
pub mod root;
pub mod runs;
pub mod scene_runs;
pub mod scenes;
pub mod stability;
pub mod steppers;
pub mod trusted;

pub use hooke_digest as digest;

/// The example of the README is compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
