//! A model stepped through its duration, frame by frame.

mod anchor;
mod audit;
mod build;
mod frames;
mod heap;
mod interpolate;
mod looking;
mod method;
mod run;
mod schedule;
mod summary;
mod taken;
mod threads;
mod time_step;
mod tracks;
mod walk;

use hooke::Real;

use crate::record::Sample;

pub use anchor::Anchor;
pub(crate) use audit::Audit;
pub(crate) use build::world_with;
pub use build::{BuildError, HeapWorld, world};
pub use heap::{Heap, HeapColumn};
pub use method::{AnyResponse, AnyStepper, FILL};
pub use run::{Options, Progress, RunError, Start, run};
pub use schedule::{MOST, Schedule};
pub use summary::{Ending, Summary};
pub(crate) use taken::Taken;
pub use threads::Threads;
pub(crate) use time_step::{LONGEST, PART_OF_BOUND, two_digits_below};
pub use time_step::{choose_time_step, chooses_steps, largest_stable_step};
pub(crate) use tracks::Tracks;
pub(crate) use walk::Walk;

/// A number that worlds can be made of whose coordinates can be recorded.
pub trait Stepped: Real<Coordinate: Sample> {}

impl<R: Real<Coordinate: Sample>> Stepped for R {}
