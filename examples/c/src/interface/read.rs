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
            let position = Vectors::Double(items_mut_if_any(position, length)?.as_chunks_mut().0);
            let velocity = Vectors::Double(items_mut_if_any(velocity, length)?.as_chunks_mut().0);
            read(engine, position, velocity);
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
            let position = Vectors::Single(items_mut_if_any(position, length)?.as_chunks_mut().0);
            let velocity = Vectors::Single(items_mut_if_any(velocity, length)?.as_chunks_mut().0);
            read(engine, position, velocity);
            Ok(())
        })
    }
}

/// Where vectors are written to; those that have no place there are left out.
enum Vectors<'a> {
    Single(&'a mut [[f32; 3]]),
    Double(&'a mut [[f64; 3]]),
}

impl Vectors<'_> {
    fn write(&mut self, place: usize, vector: [f64; 3]) {
        let [x, y, z] = vector;
        match self {
            Self::Single(vectors) => vectors.get_mut(place).map(|to| *to = [x as f32, y as f32, z as f32]),
            Self::Double(vectors) => vectors.get_mut(place).map(|to| *to = vector),
        };
    }
}

fn check_length(engine: &AnyEngine, length: usize) -> Outcome {
    let [particles, ..] = engine!(engine, engine => engine.counts());
    if length == 3 * particles as usize { Ok(()) } else { Err(HookeCode::Length.into()) }
}

fn read(engine: &AnyEngine, mut position: Vectors<'_>, mut velocity: Vectors<'_>) {
    engine!(engine, engine => for (place, [x, v]) in engine.states().enumerate() {
        position.write(place, x);
        velocity.write(place, v);
    });
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
