//! The functions of the interface: each checks its pointers, and leaves the rest to the [`crate::engine`].
//!
//! What holds for all of them is said once, at the top of the header.

mod add;
mod change;
mod create;
mod keep;
mod read;
mod step;

pub use add::*;
pub use change::*;
pub use create::*;
pub use keep::*;
pub use read::*;
pub use step::*;

use crate::arena::Capacity;
use crate::code::{HookeCode, Outcome, Wrong};

fn chosen<T>(choice: Option<T>) -> Outcome<T> {
    choice.ok_or(HookeCode::NoSuchOption.into())
}

fn coded(outcome: Outcome) -> HookeCode {
    outcome.err().map_or(HookeCode::Ok, Wrong::code)
}

fn capacity(particles: u32, springs: u32, planes: u32) -> Capacity {
    Capacity { of: [particles, springs, planes].map(|count| count as usize) }
}
