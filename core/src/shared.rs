//! Work that is shared among threads, if whoever owns the world has some to offer.

use core::ops::Range;

use crate::workers::Workers;
use crate::world::TILE;

/// Work on particles that can be cut in two between any two tiles of them, without changing a bit of what comes of it.
pub trait Divisible: Sized + Send {
    /// What comes of it.
    type Outcome: Default + Send;

    /// The particles that it writes to.
    fn slots(&self) -> Range<u32>;

    /// Particles before its own that each part but the first goes through as well.
    fn overlap(&self) -> u32 {
        0
    }

    /// The work on those before this slot, and on those from it on.
    fn halves(self, slot: u32) -> (Self, Self);

    /// Does it.
    fn alone(self) -> Self::Outcome;

    /// What comes of both halves.
    fn joined(first: Self::Outcome, second: Self::Outcome) -> Self::Outcome;
}

/// Does the work, in halves for as long as there are threads for them.
pub fn share<W: Divisible>(work: W, workers: Option<&dyn Workers>) -> W::Outcome {
    match workers {
        // A compact program has no second copy for threads.
        Some(workers) if !cfg!(feature = "compact") => among(work, workers, workers.count()),
        _ => work.alone(),
    }
}

fn among<W: Divisible>(work: W, workers: &dyn Workers, threads: u32) -> W::Outcome {
    let slots = work.slots();
    // In proportion to the threads, what parts go through in common included, and by whole tiles: who is done first goes
    // to sleep, and takes longer to wake than a small step.
    let first_threads = threads / 2;
    let [all, first, overlap] = [threads, first_threads, work.overlap()].map(u64::from);
    let whole = u64::from(slots.end - slots.start) + overlap * all.saturating_sub(1);
    let cut = (whole * first / all.max(1)).saturating_sub(overlap * first.saturating_sub(1)) as u32;
    let slot = slots.start.saturating_add(cut).saturating_add(TILE / 2) / TILE * TILE;
    if threads < 2 || slot <= slots.start || slot >= slots.end {
        return work.alone();
    }
    let (lower, upper) = work.halves(slot);
    let (mut lower, mut upper) = (Some(lower), Some(upper));
    let (mut first, mut second) = (W::Outcome::default(), W::Outcome::default());
    workers.both(
        &mut || {
            if let Some(half) = lower.take() {
                first = among(half, workers, first_threads);
            }
        },
        &mut || {
            if let Some(half) = upper.take() {
                second = among(half, workers, threads - first_threads);
            }
        },
    );
    W::joined(first, second)
}
