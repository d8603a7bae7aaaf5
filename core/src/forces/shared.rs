//! Work that is shared among threads, if whoever owns the world has some to offer.

use super::tiles::{Accelerations, Outcome, Then};
use super::window::{self, Window};
use crate::Real;
use crate::lanes;
use crate::vectors::split;
use crate::workers::Workers;
use crate::world::TILE;

/// Does the work, in halves for as long as there are threads for them.
///
/// Each half writes to its own particles alone, and goes through the springs that pull at them in the same order as
/// the whole would: the bits are the same. What both need of a spring across the cut is worked out twice.
pub fn run<R: Real, T: Then<R>>(work: Accelerations<'_, R, T>) -> Outcome {
    match work.system.workers {
        Some(workers) => share(work, workers, workers.count()),
        None => alone(work),
    }
}

fn alone<R: Real, T: Then<R>>(work: Accelerations<'_, R, T>) -> Outcome {
    let plan = &work.system.plan;
    if window::pays(plan.springs - plan.on_diagonals) {
        through_window(work)
    } else {
        lanes::run(work.system.lanes, work)
    }
}

/// Apart, so that others need not have the room.
#[inline(never)]
fn through_window<R: Real, T: Then<R>>(work: Accelerations<'_, R, T>) -> Outcome {
    let mut window = Window::new();
    lanes::run(work.system.lanes, Accelerations { window: Some(&mut window), ..work })
}

fn share<R: Real, T: Then<R>>(work: Accelerations<'_, R, T>, workers: &dyn Workers, threads: u32) -> Outcome {
    let length = work.slots.end - work.slots.start;
    // In proportion, and by whole tiles.
    let first_threads = threads / 2;
    let cut = (u64::from(length) * u64::from(first_threads) / u64::from(threads.max(1))) as u32;
    let slot = (work.slots.start + cut) / TILE * TILE;
    if threads < 2 || slot <= work.slots.start || slot >= work.slots.end {
        return alone(work);
    }
    let (lower, upper) = halves(work, slot);
    let (mut lower, mut upper) = (Some(lower), Some(upper));
    let (mut first, mut second) = (Outcome::default(), Outcome::default());
    workers.both(
        &mut || {
            first = lower.take().map_or(first, |half| share(half, workers, first_threads));
        },
        &mut || {
            second = upper.take().map_or(second, |half| share(half, workers, threads - first_threads));
        },
    );
    Outcome { degenerate: first.degenerate + second.degenerate, finite: first.finite && second.finite }
}

fn halves<R: Real, T: Then<R>>(
    work: Accelerations<'_, R, T>,
    slot: u32,
) -> (Accelerations<'_, R, T>, Accelerations<'_, R, T>) {
    let Accelerations { system, position, velocity, slots, out, then, .. } = work;
    let (lower_out, upper_out) = split(out, slot - slots.start);
    let (lower_then, upper_then) = then.split(slot);
    let (lower, upper) = (slots.start..slot, slot..slots.end);
    (
        Accelerations { system, position, velocity, slots: lower, out: lower_out, then: lower_then, window: None },
        Accelerations { system, position, velocity, slots: upper, out: upper_out, then: upper_then, window: None },
    )
}
