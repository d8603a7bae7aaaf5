//! A world in the memory that a caller supplied: [`HookeWorld`] at its start, columns behind it, a workspace after those.
#![allow(unsafe_code, reason = "worlds and arrays are pointers of the caller's")]

use crate::arena::{Arena, Capacity};
use crate::code::{HOOKE_NOBODY, HookeCode, Outcome, Wrong};
use crate::current;
use crate::engine::{Engine, home_bytes};
use crate::options::HookePrecision;

/// What the memory of a world must be a multiple of, bytes.
pub const HOOKE_ALIGNMENT: usize = 16;

/// What is at the start of a world, so that nothing else is taken for one.
const MAGIC: u64 = 0x686f_6f6b_6520_7731;

/// A world, in memory of the caller's.
#[repr(align(16))]
pub struct HookeWorld {
    magic: u64,
    /// The number of what the last error was about.
    culprit: u32,
    engine: AnyEngine,
}

/// A world in either precision.
#[allow(clippy::large_enum_variant, reason = "there is one of it in a world")]
pub enum AnyEngine {
    #[cfg(feature = "f32")]
    Single(Engine<f32>),
    #[cfg(feature = "f64")]
    Double(Engine<f64>),
}

/// Does something with a world, whatever its precision.
macro_rules! engine {
    ($any:expr, $engine:ident => $task:expr) => {
        match $any {
            #[cfg(feature = "f32")]
            $crate::block::AnyEngine::Single($engine) => $task,
            #[cfg(feature = "f64")]
            $crate::block::AnyEngine::Double($engine) => $task,
        }
    };
}
pub(crate) use engine;

/// The bytes of a real; nothing in a build without such reals.
pub fn real_bytes(precision: HookePrecision) -> Option<usize> {
    match precision {
        HookePrecision::F32 if cfg!(feature = "f32") => Some(4),
        HookePrecision::F64 if cfg!(feature = "f64") => Some(8),
        _ => None,
    }
}

/// The bytes of a world without a workspace.
pub fn bytes(precision: HookePrecision, capacity: Capacity) -> Option<usize> {
    Some(size_of::<HookeWorld>().saturating_add(home_bytes(real_bytes(precision)?, capacity)))
}

/// Some of the caller's memory.
pub fn arena(memory: *mut u8, size: usize, capacity: Option<Capacity>) -> Outcome<Arena> {
    check(memory, size, HOOKE_ALIGNMENT)?;
    Ok(Arena::new(memory, size, capacity))
}

/// Makes a world at the start of some memory.
///
/// # Safety
/// The memory must be so large, and nobody else's as long as the world is used.
pub unsafe fn create(
    memory: *mut u8,
    size: usize,
    precision: HookePrecision,
    capacity: Capacity,
) -> Outcome<*mut HookeWorld> {
    check(memory, size, HOOKE_ALIGNMENT)?;
    let needed = bytes(precision, capacity).ok_or(HookeCode::NoSuchOption)?;
    if size < needed {
        return Err(HookeCode::TooSmall.into());
    }
    let part = |start: usize, end: usize, capacity| Arena::new(memory.wrapping_add(start), end - start, capacity);
    let home = part(size_of::<HookeWorld>(), needed, Some(capacity));
    let workspace = part(needed, size, None);
    let engine = match precision {
        #[cfg(feature = "f32")]
        HookePrecision::F32 => AnyEngine::Single(Engine::new(home, workspace)),
        #[cfg(feature = "f64")]
        HookePrecision::F64 => AnyEngine::Double(Engine::new(home, workspace)),
        #[allow(unreachable_patterns, reason = "which there are depends on the features")]
        _ => return Err(HookeCode::NoSuchOption.into()),
    };
    let world = memory.cast::<HookeWorld>();
    // SAFETY: the memory is large enough, aligned, and the caller lends it.
    unsafe { world.write(HookeWorld { magic: MAGIC, culprit: HOOKE_NOBODY, engine }) };
    Ok(world)
}

/// Does something with the world at an address, and remembers what went wrong.
///
/// # Safety
/// The address must be null, or that of memory as large as a world that may be read and that nobody else uses meanwhile: where
/// one call at a time is let in, nobody but a call that is under way.
pub unsafe fn with(world: *mut HookeWorld, task: impl FnOnce(&mut AnyEngine) -> Outcome) -> HookeCode {
    // SAFETY: as the caller says.
    if let Err(code) = unsafe { enter(world) } {
        return code;
    }
    // SAFETY: a world has been made here, and nobody else uses it.
    let outcome = task(unsafe { &mut (*world).engine });
    // SAFETY: as above.
    unsafe { leave(world, outcome) }
}

/// The number of what the last error of a world was about; that of nobody while a call is under way that keeps others out.
///
/// # Safety
/// As for [`with`].
pub unsafe fn culprit(world: *const HookeWorld) -> u32 {
    let mut culprit = HOOKE_NOBODY;
    // SAFETY: as the caller says; it is only read.
    unsafe {
        if enter(world.cast_mut()).is_ok() {
            culprit = (*world).culprit;
            current::end();
        }
    }
    culprit
}

