//! The springs that lie on no diagonal: what they need is gathered for a few of them at once, and their forces are
//! added one by one.

use core::ops::Range;

use super::law::Tension;
use super::tiles::Forces;
use crate::Real;
use crate::vectors::{along, difference, fetch_inlined, read, set, store_inlined, triples, triples_mut, window};
use crate::world::{Law, Springs, stretches};

/// Springs whose roots and divisions are taken together: what the widest lanes hold, or the narrowest.
const BATCH: usize = if cfg!(feature = "compact") { 4 } else { 16 };

/// Adds the forces of these springs. Returns how many of them have length 0.
#[inline(always)]
pub fn add<R: Real, F: Tension>(springs: &Springs<'_, R>, range: Range<u32>, forces: &mut Forces<'_, R>) -> u32 {
    let batches = stretches(range, BATCH as u32);
    batches.fold(0, |degenerate, batch| degenerate + add_batch::<R, F>(springs, batch, forces))
}

#[inline(always)]
fn add_batch<R: Real, F: Tension>(springs: &Springs<'_, R>, batch: Range<u32>, forces: &mut Forces<'_, R>) -> u32 {
    let [ends] = window([springs.ends], batch.clone());
    let mut d = [[R::ZERO; BATCH]; 3];
    let mut v = [[R::ZERO; BATCH]; 3];
    let vectors = triples_mut(d.each_mut().map(<[R; BATCH]>::as_mut_slice))
        .zip(triples_mut(v.each_mut().map(<[R; BATCH]>::as_mut_slice)));
    for ((d, v), &[i, j]) in vectors.zip(ends) {
        set(d, forces.states.position.difference(j, i));
        if F::READS_VELOCITY {
            set(v, difference(fetch_inlined(forces.states.velocity, j), fetch_inlined(forces.states.velocity, i)));
        }
    }
    let laws = window([springs.stiffness, springs.damping, springs.rest_length], batch).map(batched);
    let mut q = [R::ZERO; BATCH];
    let mut directed = [true; BATCH];
    let states =
        triples(d.each_ref().map(<[R; BATCH]>::as_slice)).zip(triples(v.each_ref().map(<[R; BATCH]>::as_slice)));
    let laws = triples(laws.each_ref().map(<[R; BATCH]>::as_slice));
    let found = q.iter_mut().zip(&mut directed);
    for (((q, directed), (d, v)), [stiffness, damping, rest_length]) in found.zip(states).zip(laws) {
        (*q, *directed) = F::force_density(Law { stiffness, damping, rest_length }, d, v);
    }
    let mut degenerate = 0;
    let vectors = triples(d.each_ref().map(<[R; BATCH]>::as_slice));
    for ((&[i, j], (q, directed)), d) in ends.iter().zip(q.iter().zip(&directed)).zip(vectors) {
        let above = i - forces.start;
        let pulled = along(fetch_inlined(read(&forces.above), above), *q, d);
        store_inlined(&mut forces.above, above, pulled);
        // Past the slots that are asked for, nothing is stored.
        let below = j.wrapping_sub(forces.slots.start);
        let pulled = along(fetch_inlined(read(&forces.below), below), -*q, d);
        store_inlined(&mut forces.below, below, pulled);
        degenerate += u32::from(!directed);
    }
    degenerate
}

/// A column's stretch, filled up to a batch.
#[inline(always)]
fn batched<R: Real>(stretch: &[R]) -> [R; BATCH] {
    let mut batch = [R::ZERO; BATCH];
    for (place, value) in batch.iter_mut().zip(stretch) {
        *place = *value;
    }
    batch
}
