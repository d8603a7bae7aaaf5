//! Forces tile by tile: what a step does with them, it does while they are in the first cache.

use core::marker::PhantomData;
use core::ops::Range;

use super::acceleration::{Origin, Tile, inverse_masses};
use super::law::{Pull, Tension};
use super::sweep::Sweep;
use super::window::Window;
use super::{diagonal, plain, scattered};
use crate::Real;
use crate::carried::Carried;
use crate::lanes::{Kernel, Present, Set};
use crate::vectors::{Columns, ColumnsMut, at, cut, cut_mut, lend, read, window_mut};
use crate::world::{Coverage, System, TILE, tiles};

/// What becomes of a tile's accelerations once they are known.
pub trait Then<R>: Send {
    /// Of the particles of a tile. Returns whether everything made of them is finite.
    fn then(&mut self, tile: Tile<'_, R>) -> bool;
}

/// The same of all tiles, which can be parted.
pub trait Follow<R>: Then<R> + Sized {
    /// For the slots before this one, and for those from it on.
    fn split(self, slot: u32) -> (Self, Self);
}

/// Nothing more: they are what was asked for.
pub struct Keep;

impl<R: Real> Then<R> for Keep {
    fn then(&mut self, mut tile: Tile<'_, R>) -> bool {
        tile.fresh();
        true
    }
}

impl<R: Real> Follow<R> for Keep {
    fn split(self, _slot: u32) -> (Self, Self) {
        (Self, Self)
    }
}

/// a(x, v) of the particles in `slots`, written to `out`, and what follows.
pub struct Accelerations<'a, R: Real, T, F> {
    pub system: &'a System<'a, R>,
    pub states: &'a States<'a, R>,
    /// Begins and ends with a tile, or with the particles.
    pub slots: Range<u32>,
    /// Of these slots.
    pub out: ColumnsMut<'a, R>,
    pub then: T,
    /// What springs pull with.
    pub tension: F,
    /// Where it pays to have one.
    pub window: Option<&'a mut Window<R>>,
}

/// What is not in columns of the world, aligned, so that no vector lies across two lines of the cache.
#[repr(C, align(64))]
pub struct Room<T>(pub T);

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Outcome {
    /// Springs of length 0.
    pub degenerate: u32,
    /// Whether all that followed is finite.
    pub finite: bool,
}

impl<R: Real, F: Pull> Accelerations<'_, R, &mut dyn Then<R>, F> {
    /// With room for the forces from above on the particles of a tile, or on all if they are fewer, all 0. Nothing if a
    /// column is too short.
    pub fn go_through(&mut self, mut from_above: ColumnsMut<'_, R>) -> Option<Outcome> {
        if cfg!(feature = "small") {
            return plain::go_through(self, from_above);
        }
        // Lent, as it is too large to be moved about.
        let Self { system, states, slots, out, then, window, .. } = self;
        let (system, states) = (*system, *states);
        let attached = system.plan.attached;
        let pulled = slots.start.min(attached)..slots.end.min(attached);
        let mut outcome = Outcome { degenerate: 0, finite: true };
        // Of few particles their own masses are in the first cache as well.
        let of_one_mass;
        let inverse_mass: &[R] = if system.plan.particles > TILE {
            of_one_mass = Room([at(system.inverse_mass, system.plan.of_one_mass.0); TILE as usize]);
            &of_one_mass.0
        } else {
            &[]
        };
        // Only of a part springs reach what is not its own: the whole need not make it 0.
        let mut elsewhere;
        let mut nowhere: Option<&mut Scratch<R>> = if pulled != (0..attached) {
            elsewhere = [[R::ZERO; TILE as usize]; 3];
            Some(&mut elsewhere)
        } else {
            None
        };
        let mut sweep = Sweep::reaching(&system.springs.first(system.plan.live()), system.plan.span, pulled.start);
        let mut is_cleared = true;
        while sweep.slot < pulled.end {
            let tile = sweep.slot..sweep.slot.saturating_add(TILE).min(pulled.end);
            let is_ours = tile.start >= pulled.start;
            for column in window_mut(lend(out), within(&pulled, &sweep.clearing(&tile, &pulled))) {
                column.fill(R::ZERO);
            }
            let mut forces = Forces {
                states,
                lanes: system.lanes,
                start: tile.start,
                above: lend(&mut from_above),
                is_cleared,
                slots: pulled.clone(),
                below: lend(out),
                nowhere: nowhere.as_deref_mut(),
            };
            let window = window.as_deref_mut().filter(|_| is_ours);
            let springs = SpringsOf {
                system,
                sweep: &mut sweep,
                tile: tile.clone(),
                window,
                forces: &mut forces,
                tension: PhantomData::<F>,
            };
            let degenerate = F::pull(system.lanes, springs)?;
            is_cleared = false;
            if !is_ours {
                // It lies before these slots: its springs were gone through for what they pull at in them.
                continue;
            }
            outcome.degenerate += degenerate;
            let below = cut_mut(lend(out), within(&pulled, &tile))?;
            let above = cut(read(&from_above), 0..tile.end - tile.start)?;
            let inverse_mass = inverse_masses(system, &tile, inverse_mass)?;
            // Made where it is wanted: moved, it would have to be read while it is still being written.
            let slots = tile.clone();
            let sums = || Tile::of(system, slots, below, above, inverse_mass, Origin::Pulled);
            outcome.finite &= if let Some(hold_up) = system.support {
                let mut held = sums();
                held.fresh();
                hold_up(system, tile, states.position.value, states.velocity, lend(&mut held.below));
                then.then(held)
            } else {
                then.then(sums())
            };
        }
        for tile in tiles(slots.start.max(attached)..slots.end) {
            let none = cut_mut(lend(out), within(slots, &tile))?;
            // Of a length with the others: what is in it is not looked at.
            let above = cut(read(&from_above), 0..tile.end - tile.start)?;
            let inverse_mass = inverse_masses(system, &tile, inverse_mass)?;
            outcome.finite &= then.then(Tile::of(system, tile, none, above, inverse_mass, Origin::Falling));
        }
        Some(outcome)
    }
}

