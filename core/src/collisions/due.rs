//! Which particles in free flight have something due, listed so that many can be dealt with together.

use super::bounce::Bounces;
use super::events::Events;
use crate::Real;
use crate::vectors::{at, put};

/// Particles of which the earliest due time is kept: few enough that most blocks have nothing due in a frame.
pub const BLOCK: usize = 16;

/// Blocks that are looked at together for whether they have something due.
const AHEAD: usize = 8;

/// Particles that are listed at once: enough that lanes find another one when theirs is done, few enough for the stack of
/// a microcontroller.
const ROOM: usize = 384;

/// Particles that have something due, and what has happened to each.
pub struct Due {
    indices: [u32; ROOM],
    bounces: [Bounces; ROOM],
    listed: u32,
}

impl Due {
    pub const NOTHING: Self = Self { indices: [0; ROOM], bounces: [Bounces::NONE; ROOM], listed: 0 };

    pub fn listed(&self) -> u32 {
        self.listed
    }

    #[inline(always)]
    pub fn index(&self, place: u32) -> u32 {
        at(&self.indices, place)
    }

    /// All that are listed.
    #[inline(always)]
    pub fn each(&mut self) -> impl Iterator<Item = (u32, &mut Bounces)> {
        self.indices.iter().copied().zip(&mut self.bounces).take(self.listed as usize)
    }

    #[inline(always)]
    pub fn bounces_mut(&mut self, place: u32) -> Option<&mut Bounces> {
        self.bounces.get_mut(place as usize)
    }

    /// Lists what has something due by a time, block by block from `first` on, while there is room. Returns the first
    /// block that has not been looked at. Those that are listed do not count as their block's earliest any more.
    #[inline(always)]
    pub fn list<R: Real>(&mut self, events: &mut Events<'_, R>, first: u32, time: f64) -> u32 {
        self.listed = 0;
        let mut next = first;
        while (next as usize) < events.earliest.len() && self.listed as usize + BLOCK * AHEAD <= ROOM {
            let mut room = [0; AHEAD];
            for block in blocks_due(events.earliest, next, time, &mut room) {
                self.list_block(events, *block, time);
            }
            next += AHEAD as u32;
        }
        next
    }

    #[inline(always)]
    fn list_block<R: Real>(&mut self, events: &mut Events<'_, R>, block: u32, time: f64) {
        let start = block as usize * BLOCK;
        let since = events.since.get(start..).unwrap_or_default();
        let tau = events.tau.get(start..).unwrap_or_default();
        let (due, earliest) = match (since.first_chunk(), tau.first_chunk()) {
            (Some(since), Some(tau)) => due_of(since, tau, time),
            _ => due_of_part(since, tau, time),
        };
        put(events.earliest, block, earliest);
        self.push(start as u32, due);
    }

    /// Lists the particles from `start` on whose bits are set.
    #[inline(always)]
    fn push(&mut self, start: u32, mut due: u32) {
        while due != 0 {
            let place = self.listed as usize;
            if let (Some(index), Some(bounces)) = (self.indices.get_mut(place), self.bounces.get_mut(place)) {
                *index = start + due.trailing_zeros();
                *bounces = Bounces::NONE;
            }
            self.listed += 1;
            due &= due - 1;
        }
    }
}

/// Of the next few blocks from `first` on those that have something due.
#[inline(always)]
fn blocks_due<'a>(earliest: &[f64], first: u32, time: f64, room: &'a mut [u32; AHEAD]) -> &'a [u32] {
    let mut found = 0;
    for (earliest, block) in earliest.iter().skip(first as usize).zip(first..).take(AHEAD) {
        // Without a branch that nothing foretells.
        put(room, found, block);
        found += u32::from(*earliest <= time);
    }
    room.get(..found as usize).unwrap_or_default()
}

/// Which of a block have something due, a bit each, and when the first of the others has.
#[inline(always)]
fn due_of<R: Real>(since: &[f64; BLOCK], tau: &[R; BLOCK], time: f64) -> (u32, f64) {
    let mut times = [0.0; BLOCK];
    let mut bits = [0; BLOCK];
    for ((next, bit), (number, (since, tau))) in times.iter_mut().zip(&mut bits).zip((0..).zip(since.iter().zip(tau))) {
        let due = *since + tau.to_f64();
        // What is left until then, negative or not: its sign can be taken in whole vectors, a comparison cannot. It is 0
        // only if both are the same.
        *bit = (!(time - due).to_bits() >> 63) << number;
        *next = if due <= time { f64::INFINITY } else { due };
    }
    // In halves, as whole vectors are compared.
    let mut width = BLOCK / 2;
    while width > 0 {
        let (low, high) = times.split_at_mut_checked(width).unwrap_or_default();
        for (low, high) in low.iter_mut().zip(high) {
            *low = low.at_most(*high);
        }
        width /= 2;
    }
    (bits.iter().fold(0, |due, bit| due | bit) as u32, at(&times, 0))
}

/// The same of the last block, which is a part of one.
#[inline(never)]
fn due_of_part<R: Real>(since: &[f64], tau: &[R], time: f64) -> (u32, f64) {
    let (mut padded, mut none) = ([f64::INFINITY; BLOCK], [R::ZERO; BLOCK]);
    padded.iter_mut().zip(since).for_each(|(place, since)| *place = *since);
    none.iter_mut().zip(tau).for_each(|(place, tau)| *place = *tau);
    due_of(&padded, &none, time)
}
