//! Snapshots.
#![allow(unsafe_code, reason = "this is the interface to another language")]
#![allow(clippy::missing_safety_doc, reason = "the header says it once for all of them")]

use crate::block::{HookeWorld, engine, items, items_mut, with};
use crate::code::HookeCode;

/// The bytes of a snapshot of a world; 0 if there is no world.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_snapshot_size(world: *mut HookeWorld) -> usize {
    let mut size = 0;
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            size = engine!(engine, engine => engine.snapshot_size());
            Ok(())
        })
    };
    size
}

/// Writes a snapshot: all that it takes to go on from here, the same on every machine. `size` is `hooke_snapshot_size`.
/// What the stepper remembers of earlier steps is forgotten, here as where the snapshot is put back: both go on to the
/// same bits.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_snapshot(world: *mut HookeWorld, bytes: *mut u8, size: usize) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let bytes = items_mut(bytes, size)?;
            engine!(engine, engine => engine.snapshot(bytes))
        })
    }
}

/// Puts a snapshot back: of a world with the same number of particles, the same springs and planes, in the same precision.
/// Stepper, tolerance, form of collision and ledger are those of the snapshot then: `hooke_choices` tells them. Other bytes are
/// refused, and change nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_restore(world: *mut HookeWorld, bytes: *const u8, size: usize) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let bytes = items(bytes, size)?;
            engine!(engine, engine => engine.restore(bytes))
        })
    }
}
