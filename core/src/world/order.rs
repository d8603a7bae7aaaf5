//! The order in which the forces of springs are added: what makes a sum the same whatever adds it.
//!
//! A spring's force is subtracted at its upper end and added at its lower one. Every particle takes first what comes
//! from below, then what comes from above, both by descending distance in slots, springs between the same two by
//! number. Going through tiles of ascending slots and, within a tile, through descending offsets, meets every
//! particle's springs in just that order: what lies further below comes in an earlier tile, or earlier in the same. So
//! neither the size of a tile nor which springs share a loop can change a bit.

use super::layout::{Incidence, SpringColumns};
use super::pieces::TILE;
use super::sort::{Unsorted, exchange, sort};
use super::storage::{Column, Storage};
use crate::Real;
use crate::vectors::{at, put};

/// Sorts springs into that order, in place; those between two held particles, which move nothing, after all others, and
/// those of particles that sleep, in the slots from `asleep` on, after these.
pub fn order<R: Real, M: Storage>(springs: &mut SpringColumns<R, M>, inverse_mass: &[R], asleep: u32) {
    let SpringColumns { ends, stiffness, damping, rest_length, number, incidences, .. } = springs;
    let (ends, number) = (ends.items_mut(), number.items_mut());
    for [i, j] in ends.iter_mut() {
        if i > j {
            core::mem::swap(i, j);
        }
    }
    let parameters = [stiffness.items_mut(), damping.items_mut(), rest_length.items_mut()];
    if cfg!(feature = "compact") {
        let count = ends.len() as u32;
        sort(&mut Disordered { ends, number, parameters, inverse_mass, asleep }, count);
        return;
    }
    let key = |ends, number| key(ends, number, inverse_mass, asleep);
    let keys = || ends.iter().zip(number.iter()).map(|(ends, number)| key(*ends, *number));
    if keys().is_sorted() {
        return;
    }
    // The incidences are listed after this: until then they are room to sort in.
    let room = incidences.items_mut();
    for (index, (room, (ends, number))) in (0..).zip(room.iter_mut().zip(ends.iter().zip(number.iter()))) {
        let [i, j] = *ends;
        *room = [Incidence { neighbour: i, spring: j }, Incidence { neighbour: *number, spring: index }];
    }
    room.sort_unstable_by_key(|[ends, spring]| key([ends.neighbour, ends.spring], spring.neighbour));
    follow(room, ends, number, parameters);
}

/// Springs in no order yet.
struct Disordered<'a, R> {
    ends: &'a mut [[u32; 2]],
    number: &'a mut [u32],
    parameters: [&'a mut [R]; 3],
    inverse_mass: &'a [R],
    asleep: u32,
}

impl<R: Real> Disordered<'_, R> {
    fn key(&self, place: u32) -> (u64, u64) {
        key(at(self.ends, place), at(self.number, place), self.inverse_mass, self.asleep)
    }
}

impl<R: Real> Unsorted for Disordered<'_, R> {
    fn precedes(&self, first: u32, second: u32) -> bool {
        self.key(first) < self.key(second)
    }

    fn exchange(&mut self, first: u32, second: u32) {
        exchange(self.ends, first, second);
        exchange(self.number, first, second);
        for column in &mut self.parameters {
            exchange(column, first, second);
        }
    }
}

/// What springs are ordered by. In two numbers, which take less to compare than six words: a tile's leaves eight bits.
#[cfg_attr(feature = "compact", inline(never))]
fn key<R: Real>([i, j]: [u32; 2], number: u32, inverse_mass: &[R], asleep: u32) -> (u64, u64) {
    let last = (u32::from(j >= asleep) << 31) | (u32::from(is_idle([i, j], inverse_mass)) << 30);
    let words = |high: u32, low: u32| (u64::from(high) << 32) | u64::from(low);
    (words(last | (i / TILE), u32::MAX - (j - i)), words(i, number))
}

/// Whether a spring moves nothing, as both its ends are held.
pub fn is_idle<R: Real>([i, j]: [u32; 2], inverse_mass: &[R]) -> bool {
    at(inverse_mass, i) == R::ZERO && at(inverse_mass, j) == R::ZERO
}

/// Puts the spring that each item of `room` names in that item's place, cycle by cycle.
fn follow<R: Real>(room: &mut [[Incidence; 2]], ends: &mut [[u32; 2]], number: &mut [u32], mut columns: [&mut [R]; 3]) {
    for start in 0..room.len() as u32 {
        if at(room, start)[1].spring == start {
            continue;
        }
        let first = (at(ends, start), at(number, start), columns.each_ref().map(|column| at(column, start)));
        let mut place = start;
        loop {
            let mut item = at(room, place);
            let [_, link] = &mut item;
            let from = core::mem::replace(&mut link.spring, place);
            put(room, place, item);
            if from == start {
                break;
            }
            put(ends, place, at(ends, from));
            put(number, place, at(number, from));
            for column in &mut columns {
                put(column, place, at(column, from));
            }
            place = from;
        }
        put(ends, place, first.0);
        put(number, place, first.1);
        for (column, value) in columns.iter_mut().zip(first.2) {
            put(column, place, value);
        }
    }
}
