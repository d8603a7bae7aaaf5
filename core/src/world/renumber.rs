//! Whether the particles of an island are better in another order than that of their numbers.
//!
//! Springs that lie on diagonals are the fastest there are, so where most do, nothing changes. Of others, those are the
//! faster that reach the nearer: both ends are in the cache, and threads have little to go through that is not theirs.
//! A mesh whose numbers lead far apart gets an order of its own (`cuthill_mckee.rs`) if springs then are clearly shorter.
//!
//! All that this goes by is the island itself and the order of its numbers, so that it is laid out alike, and adds its
//! forces in the same order, whatever else there is.

use core::ops::Range;

use super::cuthill_mckee::Graph;
use super::layout::{ParticleColumns, SpringColumns};
use super::pieces::LEAST;
use super::prepare::list_incidences;
use super::rest::Mark;
use super::storage::{Column, Storage};
use crate::Real;
use crate::vectors::{at, put};

/// Where no spring reaches further than so many slots, nothing can be gained.
pub const NEAR: u32 = 16;
/// Where none reaches further than so many, both ends are in the first cache anyway: other numbers help only if they put
/// springs on diagonals.
const FAR: u32 = 768;
/// No slot.
const NONE: u32 = u32::MAX;

/// What became of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Renumbered {
    /// Particles of islands that were given another order.
    pub particles: u32,
    /// The furthest that their springs reached, in slots.
    pub reach_before: u32,
    /// The furthest that they reach now.
    pub reach: u32,
}

/// A better order of an island.
struct Better {
    /// The furthest that its springs reached, and reach now.
    reach: [u32; 2],
    /// The number of the particle that comes to be in its last slot.
    last: u32,
}

/// How far the springs of an island reach.
#[derive(Default)]
struct Reach {
    springs: u64,
    /// All together.
    sum: u64,
    most: u32,
}

/// Writes to `incidence_end` the slots that particles are to have. The islands in the slots `awake` are each in slots of
/// their own, in the order of their numbers; what lies elsewhere stays there.
pub fn renumber<R: Real, M: Storage>(
    particles: &mut ParticleColumns<R, M>,
    springs: &mut SpringColumns<R, M>,
    awake: Range<u32>,
) -> Renumbered {
    list_incidences(particles, springs);
    let ParticleColumns { slot_of, particle_at, incidence_end, rest, .. } = particles;
    let (list_end, rest) = (incidence_end.items_mut(), rest.items_mut());
    // Pieces and presences are found after this, and which particle is in which slot is written down anew at the end.
    let (seen, new_slot) = (springs.pieces.items_mut(), particle_at.items_mut());
    let incidences = springs.incidences.items_mut().as_flattened_mut();
    let mut graph = Graph { list_end, incidences, found_by: springs.presences.items_mut().as_flattened_mut() };
    let mut renumbered = Renumbered::default();
    for slot in (0..awake.start).chain(awake.end..new_slot.len() as u32) {
        put(new_slot, slot, slot);
    }
    let mut first = awake.start;
    while first < awake.end {
        let is_last = |slot: &u32| Mark::from_byte(at(rest, at(new_slot, *slot))).is_last();
        let last = (first..awake.end).find(is_last).unwrap_or(awake.end - 1);
        let island = first..last + 1;
        first = island.end;
        let former = at(new_slot, last);
        let Some(better) = renumber_island(&mut graph, &island, new_slot, seen) else {
            for slot in island {
                put(new_slot, slot, slot);
            }
            continue;
        };
        for (particle, is_last) in [(former, false), (better.last, true)] {
            put(rest, particle, Mark::from_byte(at(rest, particle)).placed(is_last).to_byte());
        }
        let [reach_before, reach] = better.reach;
        renumbered = Renumbered {
            particles: renumbered.particles + (last - island.start + 1),
            reach_before: renumbered.reach_before.max(reach_before),
            reach: renumbered.reach.max(reach),
        };
    }
    for (new_slot, found) in incidence_end.items_mut().iter_mut().zip(particle_at.items()) {
        *new_slot = *found;
    }
    for (particle, slot) in (0..).zip(slot_of.items()) {
        put(particle_at.items_mut(), *slot, particle);
    }
    renumbered
}

