//! Hooke behind a C interface: `hooke.h` beside this package is generated from it.
//!
//! A world lives in memory that the caller supplies; nothing is allocated. Columns grow in an arena ([`arena`]) over that
//! memory, the world and its stepper are chosen while the program runs ([`method`]), and every function of the interface
//! ([`interface`]) hands back a code ([`code`]).
#![cfg_attr(not(feature = "std"), no_std)]

mod arena;
mod block;
mod code;
mod current;
mod engine;
mod interface;
mod method;
mod options;
mod pace;
mod report;
mod snapshot;

pub use block::{HOOKE_ALIGNMENT, HookeWorld};
pub use code::HookeCode;
pub use interface::*;
pub use options::{HookeCollision, HookeHold, HookePrecision, HookeStepper};
pub use report::{HookeLedger, HookeReport};

/// No step panics; this is what the linker asks for.
#[cfg(not(feature = "std"))]
#[panic_handler]
fn panicked(_: &core::panic::PanicInfo<'_>) -> ! {
    halt()
}
