//! Where columns are kept: a capacity fixed in the type, or whatever else implements [`Storage`].

use crate::types::Full;

/// A growable array: one quantity of all particles, springs or planes.
pub trait Column<T: Copy>: Clone {
    /// Without any items.
    const EMPTY: Self;
    /// All items.
    fn items(&self) -> &[T];
    /// All items.
    fn items_mut(&mut self) -> &mut [T];

    /// Appends an item.
    ///
    /// # Errors
    /// Hands the item back if there is no room for it.
    fn push(&mut self, item: T) -> Result<(), T>;

    /// Makes it `length` items long; new ones are `T`'s default.
    ///
    /// # Errors
    /// If there is no room; it is then as it was.
    fn fit(&mut self, length: usize) -> Result<(), Full>
    where
        T: Default;
}

/// A family of columns: how many particles, springs and planes there can be.
///
/// Kernels take slices, never a storage, so one compiled copy of them serves every capacity.
pub trait Storage {
    /// A column with an item for each particle.
    type Particles<T: Copy>: Column<T>;
    /// A column with an item for each spring.
    type Springs<T: Copy>: Column<T>;
    /// A column with an item for each plane.
    type Planes<T: Copy>: Column<T>;
    /// How many particles there can be at most, where that is known: what only larger worlds need is then left out of a
    /// program.
    const MOST_PARTICLES: usize = usize::MAX;
}

/// Columns of `heapless`: the capacities are part of the type, and nothing is ever allocated.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<const PARTICLES: usize, const SPRINGS: usize, const PLANES: usize>;

impl<const PARTICLES: usize, const SPRINGS: usize, const PLANES: usize> Storage for Fixed<PARTICLES, SPRINGS, PLANES> {
    type Particles<T: Copy> = heapless::Vec<T, PARTICLES>;
    type Springs<T: Copy> = heapless::Vec<T, SPRINGS>;
    type Planes<T: Copy> = heapless::Vec<T, PLANES>;
    const MOST_PARTICLES: usize = PARTICLES;
}

impl<T: Copy, const CAPACITY: usize> Column<T> for heapless::Vec<T, CAPACITY> {
    const EMPTY: Self = Self::new();

    fn items(&self) -> &[T] {
        self
    }

    fn items_mut(&mut self) -> &mut [T] {
        self
    }

    #[cfg_attr(feature = "compact", inline(never))]
    fn push(&mut self, item: T) -> Result<(), T> {
        self.push(item)
    }

    fn fit(&mut self, length: usize) -> Result<(), Full>
    where
        T: Default,
    {
        self.resize(length, T::default()).map_err(|_| Full { capacity: CAPACITY })
    }
}
