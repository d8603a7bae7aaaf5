//! Springs that lie on no diagonal, but most of whose ends lie close together: a mesh. For as long as particles are in
//! reach of the tile at hand they are kept vector by vector, so that one load brings all that a spring needs of one,
//! and one addition adds a whole force. What is added to what, and in which order, is as everywhere else.
//!
//! Gathering component by component takes three times as many instructions.

use core::ops::Range;

use super::law::Tension;
use crate::Real;
use crate::carried::Carried;
use crate::lanes::{Rows, Set};
use crate::vectors::{Columns, ColumnsMut, cut, cut_mut, lend, set, triples, triples_mut};
use crate::world::{Law, Springs, TILE};

/// Slots that are kept, a power of two: a mesh of half a million particles, well numbered, reaches that far.
const HELD: u32 = 1024;
/// Springs whose roots and divisions are taken together: enough that what is written has reached the cache by the time
/// that it is read back in other pieces.
const BATCH: usize = 64;
/// Fewer springs off the diagonals than this do not pay for setting up a window.
const LEAST: u32 = 1500;

/// Whether a step over so many springs off the diagonals is worth a window.
pub fn pays(scattered: u32) -> bool {
    // A window takes 48 kB of the stack in `f32`, which is not to be had without an operating system.
    cfg!(feature = "std") && !cfg!(feature = "compact") && scattered >= LEAST
}

/// What is kept, by slot modulo its size. Aligned, so that no vector lies across two lines of the cache.
#[repr(C, align(64))]
pub struct Window<R: Real> {
    /// Position and velocity, each with a place left over.
    states: [[R; 8]; HELD as usize],
    /// Of positions, with a place left over.
    residuals: [[R::Residual; 4]; HELD as usize],
    /// N, from springs to lower slots.
    below: [[R; 4]; HELD as usize],
    /// N, from springs to higher slots, of the tile at hand.
    above: [[R; 4]; TILE as usize],
    batch: Batch<R>,
    slots: Range<u32>,
}

/// What springs are worked out in, aligned likewise.
#[repr(C, align(64))]
struct Batch<R> {
    /// Of position and velocity, each with a place left over.
    differences: [Rows<R>; BATCH / 8],
    /// The same in columns.
    columns: [[R; BATCH]; 6],
    force_densities: [R; BATCH],
}

impl<R: Real> Batch<R> {
    const ZERO: Self = Self {
        differences: [[[R::ZERO; 8]; 8]; BATCH / 8],
        columns: [[R::ZERO; BATCH]; 6],
        force_densities: [R::ZERO; BATCH],
    };
}

impl<R: Real> Window<R> {
    pub const fn new() -> Self {
        Self {
            states: [[R::ZERO; 8]; HELD as usize],
            residuals: [[R::NO_RESIDUAL; 4]; HELD as usize],
            below: [[R::ZERO; 4]; HELD as usize],
            above: [[R::ZERO; 4]; TILE as usize],
            batch: Batch::ZERO,
            slots: 0..0,
        }
    }

    /// Whether all of these slots can be kept at once.
    #[inline(always)]
    pub fn holds(slots: &Range<u32>) -> bool {
        slots.end - slots.start <= HELD
    }

    /// Keeps these slots, from the beginning of a tile on. The forces from below that have been added so far are in
    /// `below`, whose first slot is `first`.
    #[inline(always)]
    pub fn keep(
        &mut self,
        slots: &Range<u32>,
        position: Carried<'_, R>,
        velocity: Columns<'_, R>,
        below: Columns<'_, R>,
        first: u32,
    ) -> Option<()> {
        if self.slots.is_empty() {
            self.slots = slots.start..slots.start;
        }
        while self.slots.end < slots.end {
            let next = self.slots.end..round_end(self.slots.end).min(slots.end);
            let states = triples(cut(position.value, next.clone())?).zip(triples(cut(velocity, next.clone())?));
            for (kept, ([x, y, z], [u, v, w])) in places(&mut self.states, &next)?.iter_mut().zip(states) {
                *kept = [x, y, z, R::ZERO, u, v, w, R::ZERO];
            }
            if R::IS_COMPENSATED {
                let residuals = triples(cut(position.residual, next.clone())?);
                for (kept, [x, y, z]) in places(&mut self.residuals, &next)?.iter_mut().zip(residuals) {
                    *kept = [x, y, z, R::NO_RESIDUAL];
                }
            }
            let sums = triples(cut(below, next.start - first..next.end - first)?);
            for (kept, [x, y, z]) in places(&mut self.below, &next)?.iter_mut().zip(sums) {
                *kept = [x, y, z, R::ZERO];
            }
            self.slots.end = next.end;
        }
        self.above = [[R::ZERO; 4]; TILE as usize];
        Some(())
    }

