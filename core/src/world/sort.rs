//! Sorting in little code, for programs that have less flash than time: a few hundred bytes, where the standard library's
//! takes thousands. Where no two items are alike, the order is the same.

/// Sorts `count` items by a heap (Williams, *Algorithm 232*, 1964), wherever they are kept: `precedes` tells whether the
/// first of two comes before the second, and `exchange` puts each in the other's place.
pub fn sort<T: ?Sized>(
    items: &mut T,
    count: u32,
    precedes: impl Fn(&T, u32, u32) -> bool,
    mut exchange: impl FnMut(&mut T, u32, u32),
) {
    let mut end = count;
    let mut unordered = count / 2;
    while end > 1 {
        if unordered > 0 {
            unordered -= 1;
        } else {
            end -= 1;
            exchange(items, 0, end);
        }
        // What stands here moves down to its place in the heap of the first `end` items.
        let mut place = unordered;
        loop {
            let mut child = 2 * place + 1;
            if child + 1 < end && precedes(items, child, child + 1) {
                child += 1;
            }
            if child >= end || precedes(items, child, place) {
                break;
            }
            exchange(items, place, child);
            place = child;
        }
    }
}

/// Puts two items in each other's place.
#[inline(never)]
pub fn exchange<T>(items: &mut [T], first: u32, second: u32) {
    if let Ok([first, second]) = items.get_disjoint_mut([first as usize, second as usize]) {
        core::mem::swap(first, second);
    }
}
