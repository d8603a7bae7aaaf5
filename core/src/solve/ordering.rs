//! The order in which particles are eliminated, and where that leaves entries in the factor.
//!
//! Minimum degree on a quotient graph (George and Liu, *The evolution of the minimum degree ordering algorithm*, 1989),
//! with the bound on the degrees of Amestoy, Davis and Duff (*An approximate minimum degree ordering algorithm*, 1996).
//! Trees, ropes and chains get an order without any fill.

use crate::Real;
use crate::vectors::{at, items_of, put};
use crate::world::System;

/// No slot, no particle.
pub const NONE: u32 = u32::MAX;

/// What is known of a slot while an order is sought. Of one that has been eliminated it is its *element*: the particles
/// that it has left joined to each other, a column of the factor.
#[derive(Clone, Copy, Default)]
pub struct Node {
    /// The slots before and after it that have the same degree. Of an element: the last round that has counted it, and
    /// how many of its particles that round leaves over.
    previous: u32,
    next: u32,
    /// A bound on its neighbours. Of an element: how many particles it joins.
    degree: u32,
    /// The first slot of the degree that is this node's index.
    first: u32,
    /// The last round that has met it.
    met: u32,
    /// In its part of the links: slots that it is still joined to by springs alone, and then elements that it is part of.
    slots: u32,
    elements: u32,
}

impl Node {
    /// Of no slot.
    pub const NOWHERE: Self = Self { previous: 0, next: 0, degree: 0, first: NONE, met: NONE, slots: 0, elements: 0 };
}

/// What an ordering works on and what it comes to.
pub struct Ordering<'a> {
    /// By slot.
    pub nodes: &'a mut [Node],
    /// Takes what is written past them.
    pub nowhere: Node,
    /// Two a spring, laid out as the incidences are.
    pub links: &'a mut [u32],
    /// When each slot is eliminated; [`NONE`] where held.
    pub turn_of: &'a mut [u32],
    /// The slot that each turn eliminates.
    pub slot_at: &'a mut [u32],
    /// Where the entries of each turn's column end.
    pub column_end: &'a mut [u32],
    /// The slots of those entries, column by column.
    pub rows: &'a mut [u32],
}

