//! Islands: the connected parts of the spring graph, each in slots of its own, so that a step can leave out those that
//! sleep: held particles that belong to several islands or to none, islands that are awake, particles in free flight,
//! islands that sleep.
//!
//! Within an island particles are in the order of their numbers, or in one that nothing but the island decides
//! (`renumber.rs`), wherever the island is. A particle's sum goes through its neighbours by slot, so it does not change
//! when other islands fall asleep or are not there at all.

use super::layout::{Incidence, ParticleColumns, SpringColumns};
use super::prepare::Layout;
use super::rest::Mark;
use super::storage::{Column, Storage};
use crate::Real;
use crate::vectors::{at, fetch, is_zero, put};

/// In place of the rank of a particle that no spring pulls at.
const FREE: u32 = u32::MAX;
/// In place of the root of a held particle that no island has claimed, or that several have.
const UNCLAIMED: u32 = u32::MAX;
const SHARED: u32 = u32::MAX - 1;
/// With the size of an island that is awake.
const AWAKE: u32 = 1 << 31;

/// Trees whose roots are the lowest of their islands. Nodes are particles that springs pull at, by *rank*: in the order
/// of their numbers. An incidence is room for two words, and there are at least as many of them as ranks: they are
/// listed only after this.
struct Forest<'a>(&'a mut [Incidence]);

impl Forest<'_> {
    fn parent(&self, rank: u32) -> u32 {
        at(self.0, rank).neighbour
    }

    fn set_parent(&mut self, rank: u32, parent: u32) {
        let node = Incidence { neighbour: parent, ..at(self.0, rank) };
        put(self.0, rank, node);
    }

    /// At a root: the size of its island; later, its next slot.
    fn tally(&self, root: u32) -> u32 {
        at(self.0, root).spring
    }

    fn set_tally(&mut self, root: u32, tally: u32) {
        let node = Incidence { spring: tally, ..at(self.0, root) };
        put(self.0, root, node);
    }

    fn root(&mut self, mut rank: u32) -> u32 {
        loop {
            let parent = self.parent(rank);
            if parent == rank {
                return rank;
            }
            // Halves the path on the way.
            let next = self.parent(parent);
            self.set_parent(rank, next);
            rank = next;
        }
    }

    fn join(&mut self, first: u32, second: u32) {
        let (first, second) = (self.root(first), self.root(second));
        self.set_parent(first.max(second), first.min(second));
    }

    /// Adds a held particle to the island of this root, unless another one has claimed it.
    fn claim(&mut self, held: u32, root: u32) {
        let claimed_by = self.parent(held);
        if claimed_by == UNCLAIMED {
            self.set_parent(held, root);
        } else if claimed_by != root {
            self.set_parent(held, SHARED);
        }
    }
}

