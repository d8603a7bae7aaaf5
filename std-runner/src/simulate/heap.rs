//! Columns on the heap, for scenes of any size.

use hooke::{Column, Full, Storage};

/// Columns that grow as they are filled.
#[derive(Clone, Copy, Debug)]
pub struct Heap;

/// One column.
#[derive(Clone, Debug)]
pub struct HeapColumn<T>(Vec<T>);

impl Storage for Heap {
    type Particles<T: Copy> = HeapColumn<T>;
    type Springs<T: Copy> = HeapColumn<T>;
    type Planes<T: Copy> = HeapColumn<T>;
}

impl<T: Copy> Column<T> for HeapColumn<T> {
    const EMPTY: Self = Self(Vec::new());

    fn items(&self) -> &[T] {
        &self.0
    }

    fn items_mut(&mut self) -> &mut [T] {
        &mut self.0
    }

    fn push(&mut self, item: T) -> Result<(), T> {
        self.0.push(item);
        Ok(())
    }

    fn fit(&mut self, length: usize) -> Result<(), Full>
    where
        T: Default,
    {
        if self.0.len() != length {
            self.0.resize(length, T::default());
        }
        Ok(())
    }
}
