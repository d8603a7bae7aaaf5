//! An order of the particles of an island in which springs reach as few slots as may be.
//!
//! Breadth first, neighbours by their degrees (Cuthill and McKee, *Reducing the bandwidth of sparse symmetric matrices*,
//! 1969), from a particle that is as far from another one as any, or nearly (George and Liu, *An implementation of a
//! pseudoperipheral node finder*, 1979). Whoever uses it turns it round, which leaves no spring longer and factors
//! sparser (Liu and Sherman, *Comparative analysis of the Cuthill–McKee and the reverse Cuthill–McKee ordering
//! algorithms*, 1976).

use core::ops::Range;

use super::layout::Incidence;
use super::sort::{Unsorted, exchange, sort};
use super::view::incidences_of;
use crate::vectors::{at, items_of, put};

/// Searches in all: each begins at the far end of the one before. Three are common, and a few more find a longer way.
const SEARCHES: u8 = 8;

/// The springs as lists of neighbours, by slot, and room for an order.
pub struct Graph<'a> {
    /// Where the list of each slot ends; it begins where that of the slot before ends.
    pub list_end: &'a [u32],
    /// Where each names its spring, there is room: for the slots of an order, in the places that they are slots of. There
    /// are at least as many incidences as slots with springs.
    pub incidences: &'a mut [Incidence],
    /// The last search that has found each slot.
    pub found_by: &'a mut [u8],
}

/// What a search from a particle comes to.
struct Searched {
    /// How far the furthest are from it, in springs.
    depth: u32,
    /// The places of the furthest.
    furthest: Range<u32>,
}

impl Graph<'_> {
    /// The slots at the other ends of a slot's springs.
    pub fn neighbours(&self, slot: u32) -> impl Iterator<Item = u32> {
        incidences_of(slot, self.list_end, self.incidences).iter().map(|incidence| incidence.neighbour)
    }

    /// The slot in a place of the order.
    pub fn in_place(&self, place: u32) -> u32 {
        at(self.incidences, place).spring
    }

    /// Finds an order of the slots of an island.
    pub fn order(&mut self, island: &Range<u32>) {
        self.sort(island);
        self.found_by.get_mut(island.start as usize..island.end as usize).unwrap_or_default().fill(0);
        let mut last = self.search(island, island.start, 1);
        for search in 2..=SEARCHES {
            let furthest = last.furthest.map(|place| self.in_place(place));
            let from = furthest.map(|slot| (degree(self.list_end, slot), slot)).min();
            let next = self.search(island, from.map_or(island.start, |(_, slot)| slot), search);
            if next.depth == last.depth {
                break;
            }
            last = next;
        }
    }

    /// Sorts the lists of an island by degree. The places of its order lie in them or before, so that this comes first.
    fn sort(&mut self, island: &Range<u32>) {
        for slot in island.clone() {
            let list = items_of(self.list_end, slot);
            let list = self.incidences.get_mut(list.start as usize..list.end as usize).unwrap_or_default();
            if cfg!(feature = "compact") {
                let count = list.len() as u32;
                sort(&mut Neighbours { list, list_end: self.list_end }, count);
            } else {
                list.sort_unstable_by_key(|incidence| key(self.list_end, *incidence));
            }
        }
    }

    /// Goes through an island breadth first, and leaves it in its places in that order.
    fn search(&mut self, island: &Range<u32>, from: u32, search: u8) -> Searched {
        let mut end = island.start;
        self.find(from, &mut end, search);
        let (mut depth, mut furthest) = (0, island.start..end);
        loop {
            let before = end;
            for place in furthest.clone() {
                for link in items_of(self.list_end, self.in_place(place)) {
                    let slot = at(self.incidences, link).neighbour;
                    if island.contains(&slot) && at(self.found_by, slot) != search {
                        self.find(slot, &mut end, search);
                    }
                }
            }
            if end == before {
                return Searched { depth, furthest };
            }
            (depth, furthest) = (depth + 1, before..end);
        }
    }

    /// Puts a slot in the next place.
    fn find(&mut self, slot: u32, end: &mut u32, search: u8) {
        put(self.found_by, slot, search);
        let place = Incidence { spring: slot, ..at(self.incidences, *end) };
        put(self.incidences, *end, place);
        *end += 1;
    }
}

/// The list of a slot, in no order yet.
struct Neighbours<'a> {
    list: &'a mut [Incidence],
    list_end: &'a [u32],
}

impl Unsorted for Neighbours<'_> {
    fn precedes(&self, first: u32, second: u32) -> bool {
        key(self.list_end, at(self.list, first)) < key(self.list_end, at(self.list, second))
    }

    fn exchange(&mut self, first: u32, second: u32) {
        exchange(self.list, first, second);
    }
}

/// What neighbours are ordered by.
fn key(list_end: &[u32], Incidence { neighbour, .. }: Incidence) -> (u32, u32) {
    (degree(list_end, neighbour), neighbour)
}

fn degree(list_end: &[u32], slot: u32) -> u32 {
    let list = items_of(list_end, slot);
    list.end - list.start
}