/// Where some slots are among others.
#[inline(always)]
fn within(slots: &Range<u32>, part: &Range<u32>) -> Range<u32> {
    part.start - slots.start..part.end - slots.start
}

/// Adds the forces of the springs that begin in a tile. Returns how many of them have length 0.
///
/// It is compiled for each set of instructions by itself, and not again for all that may follow.
pub struct SpringsOf<'a, 'b, 'c, R: Real, F> {
    system: &'a System<'b, R>,
    sweep: &'a mut Sweep<'b>,
    tile: Range<u32>,
    window: Option<&'a mut Window<R>>,
    forces: &'a mut Forces<'c, R>,
    tension: PhantomData<F>,
}

impl<R: Real, F: Tension> Kernel for SpringsOf<'_, '_, '_, R, F> {
    type Output = Option<u32>;

    #[inline(always)]
    fn run(self, set: impl Set) -> Option<u32> {
        let Self { system, sweep, tile, window, forces, .. } = self;
        // With lengths that are known to be the same, a range is checked once for all columns.
        let particles = 0..system.plan.particles;
        let states = States {
            position: forces.states.position.cut(particles.clone())?,
            velocity: cut(forces.states.velocity, particles)?,
        };
        let mut forces = Forces {
            states: &states,
            lanes: forces.lanes,
            start: forces.start,
            above: cut_mut(lend(&mut forces.above), 0..tile.end - tile.start)?,
            is_cleared: forces.is_cleared,
            slots: forces.slots.clone(),
            below: cut_mut(lend(&mut forces.below), 0..forces.slots.end - forces.slots.start)?,
            nowhere: forces.nowhere.as_deref_mut(),
        };
        match window {
            // What nobody can have costs a program nothing.
            Some(window) if cfg!(feature = "std") => {
                add_windowed::<R, F>(system, sweep, &tile, window, &mut forces, set)
            }
            _ => Some(add_tile::<R, F>(system, sweep, tile.end, &mut forces)),
        }
    }
}

/// Adds the forces of the springs that begin in a tile, through the window if most of them lie on no diagonal and none
/// reaches too far. Returns how many of them have length 0.
#[inline(always)]
fn add_windowed<R: Real, F: Tension>(
    system: &System<'_, R>,
    sweep: &mut Sweep<'_>,
    tile: &Range<u32>,
    window: &mut Window<R>,
    forces: &mut Forces<'_, R>,
    set: impl Set,
) -> Option<u32> {
    let first = forces.slots.start;
    let slots = tile.start..sweep.reach(tile).min(system.plan.attached);
    if slots.end > forces.slots.end || !Window::<R>::holds(&slots) || !sweep.is_mostly_scattered(tile.end) {
        window.let_go_of_all(lend(&mut forces.below), first)?;
        return Some(add_tile::<R, F>(system, sweep, tile.end, forces));
    }
    window.keep(&slots, forces.states.position, forces.states.velocity, read(&forces.below), first)?;
    let springs = sweep.all(tile.end);
    let degenerate = if system.plan.damped == Coverage::None {
        window.add::<F::Undamped>(&system.springs, springs, set)?
    } else {
        window.add::<F>(&system.springs, springs, set)?
    };
    window.write_above(lend(&mut forces.above));
    window.let_go(tile.end, lend(&mut forces.below), first)?;
    Some(degenerate)
}

/// Adds the forces of the springs that begin in the tile up to `end`. Returns how many of them have length 0.
#[inline(always)]
fn add_tile<R: Real, F: Tension>(
    system: &System<'_, R>,
    sweep: &mut Sweep<'_>,
    end: u32,
    forces: &mut Forces<'_, R>,
) -> u32 {
    let springs = &system.springs;
    if !forces.is_cleared {
        for column in lend(&mut forces.above) {
            column.fill(R::ZERO);
        }
    }
    let mut degenerate = 0;
    loop {
        let (scattered, piece) = sweep.next(end);
        if !scattered.is_empty() {
            degenerate += if system.plan.damped == Coverage::None && !cfg!(feature = "compact") {
                scattered::add::<R, F::Undamped>(springs, scattered, forces)
            } else {
                scattered::add::<R, F>(springs, scattered, forces)
            };
        }
        let Some(piece) = piece else { break };
        degenerate += diagonal::add::<R, F>(springs, &piece, forces);
    }
    sweep.slot = end;
    degenerate
}

/// The forces on the particles of a tile as they are being added.
pub struct Forces<'a, R: Real> {
    pub states: &'a States<'a, R>,
    pub lanes: Present,
    /// The tile's first slot.
    pub start: u32,
    /// From springs to higher slots, of the tile's particles.
    pub above: ColumnsMut<'a, R>,
    /// Whether these are 0 still.
    pub is_cleared: bool,
    /// The slots that are asked for.
    pub slots: Range<u32>,
    /// From springs to lower slots, of those.
    pub below: ColumnsMut<'a, R>,
    /// For what springs to lower slots do to others, if there are any.
    pub nowhere: Option<&'a mut Scratch<R>>,
}

/// What forces follow from.
pub struct States<'a, R: Real> {
    pub position: Carried<'a, R>,
    pub velocity: Columns<'a, R>,
}

/// A vector for each particle of a tile.
pub type Scratch<R> = [[R; TILE as usize]; 3];
