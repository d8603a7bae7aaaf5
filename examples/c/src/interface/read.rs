//! Reading the state, and what became of the energy.
#![allow(unsafe_code, reason = "this is the interface to another language")]
#![allow(clippy::missing_safety_doc, reason = "the header says it once for all of them")]

use crate::block::{AnyEngine, HookeWorld, engine, items_mut_if_any, with, write};
use crate::code::{HookeCode, Outcome};
use crate::report::HookeLedger;

/// The time of the state, s; NaN if there is no world.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_time(world: *mut HookeWorld) -> f64 {
    let mut time = f64::NAN;
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            time = engine!(engine, engine => engine.time());
            Ok(())
        })
    };
    time
}

/// Writes the positions (m) and the velocities (m/s) of all particles, three numbers each, in the order of their
/// numbers. Either pointer may be null. `length` is that of each array: three times the particles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_read(
    world: *mut HookeWorld,
    position: *mut f64,
    velocity: *mut f64,
    length: usize,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            check_length(engine, length)?;
            let mut positions = items_mut_if_any(position, length)?.as_chunks_mut().0.iter_mut();
            let mut velocities = items_mut_if_any(velocity, length)?.as_chunks_mut().0.iter_mut();
            engine!(engine, engine => for [x, v] in engine.states() {
                if let Some(to) = positions.next() {
                    *to = x;
                }
                if let Some(to) = velocities.next() {
                    *to = v;
                }
            });
            Ok(())
        })
    }
}

/// The same, to single precision.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_read_single(
    world: *mut HookeWorld,
    position: *mut f32,
    velocity: *mut f32,
    length: usize,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            check_length(engine, length)?;
            let position = items_mut_if_any(position, length)?.as_chunks_mut().0;
            let velocity = items_mut_if_any(velocity, length)?.as_chunks_mut().0;
            engine!(engine, engine => {
                engine.world.write_positions(position);
                engine.world.write_velocities(velocity);
            });
            Ok(())
        })
    }
}

fn check_length(engine: &AnyEngine, length: usize) -> Outcome {
    let [particles, ..] = engine!(engine, engine => engine.counts());
    if length == 3 * particles as usize { Ok(()) } else { Err(HookeCode::Length.into()) }
}

/// Opens the energy ledger, or opens it anew: from now on it is followed through every step, which costs time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_open_ledger(world: *mut HookeWorld) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            engine!(engine, engine => engine.open_ledger());
            Ok(())
        })
    }
}

/// Writes what the ledger says; if none is open, what one would that has just been opened.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_read_ledger(world: *mut HookeWorld, ledger: *mut HookeLedger) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let told = engine!(engine, engine => engine.balance());
            write(ledger, told)
        })
    }
}

/// Writes one number for all positions and velocities, bit by bit: FNV-1a over them, by particle, as 64-bit numbers. It
/// is the same on every machine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_digest(world: *mut HookeWorld, digest: *mut u64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let told = engine!(engine, engine => engine.digest());
            write(digest, told)
        })
    }
}
