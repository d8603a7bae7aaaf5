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
use super::prepare::list_incidences;
use super::rest::Mark;
use super::storage::{Column, Storage};
use crate::Real;
use crate::vectors::{at, put};

/// Where no spring reaches further than so many slots, everything is in the first cache anyway.
pub const NEAR: u32 = 16;
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
        let before = reach(&graph, &island, |slot| slot);
        if before.most > NEAR && !is_diagonal(&graph, &island, &before, seen) {
            graph.order(&island);
            let [former, latter] = [last, graph.in_place(island.start)].map(|slot| at(new_slot, slot));
            for place in island.clone() {
                put(new_slot, graph.in_place(place), last - (place - island.start));
            }
            let after = reach(&graph, &island, |slot| at(new_slot, slot));
            // By a quarter at least; and never a longer longest one, which a step by several threads pays for.
            if after.sum <= before.sum / 4 * 3 && after.most <= before.most {
                for (particle, is_last) in [(former, false), (latter, true)] {
                    put(rest, particle, Mark::from_byte(at(rest, particle)).placed(is_last).to_byte());
                }
                renumbered.particles += island.end - island.start;
                renumbered.reach_before = renumbered.reach_before.max(before.most);
                renumbered.reach = renumbered.reach.max(after.most);
                continue;
            }
        }
        for slot in island {
            put(new_slot, slot, slot);
        }
    }
    incidence_end.items_mut().copy_from_slice(particle_at.items());
    for (particle, slot) in (0..).zip(slot_of.items()) {
        put(particle_at.items_mut(), *slot, particle);
    }
    renumbered
}

/// The springs of an island, by their lower ends.
fn ends<'a>(graph: &'a Graph<'_>, island: &'a Range<u32>) -> impl Iterator<Item = [u32; 2]> + 'a {
    island.clone().flat_map(move |slot| {
        let above = graph.neighbours(slot).filter(move |neighbour| (slot + 1..island.end).contains(neighbour));
        above.map(move |neighbour| [slot, neighbour])
    })
}

/// How far the springs of an island reach with its particles in these slots.
fn reach(graph: &Graph<'_>, island: &Range<u32>, slot_of: impl Fn(u32) -> u32) -> Reach {
    ends(graph, island).fold(Reach::default(), |Reach { springs, sum, most }, ends| {
        let [i, j] = ends.map(&slot_of);
        let distance = i.abs_diff(j);
        Reach { springs: springs + 1, sum: sum + u64::from(distance), most: most.max(distance) }
    })
}

/// Whether at least half of the springs lie on diagonals: another one begins in the slot before, or in the one before
/// that, and reaches as far. `seen` is room for a word a spring: an island has no more distances than springs.
fn is_diagonal(graph: &Graph<'_>, island: &Range<u32>, all: &Reach, seen: &mut [u32]) -> bool {
    let seen = seen.get_mut(..all.most as usize).unwrap_or_default();
    seen.fill(NONE);
    let mut on_diagonals = 0;
    for [i, j] in ends(graph, island) {
        let distance = j - i - 1;
        let before = at(seen, distance);
        on_diagonals += u64::from(before != NONE && (1..=2).contains(&(i - before)));
        put(seen, distance, i);
    }
    2 * on_diagonals >= all.springs
}
