//! Columns in memory that a caller has supplied.
//!
//! A column does not know its arena: [`hooke::Column::EMPTY`] is a constant. It takes its memory from the arena that is
//! current while it grows, which [`Arena::lend`] sees to.
#![allow(unsafe_code, reason = "columns are made of memory that the caller supplied")]

use core::cell::Cell;
use core::marker::PhantomData;
use core::ptr::NonNull;

use hooke::{Column, Full, Storage};

use crate::current;

/// Where columns begin: what vectors of 128 bits want.
const ALIGNMENT: usize = 16;
/// A line of the cache, where longer columns begin.
const LINE: usize = 64;
/// Bytes after which the sets of a first cache repeat.
const PAGE: usize = 4096;
/// Between columns of a page or more, so that items at the same place of a dozen columns fall into different sets.
const STAGGER: usize = 320;

/// How many particles, springs and planes columns are made for when they are first filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Capacity {
    /// Of [`PARTICLES`], [`SPRINGS`] and [`PLANES`].
    pub of: [usize; 3],
}

const PARTICLES: usize = 0;
const SPRINGS: usize = 1;
const PLANES: usize = 2;

/// Memory that is handed out from the bottom up, and only taken back as a whole.
#[derive(Debug)]
pub struct Arena {
    start: usize,
    next: Cell<usize>,
    /// Where the last column ends.
    last: Cell<usize>,
    end: usize,
    /// Where columns are made for all they will ever hold; else they grow.
    capacity: Option<Capacity>,
    /// Whether there was a column that it had no room for.
    has_refused: Cell<bool>,
    /// Whether it only counts what it is asked for.
    counts: bool,
}

impl Arena {
    /// Of some memory, which must be nobody else's as long as columns made of it are used.
    pub fn new(memory: *mut u8, size: usize, capacity: Option<Capacity>) -> Self {
        let start = memory as usize;
        let (next, last) = (Cell::new(start), Cell::new(start));
        let end = start.saturating_add(size);
        Self { start, next, last, end, capacity, has_refused: Cell::new(false), counts: false }
    }

    /// One that hands out nothing, and counts the bytes of what it is asked for.
    pub fn counting() -> Self {
        let (next, last) = (Cell::new(0), Cell::new(0));
        Self { start: 0, next, last, end: usize::MAX, capacity: None, has_refused: Cell::new(false), counts: true }
    }

    /// The bytes that it has been asked for, if it counts.
    pub fn counted(&self) -> usize {
        self.next.get()
    }

    /// Whether there was a column that it had no room for.
    pub fn has_refused(&self) -> bool {
        self.has_refused.get()
    }

    /// Whether any of it has been handed out.
    pub fn is_used(&self) -> bool {
        self.next.get() > self.start
    }

    /// Takes all of it back: of columns made of it, none may be left.
    pub fn take_back(&self) {
        self.next.set(self.start);
        self.last.set(self.start);
        self.has_refused.set(false);
    }

    /// Runs something whose columns take their memory from here.
    pub fn lend<T>(&self, task: impl FnOnce() -> T) -> T {
        current::with(self, task)
    }

    /// An upper bound of what a column takes, bytes.
    pub const fn bytes_of(items: usize, size: usize) -> usize {
        let bytes = items.saturating_mul(size);
        let spare = if bytes >= PAGE { LINE + STAGGER } else { ALIGNMENT };
        if bytes == 0 { 0 } else { bytes.saturating_add(spare) }
    }

    /// The same of several columns: so many, of so many items, of so many bytes each.
    pub fn bytes_of_all(columns: &[(usize, usize, usize)]) -> usize {
        let mut bytes: usize = 0;
        for (count, items, size) in columns {
            bytes = bytes.saturating_add(Self::bytes_of(*items, *size).saturating_mul(*count));
        }
        bytes
    }

    /// The address of so many bytes.
    fn take(&self, bytes: usize) -> Option<usize> {
        if self.counts {
            self.next.set(self.next.get().saturating_add(Self::bytes_of(bytes, 1)));
            return Some(0);
        }
        let (alignment, gap) = if bytes >= PAGE { (LINE, STAGGER) } else { (ALIGNMENT, 0) };
        let start = self.next.get().checked_next_multiple_of(alignment)?;
        let end = start.checked_add(bytes)?;
        let fits = end <= self.end;
        if fits {
            self.last.set(end);
            self.next.set(end.saturating_add(gap));
        } else {
            self.has_refused.set(true);
        }
        fits.then_some(start)
    }

    /// More bytes after those that end at `end`, if they are the last that were handed out.
    fn extend(&self, end: usize, bytes: usize) -> bool {
        let Some(new_end) = end.checked_add(bytes) else { return false };
        // What was followed by a gap has room to grow into it.
        let fits = end == self.last.get() && new_end <= self.end;
        if fits {
            self.last.set(new_end);
            self.next.set(new_end.max(self.next.get()));
        }
        fits
    }
}

/// Columns of an [`Arena`].
#[derive(Clone, Copy, Debug)]
pub struct InArena;

impl Storage for InArena {
    type Particles<T: Copy> = ArenaColumn<T, PARTICLES>;
    type Springs<T: Copy> = ArenaColumn<T, SPRINGS>;
    type Planes<T: Copy> = ArenaColumn<T, PLANES>;
}

