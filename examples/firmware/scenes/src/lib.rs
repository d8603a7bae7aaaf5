//! Scenes small enough for a microcontroller, and what becomes of them by every stepper: the same lines on every machine.
#![no_std]

mod build;
mod compare;
mod exported;

pub use build::{balls, cloth, rope};
pub use compare::{Balls, Few, Many, Tell, bouncing, few, many};
pub use exported::{Exported, exported};
