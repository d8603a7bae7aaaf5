//! Sums whose order is fixed: the same bits whatever the machine's vector width or number of threads.

use core::ops::Add;

/// Terms that are added one after the other before their sum joins the tree.
const BLOCK: u32 = 64;

/// The sum of `count` terms: in blocks of 64, joined in a balanced tree that depends on `count` alone.
///
/// Its rounding error grows with the logarithm of `count`, where a running sum's grows with `count` (Higham,
/// *Accuracy and Stability of Numerical Algorithms*, §4.2).
#[inline(always)]
pub fn sum<T: Copy + Default + Add<Output = T>>(count: u32, term: impl Fn(u32) -> T) -> T {
    if cfg!(feature = "compact") {
        // One copy for whatever is summed.
        return branch::<T, dyn Fn(u32) -> T>(0, count, &term);
    }
    branch(0, count, &term)
}

/// The sum of `count` terms from `first` on.
fn branch<T: Copy + Default + Add<Output = T>, F: Fn(u32) -> T + ?Sized>(first: u32, count: u32, term: &F) -> T {
    let Some(depth) = (count.saturating_sub(1) / BLOCK).checked_ilog2() else {
        return (first..first + count).fold(T::default(), |total, index| total + term(index));
    };
    // As many blocks as a power of two has, and fewer than all, are a balanced tree of their own.
    let left = BLOCK << depth;
    branch(first, left, term) + branch(first + left, count - left, term)
}
