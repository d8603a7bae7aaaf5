//! Sums whose order is fixed: the same bits whatever the machine's vector width or number of threads.

use core::ops::Add;

/// Terms that are added one after the other before their sum joins the tree.
const BLOCK: u32 = 64;
/// Levels of the tree: enough for 2³² terms.
const LEVELS: usize = 32;

/// The sum of `count` terms: in blocks of 64, joined in a balanced tree that depends on `count` alone.
///
/// Its rounding error grows with the logarithm of `count`, where a running sum's grows with `count` (Higham,
/// *Accuracy and Stability of Numerical Algorithms*, §4.2).
#[inline(always)]
pub fn sum<T: Copy + Default + Add<Output = T>>(count: u32, term: impl Fn(u32) -> T) -> T {
    if cfg!(feature = "small") {
        // One copy for whatever is summed.
        return in_tree::<T, &dyn Fn(u32) -> T>(count, &term);
    }
    in_tree(count, term)
}

fn in_tree<T: Copy + Default + Add<Output = T>, F: Fn(u32) -> T>(count: u32, term: F) -> T {
    // One pending partial sum a level; bit k of the number of blocks so far tells whether level k holds one.
    let mut pending = [T::default(); LEVELS];
    let mut blocks = 0_u32;
    let mut start = 0_u32;
    while start < count {
        let end = start.saturating_add(BLOCK).min(count);
        let mut joined = (start..end).fold(T::default(), |total, index| total + term(index));
        for (level, partial) in pending.iter_mut().enumerate() {
            if blocks >> level & 1 == 0 {
                *partial = joined;
                break;
            }
            joined = *partial + joined;
        }
        blocks += 1;
        start = end;
    }
    let mut total = T::default();
    for (level, partial) in pending.iter().enumerate() {
        if blocks >> level & 1 == 1 {
            total = *partial + total;
        }
    }
    total
}
