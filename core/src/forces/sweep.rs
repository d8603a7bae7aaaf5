//! Going through the springs in order: pieces of diagonals, and what lies between them.

use core::ops::Range;

use crate::Real;
use crate::vectors::at;
use crate::world::{Piece, Springs, TILE, Words};

/// How far a pass over the springs has come.
pub struct Sweep<'a> {
    ends: &'a [[u32; 2]],
    /// The first slot of the next tile.
    pub slot: u32,
    /// The first spring that has not been dealt with.
    spring: u32,
    /// The pieces that have not been dealt with.
    pieces: &'a [Words],
    /// The slots before this one have been set to 0.
    cleared: u32,
}

impl<'a> Sweep<'a> {
    /// From the first tile on whose springs, which reach `span` slots at most, may reach `slot`.
    #[inline(always)]
    pub fn reaching<R: Real>(springs: &Springs<'a, R>, span: u32, slot: u32) -> Self {
        let first = slot.saturating_sub(span) / TILE * TILE;
        let (ends, pieces) = (springs.ends, springs.pieces);
        if first == 0 {
            return Self { ends, slot: 0, spring: 0, pieces, cleared: slot };
        }
        // Within a tile springs are not ordered by their lower ends, but tiles are.
        let spring = ends.partition_point(|[i, _]| *i < first) as u32;
        let before = pieces.partition_point(|piece| Piece::from_words(*piece).first < first);
        Self { ends, slot: first, spring, pieces: pieces.get(before..).unwrap_or_default(), cleared: slot }
    }

    /// What the springs of the next tile reach and has not been cleared yet, of these slots.
    #[inline(always)]
    pub fn clearing(&mut self, tile: &Range<u32>, slots: &Range<u32>) -> Range<u32> {
        // A tile's first spring reaches furthest.
        let [i, j] = at(self.ends, self.spring);
        let reach = if i < tile.end { tile.end.saturating_add(j - i) } else { tile.end };
        let from = self.cleared;
        self.cleared = reach.min(slots.end).max(from);
        from..self.cleared
    }

    /// The springs before the next piece that begins before the slot `end`, and that piece; if there is none, all the
    /// springs that begin before `end`.
    #[inline(always)]
    pub fn next(&mut self, end: u32) -> (Range<u32>, Option<Piece>) {
        let spring = self.spring;
        if let Some((words, rest)) = self.pieces.split_first() {
            let piece = Piece::from_words(*words);
            if piece.first < end {
                self.pieces = rest;
                self.spring = piece.spring + piece.springs;
                return (spring..piece.spring, Some(piece));
            }
        }
        let rest = self.ends.get(spring as usize..).unwrap_or_default();
        if rest.first().is_some_and(|[i, _]| *i < end) {
            self.spring += rest.partition_point(|[i, _]| *i < end) as u32;
        }
        (spring..self.spring, None)
    }
}