/// One column, with an item for each particle, spring or plane.
#[derive(Debug)]
pub struct ArenaColumn<T, const OF: usize> {
    stretch: Stretch,
    owns: PhantomData<T>,
}

/// A stretch of memory for items of some size: what is the same for columns of whatever. All that is asked of one must be of the
/// same [`Kind`].
#[derive(Debug)]
struct Stretch {
    start: NonNull<u8>,
    /// How many items have been written there.
    length: usize,
    /// How many have room.
    capacity: usize,
}

/// Items as a [`Stretch`] has to know them.
#[derive(Clone, Copy, Debug)]
struct Kind {
    /// Bytes of one.
    size: usize,
    /// Which of a [`Capacity`].
    of: usize,
}

impl Stretch {
    /// Makes room for so many items in all, and tells whether there is.
    fn reach(&mut self, kind: Kind, length: usize) -> bool {
        length <= self.capacity || current::arena(|arena| self.reach_in(arena, kind, length)).flatten().is_some()
    }

    fn reach_in(&mut self, arena: &Arena, Kind { size, of }: Kind, length: usize) -> Option<()> {
        if let Some(capacity) = arena.capacity {
            let most = capacity.of.get(of).copied().unwrap_or_default();
            // A world's columns are made once, for all that they are to hold.
            if self.capacity > 0 || length > most {
                return None;
            }
            self.start = NonNull::new(arena.take(most.checked_mul(size)?)? as *mut u8)?;
            self.capacity = most;
            return Some(());
        }
        let more = (length - self.capacity).checked_mul(size)?;
        if self.capacity > 0 && arena.extend(self.start.as_ptr() as usize + self.capacity * size, more) {
            self.capacity = length;
            return Some(());
        }
        // What grows once may grow again, and cannot where it is if something else follows it.
        let capacity = if self.capacity == 0 { length } else { length.max(2 * self.capacity) };
        let start = arena.take(capacity.checked_mul(size)?)?;
        if arena.counts {
            return Some(());
        }
        let start = NonNull::new(start as *mut u8)?;
        // SAFETY: the first so many items have been written, and those at the new place are memory of their own.
        unsafe { core::ptr::copy_nonoverlapping(self.start.as_ptr(), start.as_ptr(), self.length * size) };
        self.start = start;
        self.capacity = capacity;
        Some(())
    }

    /// Makes it so many items long, and tells whether there is room: new ones are copies of one.
    ///
    /// # Safety
    /// The one must be there to be read, as large as the kind says, outside of this stretch; and the kind the same in every call.
    unsafe fn fit(&mut self, kind: Kind, length: usize, one: *const u8) -> bool {
        if !self.reach(kind, length) {
            return false;
        }
        // Where memory is only counted, there is none.
        let length = length.min(self.capacity);
        let missing = length.saturating_sub(self.length) * kind.size;
        let mut written = kind.size.min(missing);
        // SAFETY: the places are within the stretch, from the end of its items on; every copy is of what is before it.
        unsafe {
            let start = self.start.as_ptr().add(self.length * kind.size);
            core::ptr::copy_nonoverlapping(one, start, written);
            while written < missing {
                let more = written.min(missing - written);
                core::ptr::copy_nonoverlapping(start, start.add(written), more);
                written += more;
            }
        }
        self.length = length;
        true
    }
}

impl<T: Copy, const OF: usize> ArenaColumn<T, OF> {
    /// Makes it so many items long, and tells whether there is room: new ones are copies of `item`.
    fn fit_with(&mut self, length: usize, item: &T) -> bool {
        if size_of::<T>() == 0 {
            self.stretch.length = length;
            return true;
        }
        let kind = Kind { size: size_of::<T>(), of: OF };
        // SAFETY: the item is borrowed, and the memory of a column is its alone.
        align_of::<T>() <= ALIGNMENT && unsafe { self.stretch.fit(kind, length, (&raw const *item).cast()) }
    }
}

impl<T: Copy, const OF: usize> Clone for ArenaColumn<T, OF> {
    /// In the current arena; without items where that has no room for them, which it then remembers.
    fn clone(&self) -> Self {
        let mut clone = Self::EMPTY;
        for item in self.items() {
            if clone.push(*item).is_err() {
                return Self::EMPTY;
            }
        }
        clone
    }
}

impl<T: Copy, const OF: usize> Column<T> for ArenaColumn<T, OF> {
    const EMPTY: Self =
        Self { stretch: Stretch { start: NonNull::<T>::dangling().cast(), length: 0, capacity: 0 }, owns: PhantomData };

    fn items(&self) -> &[T] {
        // SAFETY: so many items have been written there, to memory that is this column's alone.
        unsafe { core::slice::from_raw_parts(self.stretch.start.as_ptr().cast(), self.stretch.length) }
    }

    fn items_mut(&mut self) -> &mut [T] {
        // SAFETY: as above, and the column is borrowed for as long.
        unsafe { core::slice::from_raw_parts_mut(self.stretch.start.as_ptr().cast(), self.stretch.length) }
    }

    fn push(&mut self, item: T) -> Result<(), T> {
        if self.fit_with(self.stretch.length + 1, &item) { Ok(()) } else { Err(item) }
    }

    fn fit(&mut self, length: usize) -> Result<(), Full>
    where
        T: Default,
    {
        let is_fit = self.fit_with(length, &T::default());
        if is_fit { Ok(()) } else { Err(Full { capacity: self.stretch.capacity }) }
    }
}
