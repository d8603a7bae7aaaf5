//! The arena that columns grow in now: one a thread, or one in all where there is no operating system to tell threads
//! apart. There, [`begin`] keeps a second call out while one is under way.
#![allow(unsafe_code, reason = "the current arena is a pointer to one that outlives the task it is lent to")]

use core::cell::Cell;
use core::ptr::null;

use crate::arena::Arena;

/// Runs a task while an arena is the current one.
pub fn with<T>(arena: &Arena, task: impl FnOnce() -> T) -> T {
    let before = CURRENT.replace(arena);
    let result = task();
    CURRENT.replace(before);
    result
}

/// Does something with the current arena, if there is one.
pub fn arena<T>(task: impl FnOnce(&Arena) -> T) -> Option<T> {
    let arena = CURRENT.get();
    // SAFETY: it was lent by a call of `with` that has not returned.
    unsafe { arena.as_ref() }.map(task)
}

/// A pointer to the current arena.
struct Current;
const CURRENT: Current = Current;

#[cfg(feature = "std")]
mod place {
    use super::{Arena, Cell, Current, null};

    std::thread_local! {
        static PLACE: Cell<*const Arena> = const { Cell::new(null()) };
    }

    impl Current {
        pub fn get(&self) -> *const Arena {
            PLACE.get()
        }
        pub fn replace(&self, arena: *const Arena) -> *const Arena {
            PLACE.replace(arena)
        }
    }

    /// Begins a call.
    pub fn begin() -> bool {
        true
    }

    /// Ends it.
    pub fn end() {}
}

#[cfg(not(feature = "std"))]
mod place {
    use super::{Arena, Cell, Current, null};
    use core::sync::atomic::{AtomicBool, Ordering};

    struct Place(Cell<*const Arena>);
    // SAFETY: only who has entered touches it.
    unsafe impl Sync for Place {}
    static PLACE: Place = Place(Cell::new(null()));
    static IS_BUSY: AtomicBool = AtomicBool::new(false);

    impl Current {
        pub fn get(&self) -> *const Arena {
            PLACE.0.get()
        }
        pub fn replace(&self, arena: *const Arena) -> *const Arena {
            PLACE.0.replace(arena)
        }
    }

    /// Begins a call, unless another one is under way.
    #[cfg(target_has_atomic = "8")]
    pub fn begin() -> bool {
        !IS_BUSY.swap(true, Ordering::Acquire)
    }

    /// The same, on one core without an exchange: what interrupts this between the two lines is done before the second.
    #[cfg(not(target_has_atomic = "8"))]
    pub fn begin() -> bool {
        let is_free = !IS_BUSY.load(Ordering::Acquire);
        if is_free {
            IS_BUSY.store(true, Ordering::Release);
        }
        is_free
    }

    /// Ends it.
    pub fn end() {
        IS_BUSY.store(false, Ordering::Release);
    }
}

pub use place::{begin, end};
