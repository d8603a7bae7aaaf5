//! Small worlds, stepped by every stepper, in every precision, with every form of collision: a [`Row`] each.
//!
//! Made to run on anything: a program for a machine hands the question that it is asked to [`answer()`], and prints what it is
//! told.
#![no_std]

mod answer;
mod build;
#[cfg(feature = "changed-bit")]
mod changed_bit;
mod course;
mod names;
mod row;
mod steppers;
mod worlds;

pub use answer::answer;
pub use course::{Machine, Moment, Reached};
pub use row::{Form, Precision, Row, Scene, StepperName};
