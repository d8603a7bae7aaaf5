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
        let from = self.cleared;
        self.cleared = self.reach(tile).min(slots.end).max(from);
        from..self.cleared
    }

    /// The slots before this one hold all that the springs of the next tile reach.
    #[inline(always)]
    pub fn reach(&self, tile: &Range<u32>) -> u32 {
        // A tile's first spring reaches furthest.
        let [i, j] = at(self.ends, self.spring);
        if i < tile.end { tile.end.saturating_add(j - i) } else { tile.end }
    }

    /// Whether most of the springs that begin before the slot `end` are in no piece.
    #[inline(always)]
    pub fn is_mostly_scattered(&self, end: u32) -> bool {
        let pieces = self.pieces.iter().map(|words| Piece::from_words(*words)).take_while(|piece| piece.first < end);
        let in_pieces: u32 = pieces.map(|piece| piece.springs).sum();
        let middle = self.ends.get(self.spring.saturating_add(2 * in_pieces) as usize);
        in_pieces == 0 || middle.is_some_and(|[i, _]| *i < end)
    }

    /// All the springs that begin before the slot `end`, in pieces or not.
    #[inline(always)]
    pub fn all(&mut self, end: u32) -> Range<u32> {
        while let Some((words, rest)) = self.pieces.split_first() {
            if Piece::from_words(*words).first >= end {
                break;
            }
            self.pieces = rest;
        }
        let first = self.spring;
        self.spring = self.end(end);
        self.slot = end;
        first..self.spring
    }

    /// The first spring that begins at the slot `end` or after it.
    #[inline(always)]
    fn end(&self, end: u32) -> u32 {
        let rest = self.ends.get(self.spring as usize..).unwrap_or_default();
        let begins = rest.first().is_some_and(|[i, _]| *i < end);
        self.spring + if begins { rest.partition_point(|[i, _]| *i < end) as u32 } else { 0 }
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
        self.spring = self.end(end);
        (spring..self.spring, None)
    }
}
