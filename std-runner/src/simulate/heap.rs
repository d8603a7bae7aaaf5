//! Columns on the heap, for scenes of any size.

use std::cell::Cell;
use std::sync::atomic::{AtomicUsize, Ordering};

use hooke::{Column, Full, Storage};

/// Columns that grow as they are filled.
#[derive(Clone, Copy, Debug)]
pub struct Heap;

/// One column.
///
/// A step runs through a dozen columns at the same index. If all of them began at the same place of a memory page, as
/// large allocations do, those items would all fall into one set of the first cache, which holds eight lines: each
/// column begins a few cache lines further on than the one before.
#[derive(Debug)]
pub struct HeapColumn<T> {
    /// As many items as it takes to begin at the right place, then the column's own.
    items: Vec<T>,
    start: usize,
    /// The byte of a page that it begins at, once it has any items.
    place: Option<usize>,
}

/// Bytes after which the sets of a first cache repeat.
const PAGE: usize = 4096;
/// How much further on the next column begins, bytes: five cache lines, so that a dozen columns share none.
const STAGGER: usize = 320;

/// Places in a page that have been given out.
static PLACES: AtomicUsize = AtomicUsize::new(0);

thread_local! {
    /// Of all items that columns were filled with on this thread. What becomes of a column later does not lessen it.
    static FILLED: Cell<usize> = const { Cell::new(0) };
}

/// The bytes of all items that columns were filled with on this thread so far: what lies between two looks at it is what
/// was asked for in between.
pub(super) fn bytes_filled() -> usize {
    FILLED.get()
}

impl Storage for Heap {
    type Particles<T: Copy> = HeapColumn<T>;
    type Springs<T: Copy> = HeapColumn<T>;
    type Planes<T: Copy> = HeapColumn<T>;
}

impl<T: Copy> HeapColumn<T> {
    /// Makes room for more items, of which `filler` is one.
    fn grow(&mut self, length: usize, filler: T) {
        let capacity = length.max(2 * self.items().len()).max(16);
        let mut items = Vec::with_capacity(capacity + PAGE.div_ceil(size_of::<T>().max(1)));
        let place = self.place.unwrap_or_else(|| PLACES.fetch_add(STAGGER, Ordering::Relaxed));
        let start = place.wrapping_sub(items.as_ptr() as usize) % PAGE / size_of::<T>().max(1);
        items.resize(start, filler);
        items.extend_from_slice(self.items());
        *self = Self { items, start, place: Some(place) };
    }
}

impl<T: Copy> Clone for HeapColumn<T> {
    fn clone(&self) -> Self {
        let mut clone = Self::EMPTY;
        if let [first, ..] = self.items() {
            // Its items lie elsewhere, and begin at a place of their own.
            clone.grow(self.items().len(), *first);
            clone.items.extend_from_slice(self.items());
        }
        clone
    }
}

impl<T: Copy> Column<T> for HeapColumn<T> {
    const EMPTY: Self = Self { items: Vec::new(), start: 0, place: None };

    fn items(&self) -> &[T] {
        self.items.get(self.start..).unwrap_or_default()
    }

    fn items_mut(&mut self) -> &mut [T] {
        self.items.get_mut(self.start..).unwrap_or_default()
    }

    fn push(&mut self, item: T) -> Result<(), T> {
        if self.items.len() == self.items.capacity() {
            self.grow(self.items().len() + 1, item);
        }
        self.items.push(item);
        FILLED.set(FILLED.get() + size_of::<T>());
        Ok(())
    }

    fn fit(&mut self, length: usize) -> Result<(), Full>
    where
        T: Default,
    {
        if self.items().len() != length {
            if self.start + length > self.items.capacity() {
                self.grow(length, T::default());
            }
            FILLED.set(FILLED.get() + size_of::<T>() * length.saturating_sub(self.items().len()));
            self.items.resize(self.start + length, T::default());
        }
        Ok(())
    }
}
