//! Sorting in little code, for programs that are to be compact: a few hundred bytes, where the standard library's
//! takes thousands. Where no two items are alike, the order is the same.

use crate::vectors::{at, put};

/// Items to be sorted, wherever they are kept.
pub trait Unsorted {
    /// Whether the first of two comes before the second.
    fn precedes(&self, first: u32, second: u32) -> bool;

    /// Puts each of two in the other's place.
    fn exchange(&mut self, first: u32, second: u32);
}

/// Sorts `count` items by a heap (Williams, *Algorithm 232*, 1964).
pub fn sort(items: &mut dyn Unsorted, count: u32) {
    // As they are after most changes of a world.
    if (1..count).all(|place| !items.precedes(place, place - 1)) {
        return;
    }
    let mut end = count;
    let mut unordered = count / 2;
    while end > 1 {
        if unordered > 0 {
            unordered -= 1;
        } else {
            end -= 1;
            items.exchange(0, end);
        }
        // What stands here moves down to its place in the heap of the first `end` items.
        let mut place = unordered;
        loop {
            let mut child = 2 * place + 1;
            if child + 1 < end && items.precedes(child, child + 1) {
                child += 1;
            }
            if child >= end || items.precedes(child, place) {
                break;
            }
            items.exchange(place, child);
            place = child;
        }
    }
}

/// Puts two items in each other's place.
#[inline(never)]
pub fn exchange<T: Copy + Default>(items: &mut [T], first: u32, second: u32) {
    let item = at(items, first);
    put(items, first, at(items, second));
    put(items, second, item);
}
