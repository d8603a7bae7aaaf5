//! How the work on accelerations is cut in two, and done where it is not.

use core::ops::Range;

use super::law::Pull;
use super::tiles::{Accelerations, Follow, Outcome, Room, Then};
use super::window::{self, Window};
use crate::Real;
use crate::lanes::Lanes;
use crate::shared::Divisible;
use crate::vectors::split;
use crate::world::{System, TILE};

/// Each half writes to its own particles alone, and goes through the springs that pull at them in the same order as
/// the whole would: the bits are the same. What both need of a spring across the cut is worked out twice.
impl<R: Real, T: Follow<R>, F: Pull> Divisible for Accelerations<'_, R, T, F> {
    type Outcome = Outcome;

    fn slots(&self) -> Range<u32> {
        self.slots.clone()
    }

    fn overlap(&self) -> u32 {
        self.system.plan.span
    }

    fn halves(self, slot: u32) -> (Self, Self) {
        let Self { system, states, slots, out, then, tension, .. } = self;
        let (lower_out, upper_out) = split(out, slot - slots.start);
        let (lower_then, upper_then) = then.split(slot);
        let (lower, upper) = (slots.start..slot, slot..slots.end);
        (
            Self { system, states, slots: lower, out: lower_out, then: lower_then, tension, window: None },
            Self { system, states, slots: upper, out: upper_out, then: upper_then, tension, window: None },
        )
    }

    fn alone(mut self) -> Outcome {
        let Self { system, states, slots, out, tension, .. } = self;
        alone(Accelerations { system, states, slots, out, then: &mut self.then, tension, window: None })
    }

    fn joined(first: Outcome, second: Outcome) -> Outcome {
        Outcome { degenerate: first.degenerate + second.degenerate, finite: first.finite && second.finite }
    }
}

/// Particles that are so few that clearing the room for a whole tile would take longer than they do.
const FEW: usize = TILE as usize / 2;

fn alone<R: Real, F: Pull>(mut work: Accelerations<'_, R, &mut dyn Then<R>, F>) -> Outcome {
    let plan = &work.system.plan;
    if window::pays(plan.live() - plan.on_diagonals) {
        through_window(work)
    } else if plan.particles as usize <= FEW {
        with_room::<R, F, FEW>(&mut work)
    } else {
        with_room::<R, F, { TILE as usize }>(&mut work)
    }
}

/// Apart, so that others need not have the room.
#[inline(never)]
fn with_room<R: Real, F: Pull, const SIZE: usize>(work: &mut Accelerations<'_, R, &mut dyn Then<R>, F>) -> Outcome {
    let mut room = const { Room([[R::ZERO; SIZE]; 3]) };
    work.go_through(room.0.each_mut().map(<[R; SIZE]>::as_mut_slice)).unwrap_or_default()
}

/// Apart likewise.
#[inline(never)]
fn through_window<R: Real, F: Pull>(work: Accelerations<'_, R, &mut dyn Then<R>, F>) -> Outcome {
    let mut window = Window::new();
    // What a window writes in vectors of AVX2 is read right after: wider ones would wait until it has left the store buffer.
    let system = &System { lanes: work.system.lanes.at_most(Lanes::Avx2), ..*work.system };
    with_room::<R, F, { TILE as usize }>(&mut Accelerations { system, window: Some(&mut window), ..work })
}
