//! Where the entries of the factor are, and what it takes to compute them.

use core::ops::Range;

use super::ordering::{NONE, Ordering};
use super::worth::Elimination;
use crate::Real;
use crate::vectors::{at, items_of, part, put};
use crate::world::{System, Unsorted, exchange, sort};

/// The structure of a factor, turn by turn.
#[derive(Clone, Copy)]
pub struct Structure<'a> {
    /// When each slot is eliminated; [`NONE`] where held.
    pub turn_of: &'a [u32],
    /// The slot that each turn eliminates.
    pub slot_at: &'a [u32],
    /// Where the entries of each turn's column end.
    pub column_end: &'a [u32],
    /// The turns of those entries, ascending in each column.
    pub rows: &'a [u32],
    /// The entry that each spring adds to; [`NONE`] where an end is held.
    pub entry_of: &'a [u32],
}

impl<'a> Structure<'a> {
    /// The entries of a turn's column, and their turns.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline(always))]
    pub fn column(&self, turn: u32) -> (Range<usize>, &'a [u32]) {
        let entries = items_of(self.column_end, turn);
        let entries = entries.start as usize..entries.end as usize;
        (entries.clone(), self.rows.get(entries).unwrap_or_default())
    }
}

/// Orders the particles and lays out the factor; the first links become the entries of the springs. Nothing if there are
/// more entries than there is room for.
pub fn analyse<R: Real>(system: &System<'_, R>, mut ordering: Ordering<'_>) -> Option<Elimination> {
    let particles = ordering.find(system)?;
    let Ordering { turn_of, column_end, rows, links: entry_of, .. } = ordering;
    let mut elimination = Elimination { particles, blocks: 0, products: 0.0 };
    let mut start = 0;
    for end in column_end.iter().take(particles as usize) {
        let column = rows.get_mut(start as usize..*end as usize).unwrap_or_default();
        for row in column.iter_mut() {
            *row = at(turn_of, *row);
        }
        if cfg!(feature = "compact") {
            sort(&mut Turns(column), *end - start);
        } else {
            column.sort_unstable();
        }
        let entries = f64::from(*end - start);
        // Each entry is divided by its pivot, and multiplied with itself and with those below it.
        elimination.products += 1.0 + entries + 0.5 * entries * (entries + 1.0);
        elimination.blocks = *end;
        start = *end;
    }
    for (spring, ends) in (0..).zip(system.springs.ends) {
        let [i, j] = *ends;
        put(entry_of, spring, entry(at(turn_of, i), at(turn_of, j), column_end, rows));
    }
    Some(elimination)
}

/// Turns in no order yet.
struct Turns<'a>(&'a mut [u32]);

impl Unsorted for Turns<'_> {
    fn precedes(&self, first: u32, second: u32) -> bool {
        at(self.0, first) < at(self.0, second)
    }

    fn exchange(&mut self, first: u32, second: u32) {
        exchange(self.0, first, second);
    }
}

/// The entry where two turns meet.
fn entry(a: u32, b: u32, column_end: &[u32], rows: &[u32]) -> u32 {
    let (column, row) = (a.min(b), a.max(b));
    if row == NONE {
        return NONE;
    }
    let entries = items_of(column_end, column);
    let rows = part(rows, entries.clone()).unwrap_or_default();
    rows.binary_search(&row).map_or(NONE, |place| entries.start + place as u32)
}

/// A number that tells one topology from another: who is joined to whom, and who is held.
pub fn fingerprint<R: Real>(system: &System<'_, R>) -> u64 {
    let mut hash = mix(1, u64::from(system.plan.attached) << 32 | u64::from(system.plan.springs));
    for &[i, j] in system.springs.ends {
        hash = mix(hash, u64::from(i) << 32 | u64::from(j));
    }
    if system.plan.held > 0 {
        for slot in (0..system.plan.attached).filter(|slot| !system.is_dynamic(*slot)) {
            hash = mix(hash, u64::from(slot));
        }
    }
    hash
}

/// Multiplication by an odd number loses nothing (Knuth's golden ratio in 64 bits); the shift brings the upper half down.
#[cfg_attr(feature = "compact", inline(never))]
fn mix(hash: u64, value: u64) -> u64 {
    let mixed = (hash ^ value).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    mixed ^ (mixed >> 32)
}
