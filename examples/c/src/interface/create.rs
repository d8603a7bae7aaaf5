//! Making and ending worlds, and the memory that they take.
#![allow(unsafe_code, reason = "this is the interface to another language")]
#![allow(clippy::missing_safety_doc, reason = "the header says it once for all of them")]
#![allow(clippy::too_many_arguments, reason = "capacities are three numbers")]

use core::ffi::{c_char, c_void};

use hooke::{Coverage, Plan, Real, Response};

use super::{capacity, chosen, coded};
use crate::arena::Arena;
use crate::block::{self, HookeWorld, engine, items_mut, real_bytes, with};
use crate::code::HookeCode;
use crate::current;
use crate::method::{AnyResponse, AnyStepper, FILL};
use crate::options::{HookeCollision, HookePrecision, HookeStepper};

/// A code in words: a string that is always there.
#[unsafe(no_mangle)]
pub extern "C" fn hooke_message(code: i32) -> *const c_char {
    HookeCode::message(code).as_ptr()
}

/// The bytes of a world of so many particles, springs and planes, without a workspace for its stepper; 0 if there is no
/// such precision.
#[unsafe(no_mangle)]
pub extern "C" fn hooke_size_of(precision: u32, particles: u32, springs: u32, planes: u32) -> usize {
    let bytes = HookePrecision::numbered(precision)
        .and_then(|precision| block::bytes(precision, capacity(particles, springs, planes)));
    bytes.unwrap_or(0)
}

/// The bytes of the workspace that a stepper and a form of collision need in such a world; 0 if there is no such option, and
/// without `std` while another call is under way.
///
/// Implicit steppers, and `HOOKE_STEPPER_AUTO` where it turns to one, solve their linear systems by a factorisation where that
/// is less work. A factor has blocks: as many as there are springs are enough for ropes, chains and trees, 16 times as many for a
/// cloth of 64 x 64. With less room than it needs, a step is refused, unless `hooke_set_workspace` allowed doing without.
#[unsafe(no_mangle)]
pub extern "C" fn hooke_workspace_size(
    precision: u32,
    stepper: u32,
    collision: u32,
    particles: u32,
    springs: u32,
    planes: u32,
    factor_blocks: u32,
) -> usize {
    let options =
        (HookePrecision::numbered(precision), HookeStepper::numbered(stepper), HookeCollision::numbered(collision));
    let (Some(precision), Some(stepper), Some(collision)) = options else { return 0 };
    // Whatever there may be in such a world.
    let damped = Coverage::Some;
    let plan = |attached: u32| Plan { particles, attached, springs, planes, damped, gravity: true, ..Plan::default() };
    let bytes = |attached: u32| match precision {
        #[cfg(feature = "f32")]
        HookePrecision::F32 => workspace::<f32>(stepper, collision, &plan(attached)),
        #[cfg(feature = "f64")]
        HookePrecision::F64 => workspace::<f64>(stepper, collision, &plan(attached)),
        #[allow(unreachable_patterns, reason = "which there are depends on the features")]
        _ => 0,
    };
    let factor = if stepper.may_factor() && springs > 0 {
        factor_bytes(real_bytes(precision).unwrap_or(0), particles as usize, springs as usize, factor_blocks as usize)
    } else {
        0
    };
    // What springs pull at takes room for one thing, what flies freely for another.
    if !current::begin() {
        return 0;
    }
    let all = bytes(particles).max(bytes(0)).max(bytes(particles / 2));
    current::end();
    all.saturating_add(factor)
}

fn workspace<R: Real>(stepper: HookeStepper, collision: HookeCollision, plan: &Plan) -> usize {
    let arena = Arena::counting();
    let fitted = arena.lend(|| {
        AnyStepper::<R>::named(stepper, 1.0).any().fit(plan).and_then(|()| AnyResponse::<R>::named(collision).fit(plan))
    });
    if fitted.is_ok() { arena.counted() } else { usize::MAX }
}

/// As in the core's `solve/room.rs`.
fn factor_bytes(real: usize, particles: usize, springs: usize, blocks: usize) -> usize {
    let chunk = FILL;
    let chunks = blocks.div_ceil(chunk).min(springs);
    // Entries are sought with room for as many as there are springs, then for twice as many, until it is enough.
    let mut sought = springs.div_ceil(chunk);
    while sought < chunks {
        sought = (2 * sought).min(springs);
    }
    Arena::bytes_of_all(&[
        (1, particles, 28),
        (3, particles, 4),
        (1, springs, 8),
        (1, sought, 4 * chunk),
        (1, chunks, 12 * real * chunk),
        (1, particles, 6 * real),
        (1, particles, 3 * real),
    ])
}

/// Makes a world in `size` bytes of memory, without anything in it, at 0 s. What `hooke_size_of` leaves of the memory is
/// its workspace. It steps with `HOOKE_STEPPER_SEMI_IMPLICIT_EULER` and `HOOKE_COLLISION_REFLECT`, which need none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_create(
    memory: *mut c_void,
    size: usize,
    precision: u32,
    particles: u32,
    springs: u32,
    planes: u32,
    world: *mut *mut HookeWorld,
) -> HookeCode {
    let create = || {
        let precision = chosen(HookePrecision::numbered(precision))?;
        // SAFETY: the caller supplies the memory, and a place for the address.
        unsafe {
            let world = items_mut(world, 1)?;
            let created = block::create(memory.cast(), size, precision, capacity(particles, springs, planes))?;
            world.fill(created);
        }
        Ok(())
    };
    coded(create())
}

/// Ends a world: its memory is the caller's again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_destroy(world: *mut HookeWorld) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { block::destroy(world) }
}

/// The number of the particle, spring or plane that the last error of a world was about; `UINT32_MAX` if of none, and
/// without `std` while another call is under way.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_culprit(world: *const HookeWorld) -> u32 {
    // SAFETY: as the header says.
    unsafe { block::culprit(world) }
}

/// Gives a world another workspace; the stepper and the collisions begin anew. `without_factor` is 1 if implicit steps
/// may go on by conjugate gradients where a factor has no room, else 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_workspace(
    world: *mut HookeWorld,
    memory: *mut c_void,
    size: usize,
    without_factor: u32,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let arena = block::arena(memory.cast(), size, None)?;
            engine!(engine, engine => {
                engine.choices.may_do_without_factor = without_factor != 0;
                engine.set_workspace(arena);
            });
            Ok(())
        })
    }
}
