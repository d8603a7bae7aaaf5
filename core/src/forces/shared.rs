//! How the work on accelerations is cut in two, and done where it is not.

use core::ops::Range;

use super::law::Tension;
use super::tiles::{Accelerations, Outcome, Then};
use super::window::{self, Window};
use crate::Real;
use crate::lanes::Lanes;
use crate::shared::Divisible;
use crate::vectors::split;
use crate::world::System;

/// Each half writes to its own particles alone, and goes through the springs that pull at them in the same order as
/// the whole would: the bits are the same. What both need of a spring across the cut is worked out twice.
impl<R: Real, T: Then<R>, F: Tension> Divisible for Accelerations<'_, R, T, F> {
    type Outcome = Outcome;

    fn slots(&self) -> Range<u32> {
        self.slots.clone()
    }

    fn overlap(&self) -> u32 {
        self.system.plan.span
    }

    fn halves(self, slot: u32) -> (Self, Self) {
        let Self { system, position, velocity, slots, out, then, tension, .. } = self;
        let (lower_out, upper_out) = split(out, slot - slots.start);
        let (lower_then, upper_then) = then.split(slot);
        let (lower, upper) = (slots.start..slot, slot..slots.end);
        (
            Self { system, position, velocity, slots: lower, out: lower_out, then: lower_then, tension, window: None },
            Self { system, position, velocity, slots: upper, out: upper_out, then: upper_then, tension, window: None },
        )
    }

    fn alone(self) -> Outcome {
        let plan = &self.system.plan;
        if window::pays(plan.live() - plan.on_diagonals) {
            through_window(self)
        } else {
            self.go_through().unwrap_or_default()
        }
    }

    fn joined(first: Outcome, second: Outcome) -> Outcome {
        Outcome { degenerate: first.degenerate + second.degenerate, finite: first.finite && second.finite }
    }
}

/// Apart, so that others need not have the room.
#[inline(never)]
fn through_window<R: Real, T: Then<R>, F: Tension>(work: Accelerations<'_, R, T, F>) -> Outcome {
    let mut window = Window::new();
    // What a window writes in vectors of AVX2 is read right after: wider ones would wait until it has left the store buffer.
    let system = &System { lanes: work.system.lanes.at_most(Lanes::Avx2), ..*work.system };
    Accelerations { system, window: Some(&mut window), ..work }.go_through().unwrap_or_default()
}