impl Ordering<'_> {
    /// Finds an order, and the structure that the factor has in it; how many particles it eliminates. Nothing if the
    /// entries are more than there is room for.
    pub fn find<R: Real>(&mut self, system: &System<'_, R>) -> Option<u32> {
        let all = system.plan.attached;
        self.link(system);
        let mut free = 0;
        for slot in (0..all).rev() {
            put(self.turn_of, slot, NONE);
            if system.is_dynamic(slot) {
                self.list(slot, self.node(slot).degree);
                free += 1;
            }
        }
        let (mut turn, mut filled, mut degree) = (0, 0, 0);
        while turn < free && degree < all {
            let slot = self.node(degree).first;
            if slot == NONE {
                degree += 1;
                continue;
            }
            self.unlist(slot);
            put(self.turn_of, slot, turn);
            put(self.slot_at, turn, slot);
            let end = self.join(system, slot, turn + 1, filled)?;
            put(self.column_end, turn, end);
            let most = free.saturating_sub(turn + 2);
            degree = degree.min(self.regard(system, slot, turn + 1, [filled, end], most));
            (turn, filled) = (turn + 1, end);
        }
        Some(free)
    }

    #[cfg_attr(feature = "compact", inline(never))]
    fn node(&self, slot: u32) -> &Node {
        self.nodes.get(slot as usize).unwrap_or(&Node::NOWHERE)
    }

    #[cfg_attr(feature = "compact", inline(never))]
    fn node_mut(&mut self, slot: u32) -> &mut Node {
        self.nodes.get_mut(slot as usize).unwrap_or(&mut self.nowhere)
    }

    #[cfg_attr(feature = "compact", inline(never))]
    fn link_at(&self, link: u32) -> u32 {
        at(self.links, link)
    }

    /// Links each free slot to its free neighbours, once to each.
    fn link<R: Real>(&mut self, system: &System<'_, R>) {
        self.nodes.fill(Node::NOWHERE);
        let mut start = 0;
        for (slot, incidences) in system.springs.by_slot(system.plan.attached) {
            let mut slots = 0;
            for incidence in incidences.iter().filter(|_| system.is_dynamic(slot)) {
                let neighbour = incidence.neighbour;
                if system.is_dynamic(neighbour) && self.node(neighbour).met != slot {
                    self.node_mut(neighbour).met = slot;
                    put(self.links, start + slots, neighbour);
                    slots += 1;
                }
            }
            let node = self.node_mut(slot);
            (node.slots, node.degree) = (slots, slots);
            start += incidences.len() as u32;
        }
        // Rounds are counted from 1.
        self.nodes.iter_mut().for_each(|node| node.met = 0);
    }

    /// Puts a slot first among those of a degree.
    fn list(&mut self, slot: u32, degree: u32) {
        let next = core::mem::replace(&mut self.node_mut(degree).first, slot);
        let node = self.node_mut(slot);
        (node.previous, node.next, node.degree) = (NONE, next, degree);
        self.node_mut(next).previous = slot;
    }

    fn unlist(&mut self, slot: u32) {
        let Node { previous, next, degree, .. } = *self.node(slot);
        self.node_mut(next).previous = previous;
        if previous == NONE {
            self.node_mut(degree).first = next;
        } else {
            self.node_mut(previous).next = next;
        }
    }

    fn links_of<R: Real>(system: &System<'_, R>, slot: u32) -> u32 {
        items_of(system.springs.incidence_end, slot).start
    }

    /// Writes the slots that eliminating one joins to each other from `filled` on, and where they end. The elements that
    /// it was part of are part of its own from now on.
    fn join<R: Real>(&mut self, system: &System<'_, R>, slot: u32, round: u32, filled: u32) -> Option<u32> {
        let Node { slots, elements, .. } = *self.node(slot);
        let start = Self::links_of(system, slot);
        let mut end = filled;
        self.node_mut(slot).met = round;
        for link in start..start + slots {
            end = self.meet(self.link_at(link), round, end)?;
        }
        for link in start + slots..start + slots + elements {
            let element = self.link_at(link);
            let column_end = at(self.column_end, at(self.turn_of, element));
            for row in column_end - self.node(element).degree..column_end {
                end = self.meet(at(self.rows, row), round, end)?;
            }
        }
        let node = self.node_mut(slot);
        (node.previous, node.degree) = (0, end - filled);
        Some(end)
    }

    fn meet(&mut self, slot: u32, round: u32, end: u32) -> Option<u32> {
        if core::mem::replace(&mut self.node_mut(slot).met, round) == round {
            return Some(end);
        }
        *self.rows.get_mut(end as usize)? = slot;
        Some(end + 1)
    }

    /// Gives each slot of a new element its degree anew, and returns the least.
    fn regard<R: Real>(
        &mut self,
        system: &System<'_, R>,
        element: u32,
        round: u32,
        [filled, end]: [u32; 2],
        most: u32,
    ) -> u32 {
        self.count_left_over(system, element, round, [filled, end]);
        let mut least = NONE;
        for row in filled..end {
            let slot = at(self.rows, row);
            self.unlist(slot);
            let former = *self.node(slot);
            let start = Self::links_of(system, slot);
            let (mut kept, mut left_over) = (start, 0);
            for link in start..start + former.slots {
                let neighbour = self.link_at(link);
                // Whom the element joins needs no other link.
                if self.node(neighbour).met != round {
                    put(self.links, kept, neighbour);
                    kept += 1;
                }
            }
            let slots = kept - start;
            for link in start + former.slots..start + former.slots + former.elements {
                let other = self.link_at(link);
                let Node { previous: counted, next: over, .. } = *self.node(other);
                // An element within the new one tells nothing more; neither do those that have become part of it.
                if counted == round && over > 0 {
                    put(self.links, kept, other);
                    kept += 1;
                    left_over += over;
                }
            }
            put(self.links, kept, element);
            let node = self.node_mut(slot);
            (node.slots, node.elements) = (slots, kept + 1 - start - slots);
            let joined = end - filled - 1;
            let degree = (former.degree + joined).min(slots + joined + left_over).min(most);
            self.list(slot, degree);
            least = least.min(degree);
        }
        least
    }

    /// Counts how many particles of each element that meets the new one are not part of that.
    fn count_left_over<R: Real>(&mut self, system: &System<'_, R>, element: u32, round: u32, [filled, end]: [u32; 2]) {
        // What the eliminated one was part of is no element any more.
        let Node { slots, elements, .. } = *self.node(element);
        let start = Self::links_of(system, element) + slots;
        for link in start..start + elements {
            let absorbed = self.node_mut(self.link_at(link));
            (absorbed.previous, absorbed.next) = (NONE, 0);
        }
        for row in filled..end {
            let slot = at(self.rows, row);
            let Node { slots, elements, .. } = *self.node(slot);
            let start = Self::links_of(system, slot) + slots;
            for link in start..start + elements {
                let Some(node) = self.nodes.get_mut(at(self.links, link) as usize) else { continue };
                if node.previous == NONE {
                    continue;
                }
                if node.previous != round {
                    (node.previous, node.next) = (round, node.degree);
                }
                node.next -= 1;
            }
        }
    }
}