/// Ends a world: its memory is the caller's again, and its address is refused from now on.
///
/// # Safety
/// As for [`with`].
pub unsafe fn destroy(world: *mut HookeWorld) -> HookeCode {
    // SAFETY: as the caller says.
    unsafe {
        if let Err(code) = enter(world) {
            return code;
        }
        (*world).magic = 0;
        leave(world, Ok(()))
    }
}

/// Begins a call with the world at an address, and only then looks whether there is one: whoever comes while a call is under
/// way is told so before.
///
/// # Safety
/// As for [`with`].
#[inline(never)]
unsafe fn enter(world: *mut HookeWorld) -> Result<(), HookeCode> {
    check(world, 1, HOOKE_ALIGNMENT).map_err(Wrong::code)?;
    if !current::begin() {
        return Err(HookeCode::Busy);
    }
    // SAFETY: it is aligned, and the caller says that it may be read.
    if unsafe { (&raw const (*world).magic).read() } != MAGIC {
        current::end();
        return Err(HookeCode::NotAWorld);
    }
    Ok(())
}

/// Ends a call, and remembers what went wrong.
///
/// # Safety
/// It must have been begun by [`enter`].
#[inline(never)]
unsafe fn leave(world: *mut HookeWorld, outcome: Outcome) -> HookeCode {
    if let Err(wrong) = outcome {
        // SAFETY: there is a world, which nobody else uses.
        unsafe { (*world).culprit = wrong.number() };
    }
    current::end();
    outcome.err().map_or(HookeCode::Ok, Wrong::code)
}

/// So many items of the caller's.
///
/// # Safety
/// They must be there, and nobody may write to them meanwhile.
pub unsafe fn items<'a, T>(pointer: *const T, count: usize) -> Outcome<&'a [T]> {
    if count == 0 {
        return Ok(&[]);
    }
    check(pointer, count, align_of::<T>())?;
    // SAFETY: it is neither null nor misaligned, and the caller says that the items are there.
    Ok(unsafe { core::slice::from_raw_parts(pointer, count) })
}

/// The same; none where the pointer is null.
///
/// # Safety
/// As for [`items`].
pub unsafe fn items_if_any<'a, T>(pointer: *const T, count: usize) -> Outcome<&'a [T]> {
    // SAFETY: as the caller says.
    unsafe { items(pointer, if pointer.is_null() { 0 } else { count }) }
}

/// So many items of the caller's, to be written.
///
/// # Safety
/// They must be there, and nobody else may use them meanwhile.
pub unsafe fn items_mut<'a, T>(pointer: *mut T, count: usize) -> Outcome<&'a mut [T]> {
    if count == 0 {
        return Ok(&mut []);
    }
    check(pointer, count, align_of::<T>())?;
    // SAFETY: it is neither null nor misaligned, and the caller says that the items are there.
    Ok(unsafe { core::slice::from_raw_parts_mut(pointer, count) })
}

/// The same; none where the pointer is null.
///
/// # Safety
/// As for [`items_mut`].
pub unsafe fn items_mut_if_any<'a, T>(pointer: *mut T, count: usize) -> Outcome<&'a mut [T]> {
    // SAFETY: as the caller says.
    unsafe { items_mut(pointer, if pointer.is_null() { 0 } else { count }) }
}

/// Writes a result.
///
/// # Safety
/// As for [`items_mut`].
pub unsafe fn write<T>(pointer: *mut T, value: T) -> Outcome {
    check(pointer, 1, align_of::<T>())?;
    // SAFETY: it is neither null nor misaligned, and the caller says that it may be written.
    unsafe { pointer.write(value) };
    Ok(())
}

/// Writes a result where the caller wants it; a null pointer is one who does not.
///
/// # Safety
/// As for [`items_mut`].
pub unsafe fn write_if_asked<T>(pointer: *mut T, value: T) -> Outcome {
    // SAFETY: as the caller says.
    if pointer.is_null() { Ok(()) } else { unsafe { write(pointer, value) } }
}

fn check<T>(pointer: *const T, count: usize, alignment: usize) -> Outcome {
    check_bytes(pointer as usize, count, size_of::<T>(), alignment)
}

#[inline(never)]
fn check_bytes(address: usize, count: usize, size: usize, alignment: usize) -> Outcome {
    if address == 0 {
        return Err(HookeCode::NullPointer.into());
    }
    if !address.is_multiple_of(alignment) {
        return Err(HookeCode::Misaligned.into());
    }
    let bytes = count.checked_mul(size).filter(|bytes| *bytes <= isize::MAX as usize);
    let is_there = bytes.and_then(|bytes| address.checked_add(bytes)).is_some();
    if is_there { Ok(()) } else { Err(HookeCode::Length.into()) }
}
