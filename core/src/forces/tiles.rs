//! Forces tile by tile: what a step does with them, it does while they are in the first cache.

use core::ops::Range;

use super::sweep::Sweep;
use super::{diagonal, scattered};
use crate::Real;
use crate::contact::hold_up;
use crate::lanes::Kernel;
use crate::vectors::{Columns, ColumnsMut, lend, window, window_mut};
use crate::world::{Coverage, System, TILE, tiles};

/// What becomes of a tile's accelerations once they are known.
pub trait Then<R>: Sized + Send {
    /// Of the particles in these slots. Returns whether everything made of them is finite.
    fn then(&mut self, slots: Range<u32>, accelerations: ColumnsMut<'_, R>) -> bool;

    /// For the slots before this one, and for those from it on.
    fn split(self, slot: u32) -> (Self, Self);
}

/// Nothing more: they are what was asked for.
pub struct Keep;

impl<R> Then<R> for Keep {
    #[inline(always)]
    fn then(&mut self, _slots: Range<u32>, _accelerations: ColumnsMut<'_, R>) -> bool {
        true
    }

    fn split(self, _slot: u32) -> (Self, Self) {
        (Self, Self)
    }
}

/// a(x, v) of the particles in `slots`, written to `out`, and what follows.
pub struct Accelerations<'a, R, T> {
    pub system: &'a System<'a, R>,
    pub position: Columns<'a, R>,
    pub velocity: Columns<'a, R>,
    /// Begins and ends with a tile, or with the particles.
    pub slots: Range<u32>,
    /// Of these slots.
    pub out: ColumnsMut<'a, R>,
    pub then: T,
}

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Outcome {
    /// Springs of length 0.
    pub degenerate: u32,
    /// Whether all that followed is finite.
    pub finite: bool,
}

impl<R: Real, T: Then<R>> Kernel for Accelerations<'_, R, T> {
    type Output = Outcome;

    #[inline(always)]
    fn run(self) -> Outcome {
        let Self { system, position, velocity, slots, mut out, mut then } = self;
        let attached = system.plan.attached;
        let pulled = slots.start.min(attached)..slots.end.min(attached);
        let mut outcome = Outcome { degenerate: 0, finite: true };
        let mut room = [const { [[R::ZERO; TILE as usize]; 3] }; 2];
        let [from_above, nowhere] = &mut room;
        let mut sweep = Sweep::reaching(&system.springs, system.plan.span, pulled.start);
        while sweep.slot < pulled.end {
            let tile = sweep.slot..sweep.slot.saturating_add(TILE).min(pulled.end);
            let is_ours = tile.start >= pulled.start;
            for column in window_mut(lend(&mut out), within(&pulled, &sweep.clearing(&tile, &pulled))) {
                column.fill(R::ZERO);
            }
            for column in from_above.iter_mut() {
                column.fill(R::ZERO);
            }
            let mut forces = Forces {
                position,
                velocity,
                start: tile.start,
                above: from_above.each_mut().map(<[R; TILE as usize]>::as_mut_slice),
                slots: pulled.clone(),
                below: lend(&mut out),
                nowhere: nowhere.each_mut().map(<[R; TILE as usize]>::as_mut_slice),
            };
            let degenerate = add_tile(system, &mut sweep, tile.end, &mut forces);
            if !is_ours {
                // It lies before these slots: its springs were gone through for what they pull at in them.
                continue;
            }
            outcome.degenerate += degenerate;
            let mut a = window_mut(lend(&mut out), within(&pulled, &tile));
            let above = from_above.each_ref().map(<[R; TILE as usize]>::as_slice);
            divide_by_mass(system, &tile, above, lend(&mut a));
            if system.support {
                hold_up(system, tile.clone(), position, velocity, lend(&mut a));
            }
            outcome.finite &= then.then(tile, a);
        }
        for tile in tiles(slots.start.max(attached)..slots.end) {
            let mut a = window_mut(lend(&mut out), within(&slots, &tile));
            fall(system, &tile, lend(&mut a));
            outcome.finite &= then.then(tile, a);
        }
        outcome
    }
}

/// Where some slots are among others.
#[inline(always)]
fn within(slots: &Range<u32>, part: &Range<u32>) -> Range<u32> {
    part.start - slots.start..part.end - slots.start
}

/// Adds the forces of the springs that begin in the tile up to `end`. Returns how many of them have length 0.
#[inline(always)]
fn add_tile<R: Real>(system: &System<'_, R>, sweep: &mut Sweep<'_>, end: u32, forces: &mut Forces<'_, R>) -> u32 {
    let springs = &system.springs;
    let mut degenerate = 0;
    loop {
        let (scattered, piece) = sweep.next(end);
        if !scattered.is_empty() {
            degenerate += if system.plan.damped == Coverage::None {
                scattered::add::<R, false>(springs, scattered, forces)
            } else {
                scattered::add::<R, true>(springs, scattered, forces)
            };
        }
        let Some(piece) = piece else { break };
        degenerate += diagonal::add(springs, &piece, forces);
    }
    sweep.slot = end;
    degenerate
}

/// The forces on the particles of a tile as they are being added.
pub struct Forces<'a, R> {
    pub position: Columns<'a, R>,
    pub velocity: Columns<'a, R>,
    /// The tile's first slot.
    pub start: u32,
    /// From springs to higher slots, of the tile's particles.
    pub above: ColumnsMut<'a, R>,
    /// The slots that are asked for.
    pub slots: Range<u32>,
    /// From springs to lower slots, of those.
    pub below: ColumnsMut<'a, R>,
    /// For what springs to lower slots do to others: as long as a tile.
    pub nowhere: ColumnsMut<'a, R>,
}

/// a = g + f/m, or 0 where held: what is there is the force from below.
#[inline(always)]
fn divide_by_mass<R: Real>(system: &System<'_, R>, slots: &Range<u32>, above: Columns<'_, R>, tile: ColumnsMut<'_, R>) {
    let [inverse_mass] = window([system.inverse_mass], slots.clone());
    for ((column, above), g) in tile.into_iter().zip(above).zip(system.gravity) {
        for ((a, above), w) in column.iter_mut().zip(above).zip(inverse_mass) {
            let acceleration = g + *w * (*a + *above);
            // Held, whatever pulls: 0 times an infinite force would not be 0.
            *a = if *w == R::ZERO { R::ZERO } else { acceleration };
        }
    }
}

/// a = g, or 0 where held.
#[inline(always)]
fn fall<R: Real>(system: &System<'_, R>, slots: &Range<u32>, tile: ColumnsMut<'_, R>) {
    let [inverse_mass] = window([system.inverse_mass], slots.clone());
    for (column, g) in tile.into_iter().zip(system.gravity) {
        for (a, w) in column.iter_mut().zip(inverse_mass) {
            *a = if *w == R::ZERO { R::ZERO } else { g };
        }
    }
}