    /// Adds the forces of these springs, which begin in the tile that the slots begin with. Returns how many of them
    /// have length 0.
    #[inline(always)]
    pub fn add<F: Tension>(&mut self, springs: &Springs<'_, R>, range: Range<u32>, set: impl Set) -> Option<u32> {
        let range = range.start as usize..range.end as usize;
        let ends = springs.ends.get(range.clone())?.chunks(BATCH);
        let stiffness = springs.stiffness.get(range.clone())?.chunks(BATCH);
        let damping = springs.damping.get(range.clone())?.chunks(BATCH);
        let rest_length = springs.rest_length.get(range)?.chunks(BATCH);
        let Batch { differences, columns, force_densities } = &mut self.batch;
        let mut degenerate = 0;
        for (ends, laws) in ends.zip(stiffness.zip(damping).zip(rest_length)) {
            for (d, [i, j]) in differences.as_flattened_mut().iter_mut().zip(ends) {
                let (from, to) = (held(&self.states, *i), held(&self.states, *j));
                for (d, (from, to)) in d.iter_mut().zip(from.into_iter().zip(to)) {
                    *d = to - from;
                }
                let (from, to) = (held(&self.residuals, *i), held(&self.residuals, *j));
                for (d, (from, to)) in d.iter_mut().zip(from.into_iter().zip(to)) {
                    *d = d.corrected(to, from);
                }
            }
            for (eight, rows) in differences.iter().enumerate() {
                for (column, turned) in columns.iter_mut().zip(set.turn(rows)) {
                    if let Some(to) = column.get_mut(8 * eight..8 * eight + 8) {
                        to.copy_from_slice(&turned);
                    }
                }
            }
            let ((stiffness, damping), rest_length) = laws;
            let laws = triples([stiffness, damping, rest_length]);
            let [x, y, z, u, v, w] = columns.each_ref().map(<[R; BATCH]>::as_slice);
            let states = triples([x, y, z]).zip(triples([u, v, w]));
            for ((q, (d, v)), [stiffness, damping, rest_length]) in force_densities.iter_mut().zip(states).zip(laws) {
                let law = Law { stiffness, damping, rest_length };
                let (density, has_direction) = F::force_density(law, d, v);
                *q = density;
                degenerate += u32::from(!has_direction);
            }
            for (([x, y, z, rest, ..], q), [i, j]) in differences.as_flattened().iter().zip(&*force_densities).zip(ends)
            {
                let force = [x, y, z, rest].map(|d| *q * *d);
                for (sum, force) in held_mut(&mut self.above, *i).into_iter().flatten().zip(force) {
                    *sum += force;
                }
                for (sum, force) in held_mut(&mut self.below, *j).into_iter().flatten().zip(force) {
                    *sum -= force;
                }
            }
        }
        Some(degenerate)
    }

    /// Writes what has been added to the particles of a tile from above.
    #[inline(always)]
    pub fn write_above(&self, above: ColumnsMut<'_, R>) {
        write(&self.above, above);
    }

    /// Lets go of the slots up to `end`, and writes the forces on them.
    #[inline(always)]
    pub fn let_go(&mut self, end: u32, mut below: ColumnsMut<'_, R>, first: u32) -> Option<()> {
        let end = end.min(self.slots.end);
        while self.slots.start < end {
            let next = self.slots.start..round_end(self.slots.start).min(end);
            let columns = cut_mut(lend(&mut below), next.start - first..next.end - first)?;
            write(places(&mut self.below, &next)?, columns);
            self.slots.start = next.end;
        }
        Some(())
    }

    /// Lets go of all slots.
    #[inline(always)]
    pub fn let_go_of_all(&mut self, below: ColumnsMut<'_, R>, first: u32) -> Option<()> {
        self.let_go(self.slots.end, below, first)
    }
}

/// Where the place of a slot is the first one again.
#[inline(always)]
fn round_end(slot: u32) -> u32 {
    (slot / HELD + 1) * HELD
}

/// The places of slots that do not go round.
#[inline(always)]
fn places<'a, T, const PLACES: usize>(kept: &'a mut [T; PLACES], slots: &Range<u32>) -> Option<&'a mut [T]> {
    let first = slots.start as usize % PLACES;
    kept.get_mut(first..first + (slots.end - slots.start) as usize)
}

/// That of one slot: a remainder is always among them.
#[inline(always)]
fn held<T: Copy + Default, const PLACES: usize>(kept: &[T; PLACES], slot: u32) -> T {
    kept.get(slot as usize % PLACES).copied().unwrap_or_default()
}

/// That of one slot, to be written.
#[inline(always)]
fn held_mut<T, const PLACES: usize>(kept: &mut [T; PLACES], slot: u32) -> Option<&mut T> {
    kept.get_mut(slot as usize % PLACES)
}

/// Vectors to columns.
#[inline(always)]
fn write<R: Real>(vectors: &[[R; 4]], columns: ColumnsMut<'_, R>) {
    for (to, [x, y, z, _]) in triples_mut(columns).zip(vectors) {
        set(to, [*x, *y, *z]);
    }
}
