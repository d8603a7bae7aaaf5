//! Preparation: particles into slots, springs into the lists of their particles.
//!
//! It alone decides the order in which the forces on a particle are added: by slot (`order.rs`), whatever a step is
//! shared among. It runs in place.

use super::dormancy::Dormancy;
use super::islands::arrange;
use super::layout::{Incidence, ParticleColumns, SpringColumns};
use super::renumber::{NEAR, Renumbered, renumber};
use super::storage::{Column, Storage};
use crate::Real;
use crate::vectors::{at, put};

/// How many particles are in which part of the slots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    /// All.
    pub particles: u32,
    /// Those that springs pull at.
    pub attached: u32,
    /// Held particles that no island has to itself: where islands were looked for, they come first.
    pub shared: u32,
    /// Those of islands that sleep: they come last.
    pub asleep: u32,
    /// Islands, if they were looked for.
    pub islands: u32,
    /// Islands that sleep.
    pub islands_asleep: u32,
    /// Particles that are not in the order of their numbers.
    pub renumbered: Renumbered,
}

impl Layout {
    /// The first slot of what sleeps, or past all.
    pub fn first_asleep(&self) -> u32 {
        self.particles - self.asleep
    }
}

/// Moves particles to the slots where they belong, and tells how many there are of which.
pub fn partition<R: Real, M: Storage>(
    particles: &mut ParticleColumns<R, M>,
    springs: &mut SpringColumns<R, M>,
    front: usize,
    dormancy: Option<Dormancy<R, M>>,
) -> Layout {
    let by_number = match dormancy {
        Some(Dormancy { arrange, .. }) => arrange(particles, springs, front, true),
        None => attached_first(particles, springs),
    };
    let mut layout = moved(by_number, particles, springs, front);
    // Where there is no room for as many particles, that is known when a program is compiled.
    if M::MOST_PARTICLES > NEAR as usize + 1 && springs.ends.items().iter().any(|[i, j]| i.abs_diff(*j) > NEAR) {
        layout.renumbered = renumber_islands(particles, springs, front, dormancy.is_some(), &layout);
    }
    if let Some(Dormancy { settle, .. }) = dormancy
        && layout.asleep > 0
    {
        settle(particles, layout.first_asleep(), front);
    }
    layout
}

/// Gives islands an order of their own where that is better than that of their numbers.
fn renumber_islands<R: Real, M: Storage>(
    particles: &mut ParticleColumns<R, M>,
    springs: &mut SpringColumns<R, M>,
    front: usize,
    by_islands: bool,
    layout: &Layout,
) -> Renumbered {
    let mut layout = *layout;
    if !by_islands {
        // What is connected gets slots of its own, for as long as it takes to see whether any of it is renumbered.
        let arranged = arrange(particles, springs, front, false);
        layout = moved(arranged, particles, springs, front);
    }
    let renumbered = renumber(particles, springs, layout.shared..layout.attached - layout.asleep);
    if renumbered.particles > 0 {
        permute(particles, springs, front);
    } else if !by_islands {
        let by_number = attached_first(particles, springs);
        moved(by_number, particles, springs, front);
    }
    renumbered
}

/// Moves particles to the slots that `incidence_end` names if any has to.
fn moved<R: Real, M: Storage>(
    (layout, has_to): (Layout, bool),
    particles: &mut ParticleColumns<R, M>,
    springs: &mut SpringColumns<R, M>,
    front: usize,
) -> Layout {
    if has_to {
        permute(particles, springs, front);
    }
    layout
}

/// Both states hold what sleeps, so that steps that leave it out need not copy it.
pub fn settle<R: Real, M: Storage>(particles: &mut ParticleColumns<R, M>, first_asleep: u32, front: usize) {
    let [a, b] = &mut particles.state;
    let (current, spare) = if front == 0 { (a, b) } else { (b, a) };
    spare.lend().keep(first_asleep, &current.lend());
}