/// Finds a better order for an island, if there is one. The numbers of its particles make room for their new slots.
fn renumber_island(
    graph: &mut Graph<'_>,
    island: &Range<u32>,
    new_slot: &mut [u32],
    seen: &mut [u32],
) -> Option<Better> {
    let former = IslandSprings { graph, island, new_slot: None };
    let before = former.reach();
    if before.most <= NEAR || former.are_diagonal(&before, seen) {
        return None;
    }
    graph.order(island);
    let last = at(new_slot, graph.in_place(island.start));
    // Turned round.
    for place in island.clone() {
        put(new_slot, graph.in_place(place), turned(island, place));
    }
    let renumbered = IslandSprings { graph, island, new_slot: Some(new_slot) };
    let after = renumbered.reach();
    // By a quarter at least; and never a longer longest one, which a step by several threads pays for.
    let is_shorter = after.sum <= before.sum / 4 * 3 && after.most <= before.most;
    let helps = before.most > FAR || renumbered.are_diagonal(&after, seen);
    (is_shorter && helps).then_some(Better { reach: [before.most, after.most], last })
}

/// The place of a slot of an island, or the slot of a place, if its order is turned round.
fn turned(island: &Range<u32>, index: u32) -> u32 {
    island.end - 1 - (index - island.start)
}

/// The springs of an island.
struct IslandSprings<'a> {
    graph: &'a Graph<'a>,
    island: &'a Range<u32>,
    /// The slots that particles are to have, if they are asked about in the order of the graph turned round.
    new_slot: Option<&'a [u32]>,
}

impl IslandSprings<'_> {
    /// Visits all by their lower ends: the slots of both.
    fn each(&self, mut visit: impl FnMut(u32, u32)) {
        for slot in self.island.clone() {
            let former = self.new_slot.map_or(slot, |_| self.graph.in_place(turned(self.island, slot)));
            for neighbour in self.graph.neighbours(former).filter(|neighbour| self.island.contains(neighbour)) {
                let other = self.new_slot.map_or(neighbour, |new_slot| at(new_slot, neighbour));
                if slot < other {
                    visit(slot, other);
                }
            }
        }
    }

    /// How far they reach.
    fn reach(&self) -> Reach {
        let mut reach = Reach::default();
        self.each(|i, j| {
            reach.springs += 1;
            reach.sum += u64::from(j - i);
            reach.most = reach.most.max(j - i);
        });
        reach
    }

    /// Whether at least half of them lie on diagonals, so many in a row that they are worth a piece: each begins in the
    /// slot after the last one or, as at the end of a row, in the one after that, and reaches as far. `seen` is room for a
    /// word a spring: an island has no more distances than springs.
    fn are_diagonal(&self, all: &Reach, seen: &mut [u32]) -> bool {
        let seen = seen.get_mut(..all.most as usize).unwrap_or_default();
        seen.fill(NONE);
        let mut on_diagonals = 0;
        self.each(|i, j| {
            let distance = j - i - 1;
            // In one word, where the last spring of this reach begins, and how many others there are in its row: what more
            // than a piece needs is not counted.
            let (last, place) = (at(seen, distance), i.wrapping_mul(LEAST));
            let others = last % LEAST;
            let goes_on = last != NONE && [LEAST, 2 * LEAST].contains(&place.wrapping_sub(last - others));
            let row = if goes_on { others + 2 } else { 1 };
            on_diagonals += match row {
                LEAST => u64::from(LEAST),
                _ => u64::from(row > LEAST),
            };
            put(seen, distance, place + (row.min(LEAST) - 1));
        });
        2 * on_diagonals >= all.springs
    }
}
