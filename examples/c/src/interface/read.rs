//! Reading the state, and what became of the energy.
#![allow(unsafe_code, reason = "this is the interface to another language")]
#![allow(clippy::missing_safety_doc, reason = "the header says it once for all of them")]

use crate::block::{HookeWorld, engine, items_mut, with};
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
        with(world, |engine| engine!(engine, engine => read([position, velocity], length, engine.states(), |x| x)))
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
        with(
            world,
            |engine| engine!(engine, engine => read([position, velocity], length, engine.states(), |x| x as f32)),
        )
    }
}

unsafe fn read<T: Copy>(
    to: [*mut T; 2],
    length: usize,
    states: impl ExactSizeIterator<Item = [[f64; 3]; 2]>,
    rounded: impl Fn(f64) -> T,
) -> Outcome {
    if length != 3 * states.len() {
        return Err(HookeCode::Length.into());
    }
    let [mut position, mut velocity] = [&mut [] as &mut [[T; 3]], &mut []];
    for (pointer, columns) in to.into_iter().zip([&mut position, &mut velocity]) {
        if !pointer.is_null() {
            // SAFETY: as the header says.
            *columns = unsafe { items_mut(pointer, length)? }.as_chunks_mut().0;
        }
    }
    for (number, [x, v]) in states.enumerate() {
        for (columns, vector) in [&mut *position, &mut *velocity].into_iter().zip([x, v]) {
            if let Some(place) = columns.get_mut(number) {
                *place = vector.map(&rounded);
            }
        }
    }
    Ok(())
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
            let told = items_mut(ledger, 1)?;
            told.fill(engine!(engine, engine => engine.balance()));
            Ok(())
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
            let told = items_mut(digest, 1)?;
            told.fill(engine!(engine, engine => engine.digest()));
            Ok(())
        })
    }
}