/// Writes the slots to `incidence_end` in which the particles that springs pull at come first.
fn attached_first<R: Real, M: Storage>(
    particles: &mut ParticleColumns<R, M>,
    springs: &SpringColumns<R, M>,
) -> (Layout, bool) {
    let new_slot = particles.incidence_end.items_mut();
    new_slot.fill(0);
    for &[first, second] in springs.ends.items() {
        put(new_slot, first, 1);
        put(new_slot, second, 1);
    }
    let attached = new_slot.iter().sum();
    let mut next_attached = 0;
    let mut next_free = attached;
    let mut moved = false;
    // By number, whatever slots an earlier preparation gave them: the same scene is laid out alike however it was made.
    for slot in particles.slot_of.items() {
        let next = if at(new_slot, *slot) == 1 { &mut next_attached } else { &mut next_free };
        put(new_slot, *slot, *next);
        moved |= *next != *slot;
        *next += 1;
    }
    let particles = particles.count();
    (Layout { particles, attached, ..Layout::default() }, moved)
}

/// Moves every particle to the slot that `incidence_end` names.
fn permute<R: Real, M: Storage>(
    particles: &mut ParticleColumns<R, M>,
    springs: &mut SpringColumns<R, M>,
    front: usize,
) {
    let ParticleColumns { state: [a, b], mass, inverse_mass, slot_of, particle_at, incidence_end, .. } = particles;
    let new_slot = incidence_end.items();
    // The state that a step would write to is free between steps: one of its columns serves as room to move in.
    let (current, spare) = if front == 0 { (a, b) } else { (b, a) };
    let [scratch, _, _] = &mut spare.position;
    let scratch = scratch.items_mut();
    let [x, y, z] = &mut current.position;
    let [u, v, w] = &mut current.velocity;
    for column in [x, y, z, u, v, w, mass, inverse_mass] {
        permute_column(column.items_mut(), new_slot, scratch);
    }
    if R::IS_COMPENSATED {
        let [scratch, _, _] = &mut spare.position_residual;
        let scratch = scratch.items_mut();
        for column in current.position_residual.iter_mut().chain(&mut current.velocity_residual) {
            permute_column(column.items_mut(), new_slot, scratch);
        }
    }
    for slot in slot_of.items_mut() {
        *slot = at(new_slot, *slot);
    }
    for (particle, slot) in (0..).zip(slot_of.items()) {
        put(particle_at.items_mut(), *slot, particle);
    }
    for ends in springs.ends.items_mut() {
        *ends = ends.map(|slot| at(new_slot, slot));
    }
}

fn permute_column<T: Copy>(column: &mut [T], new_slot: &[u32], scratch: &mut [T]) {
    for (value, slot) in column.iter().zip(new_slot) {
        put(scratch, *slot, *value);
    }
    for (value, moved) in column.iter_mut().zip(scratch) {
        core::mem::swap(value, moved);
    }
}

/// Lists the springs of each slot, in the order of their numbers, by counting.
pub fn list_incidences<R: Real, M: Storage>(particles: &mut ParticleColumns<R, M>, springs: &mut SpringColumns<R, M>) {
    let ends = springs.ends.items();
    let cursor = particles.incidence_end.items_mut();
    cursor.fill(0);
    for slot in ends.as_flattened() {
        put(cursor, *slot, at(cursor, *slot) + 1);
    }
    let mut start = 0;
    for entry in cursor.iter_mut() {
        let degree = *entry;
        *entry = start;
        start += degree;
    }
    // Each cursor now stands where its slot's incidences begin; filling them moves it to where they end.
    let incidences = springs.incidences.items_mut().as_flattened_mut();
    for (spring, &[first, second]) in (0..).zip(ends) {
        for (slot, neighbour) in [(first, second), (second, first)] {
            let place = at(cursor, slot);
            put(incidences, place, Incidence { neighbour, spring });
            put(cursor, slot, place + 1);
        }
    }
}
