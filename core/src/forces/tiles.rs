//! Forces tile by tile: what a step does with them, it does while they are in the first cache.

use core::ops::Range;

use super::{diagonal, scattered};
use crate::Real;
use crate::contact::hold_up;
use crate::lanes::Kernel;
use crate::vectors::{Columns, ColumnsMut, at, lend, window, window_mut};
use crate::world::{Coverage, Piece, System, TILE};

/// What becomes of a tile's accelerations once they are known.
pub trait Then<R> {
    /// Of the particles in these slots.
    fn then(&mut self, slots: Range<u32>, accelerations: ColumnsMut<'_, R>);
}

/// Nothing more: they are what was asked for.
pub struct Keep;

impl<R> Then<R> for Keep {
    #[inline(always)]
    fn then(&mut self, _slots: Range<u32>, _accelerations: ColumnsMut<'_, R>) {}
}

/// a(x, v) of every particle, written to `out`, and what follows.
pub struct Accelerations<'a, 'b, R, T> {
    pub system: &'a System<'a, R>,
    pub position: Columns<'a, R>,
    pub velocity: Columns<'a, R>,
    pub out: &'a mut ColumnsMut<'b, R>,
    pub then: &'a mut T,
}

impl<R: Real, T: Then<R>> Kernel for Accelerations<'_, '_, R, T> {
    /// Springs of length 0.
    type Output = u32;

    #[inline(always)]
    fn run(self) -> u32 {
        let Self { system, position, velocity, out, then } = self;
        let (springs, plan) = (&system.springs, system.plan);
        let mut degenerate = 0;
        let mut pieces = springs.pieces.iter().copied().map(Piece::from_words).peekable();
        // The springs before this one have been dealt with, and the particles before that slot been set to 0.
        let (mut spring, mut cleared) = (0, 0);
        let mut from_above = [[R::ZERO; TILE as usize]; 3];
        let mut start = 0;
        while start < plan.attached {
            let end = start.saturating_add(TILE).min(plan.attached);
            // A tile's first spring is its longest, in slots.
            let [i, j] = at(springs.ends, spring);
            let reach = if i < end { end.saturating_add(j - i).min(plan.attached) } else { end };
            if reach > cleared {
                for column in window_mut(lend(out), cleared..reach) {
                    column.fill(R::ZERO);
                }
                cleared = reach;
            }
            for column in &mut from_above {
                column.fill(R::ZERO);
            }
            let [above_x, above_y, above_z] = &mut from_above;
            let mut forces = Forces { position, velocity, start, above: [above_x, above_y, above_z], below: lend(out) };
            loop {
                let piece = pieces.next_if(|piece| piece.first < end);
                let until = piece.map_or_else(|| scattered_end(springs.ends, spring, end), |piece| piece.spring);
                if spring < until {
                    degenerate += if plan.damped == Coverage::None {
                        scattered::add::<R, false>(springs, spring..until, &mut forces)
                    } else {
                        scattered::add::<R, true>(springs, spring..until, &mut forces)
                    };
                    spring = until;
                }
                let Some(piece) = piece else { break };
                degenerate += diagonal::add(springs, &piece, &mut forces);
                spring += piece.springs;
            }
            let slots = start..end;
            let mut tile = window_mut(lend(out), slots.clone());
            divide_by_mass(system, &slots, from_above.each_ref().map(<[R; TILE as usize]>::as_slice), lend(&mut tile));
            if system.support {
                hold_up(system, slots.clone(), position, velocity, lend(&mut tile));
            }
            then.then(slots, tile);
            start = end;
        }
        while start < plan.particles {
            let slots = start..start.saturating_add(TILE).min(plan.particles);
            start = slots.end;
            let mut tile = window_mut(lend(out), slots.clone());
            fall(system, &slots, lend(&mut tile));
            then.then(slots, tile);
        }
        degenerate
    }
}

/// The forces on the particles of a tile as they are being added.
pub struct Forces<'a, R> {
    pub position: Columns<'a, R>,
    pub velocity: Columns<'a, R>,
    /// The tile's first slot.
    pub start: u32,
    /// From springs to higher slots, of the tile's particles.
    pub above: ColumnsMut<'a, R>,
    /// From springs to lower slots, of all particles.
    pub below: ColumnsMut<'a, R>,
}

/// The first spring from this one on that begins at `slot` or past it.
#[inline(always)]
fn scattered_end(ends: &[[u32; 2]], spring: u32, slot: u32) -> u32 {
    let rest = ends.get(spring as usize..).unwrap_or_default();
    if rest.first().is_some_and(|[i, _]| *i < slot) {
        spring + rest.partition_point(|[i, _]| *i < slot) as u32
    } else {
        spring
    }
}

/// a = g + f/m, or 0 where held: what is there is the force from below.
#[inline(always)]
fn divide_by_mass<R: Real>(
    system: &System<'_, R>,
    slots: &Range<u32>,
    above: Columns<'_, R>,
    tile: ColumnsMut<'_, R>,
) {
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