/// Finds the islands, and writes the slot that each particle is to have to `incidence_end`. Where none may sleep, what
/// hangs on the same held particles is one island. Returns how many of what there are, and whether any particle has to
/// move.
pub fn arrange<R: Real, M: Storage>(
    particles: &mut ParticleColumns<R, M>,
    springs: &mut SpringColumns<R, M>,
    front: usize,
    may_sleep: bool,
) -> (Layout, bool) {
    let ParticleColumns { state: [a, b], inverse_mass, slot_of, incidence_end, rest, .. } = particles;
    let velocity = if front == 0 { a.velocity() } else { b.velocity() }.value;
    let (inverse_mass, slot_of, rest) = (inverse_mass.items(), slot_of.items(), rest.items_mut());
    let ends = springs.ends.items();
    let mut forest = Forest(springs.incidences.items_mut().as_flattened_mut());
    let connects = |slot: u32| !may_sleep || at(inverse_mass, slot) != R::ZERO;

    let rank_of = incidence_end.items_mut();
    rank_of.fill(FREE);
    for slot in ends.as_flattened() {
        put(rank_of, *slot, 0);
    }
    let mut attached = 0;
    for slot in slot_of {
        if at(rank_of, *slot) != FREE {
            put(rank_of, *slot, attached);
            forest.set_parent(attached, if connects(*slot) { attached } else { UNCLAIMED });
            forest.set_tally(attached, 0);
            attached += 1;
        }
    }
    for [i, j] in ends {
        if connects(*i) && connects(*j) {
            forest.join(at(rank_of, *i), at(rank_of, *j));
        }
    }
    for [i, j] in ends {
        let (held, dynamic) = if connects(*i) { (*j, *i) } else { (*i, *j) };
        if connects(dynamic) && !connects(held) {
            let root = forest.root(at(rank_of, dynamic));
            forest.claim(at(rank_of, held), root);
        }
    }

    let mut shared = 0;
    for (mark, slot) in rest.iter().zip(slot_of) {
        let rank = at(rank_of, *slot);
        if rank == FREE {
            continue;
        }
        let parent = forest.parent(rank);
        if may_sleep && parent >= SHARED {
            shared += 1;
            continue;
        }
        let root = forest.root(rank);
        // Who remembers the root finds it at once from now on.
        forest.set_parent(rank, root);
        // What has been moved since it fell asleep does not sleep.
        let sleeps = may_sleep && Mark::from_byte(*mark).is_asleep() && is_zero(fetch(velocity, *slot));
        let tally = forest.tally(root) + 1;
        forest.set_tally(root, if sleeps { tally } else { tally | AWAKE });
    }
    let layout = allot(&mut forest, attached, shared, slot_of.len() as u32, may_sleep);

    let moved = assign(&mut forest, &layout, slot_of, rank_of);
    mark(&mut forest, &layout, slot_of, rank_of, rest);
    (layout, moved)
}

/// Leaves the first slot of each island at its root.
fn allot(forest: &mut Forest<'_>, attached: u32, shared: u32, particles: u32, may_sleep: bool) -> Layout {
    let mut layout = Layout { particles, attached, shared, ..Layout::default() };
    for rank in 0..attached {
        if forest.parent(rank) != rank {
            continue;
        }
        layout.islands += 1;
        let tally = forest.tally(rank);
        if may_sleep && tally & AWAKE == 0 {
            layout.islands_asleep += 1;
            layout.asleep += tally;
        }
    }
    let (mut next_awake, mut next_asleep) = (shared, layout.first_asleep());
    for rank in 0..attached {
        if forest.parent(rank) != rank {
            continue;
        }
        let tally = forest.tally(rank);
        let next = if may_sleep && tally & AWAKE == 0 { &mut next_asleep } else { &mut next_awake };
        forest.set_tally(rank, *next);
        *next += tally & !AWAKE;
    }
    layout
}

/// Gives every particle its slot, in place of its rank, and leaves the slot after each island's last at its root.
/// Returns whether any has to move.
fn assign(forest: &mut Forest<'_>, layout: &Layout, slot_of: &[u32], new_slot: &mut [u32]) -> bool {
    let (mut next_shared, mut next_free) = (0..layout.shared, layout.attached - layout.asleep..layout.first_asleep());
    let mut moved = false;
    for slot in slot_of {
        let rank = at(new_slot, *slot);
        let root = forest.parent(rank);
        let next = if rank == FREE {
            next_free.next()
        } else if root >= SHARED {
            next_shared.next()
        } else {
            let next = forest.tally(root);
            forest.set_tally(root, next + 1);
            Some(next)
        };
        let next = next.unwrap_or_default();
        put(new_slot, *slot, next);
        moved |= next != *slot;
    }
    moved
}

/// Marks the last of each island, and what does not sleep as awake.
fn mark(forest: &mut Forest<'_>, layout: &Layout, slot_of: &[u32], new_slot: &[u32], rest: &mut [u8]) {
    let free = layout.attached - layout.asleep..layout.first_asleep();
    let mut ranks = 0..layout.attached;
    for (byte, slot) in rest.iter_mut().zip(slot_of) {
        let slot = at(new_slot, *slot);
        let mut last = false;
        if !free.contains(&slot) {
            let root = forest.parent(ranks.next().unwrap_or_default());
            let end = if root >= SHARED { layout.shared } else { forest.tally(root) };
            last = slot + 1 == end;
        }
        let mark = Mark::from_byte(*byte).placed(last);
        *byte = if mark.is_asleep() && slot < layout.first_asleep() { mark.awake() } else { mark }.to_byte();
    }
}
