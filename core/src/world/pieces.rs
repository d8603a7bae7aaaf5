//! Diagonals: springs whose ends are a constant number of slots apart, in pieces that a loop runs through.
//!
//! Seen as a matrix, the springs of a rope lie on one diagonal and those of a cloth on six (the DIA format of Saad,
//! *Iterative Methods for Sparse Linear Systems*, §3.4). A piece is a stretch of a diagonal within one tile: its
//! particles, and those at the other ends, are contiguous, so nothing has to be gathered.

use core::ops::Range;

use crate::Real;
use crate::vectors::{at, put};

/// Particles that are stepped together, while all that a step needs of them is in the first cache.
pub const TILE: u32 = 256;

/// The slots of a range, so many as a tile has at a time.
#[inline(always)]
pub fn tiles(slots: Range<u32>) -> impl Iterator<Item = Range<u32>> {
    stretches(slots, TILE)
}

/// The slots of a range, so many at a time.
#[inline(always)]
pub fn stretches(slots: Range<u32>, length: u32) -> impl Iterator<Item = Range<u32>> {
    let end = slots.end;
    slots.step_by(length as usize).map(move |start| start..start.saturating_add(length).min(end))
}

/// Pieces begin and end at multiples of this where they can: as many lanes as there are.
const LANES: u32 = 16;
/// Fewer springs than this are not worth a piece.
pub const LEAST: u32 = 8;
/// More places without a spring than this end a piece.
const LONGEST_GAP: u32 = 7;
/// What a piece is kept in: no more words than it has springs.
pub type Words = [u32; 6];
/// In place of where its presences begin: every place has a spring.
const NO_GAPS: u32 = u32::MAX;

/// A stretch of one diagonal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The slot of the first place.
    pub first: u32,
    /// Places, with or without a spring.
    pub places: u32,
    /// The other end of a spring is so many slots on.
    pub offset: u32,
    /// Its first spring.
    pub spring: u32,
    /// Its springs; as many as places where there are no gaps.
    pub springs: u32,
    /// Where the presences of its places begin, if not all have a spring.
    pub presences: Option<u32>,
    /// All springs are the first one's like.
    pub uniform: bool,
}

impl Piece {
    /// As it is kept.
    #[inline(always)]
    pub fn from_words([first, places, offset, spring, springs, presences]: Words) -> Self {
        Self {
            first,
            places,
            offset,
            spring,
            springs: springs >> 1,
            presences: (presences != NO_GAPS).then_some(presences),
            uniform: springs & 1 == 1,
        }
    }

    /// Of these places only.
    #[inline(always)]
    pub fn part(&self, places: Range<u32>) -> Self {
        Self {
            first: self.first + places.start,
            places: places.end - places.start,
            spring: if self.uniform { self.spring } else { self.spring + places.start },
            presences: self.presences.map(|presences| presences + places.start),
            ..*self
        }
    }

    fn to_words(self) -> Words {
        let springs = self.springs << 1 | u32::from(self.uniform);
        [self.first, self.places, self.offset, self.spring, springs, self.presences.unwrap_or(NO_GAPS)]
    }
}

/// Springs in the order in which their forces are added, whose pieces are to be found.
pub struct Ordered<'a, R> {
    /// Slots, the lower first.
    pub ends: &'a [[u32; 2]],
    /// N/m
    pub stiffness: &'a [R],
    /// N·s/m
    pub damping: &'a [R],
    /// m
    pub rest_length: &'a [R],
    /// Slots of particles that springs pull at.
    pub attached: u32,
}

/// Where pieces are written to.
pub struct Found<'a> {
    /// Room for a word a spring.
    pub words: &'a mut [u32],
    /// Room for two presences a spring.
    pub presences: &'a mut [u8],
    /// Pieces found.
    pub pieces: u32,
    /// Presences written.
    pub places: u32,
    /// Springs in pieces.
    pub springs: u32,
}

impl<R: Real> Ordered<'_, R> {
    /// Finds the pieces. What is in none of them is left to be gone through spring by spring.
    pub fn find_pieces(&self, found: &mut Found<'_>) {
        let mut spring = 0;
        while let Some(&[first, _]) = self.ends.get(spring as usize) {
            let (uniform, varied) = (self.uniform_stretch(spring), self.varied_stretch(spring));
            if uniform >= LEAST && uniform.saturating_mul(4) >= varied {
                found.add(self.uniform_piece(spring, uniform), self.ends);
                spring += uniform;
            } else if varied >= LEAST {
                let offset = self.offset(spring);
                let piece =
                    Piece { first, places: varied, offset, spring, springs: varied, presences: None, uniform: false };
                found.add(piece, self.ends);
                spring += varied;
            } else {
                spring += 1;
            }
        }
    }

    /// How many springs from this one on differ in nothing but where they are, with short gaps at most.
    fn uniform_stretch(&self, spring: u32) -> u32 {
        let first = at(self.ends, spring)[0];
        self.stretch(spring, |next, count| {
            let (last, place) = (at(self.ends, next - 1)[0], at(self.ends, next)[0]);
            let like = |column: &[R]| at(column, next) == at(column, spring);
            place - last <= LONGEST_GAP + 1
                // The presences have room for twice as many places as springs.
                && place - first < 2 * count
                && [self.stiffness, self.damping, self.rest_length].into_iter().all(like)
        })
    }

    /// How many springs from this one on leave no gap.
    fn varied_stretch(&self, spring: u32) -> u32 {
        self.stretch(spring, |next, _| at(self.ends, next)[0] - at(self.ends, next - 1)[0] == 1)
    }

    /// How many springs from this one on lie on one diagonal, in one tile, at increasing places, and go on as they
    /// should.
    fn stretch(&self, spring: u32, goes_on: impl Fn(u32, u32) -> bool) -> u32 {
        let [first, _] = at(self.ends, spring);
        let mut count = 1;
        while let Some(&[i, j]) = self.ends.get((spring + count) as usize)
            && j - i == self.offset(spring)
            && i / TILE == first / TILE
            && i > at(self.ends, spring + count - 1)[0]
            && goes_on(spring + count, count)
        {
            count += 1;
        }
        count
    }

    fn offset(&self, spring: u32) -> u32 {
        let [i, j] = at(self.ends, spring);
        j - i
    }

    /// The piece of a uniform stretch, widened to whole lanes if there is room for its presences.
    fn uniform_piece(&self, spring: u32, springs: u32) -> Piece {
        let offset = self.offset(spring);
        let (first, last) = (at(self.ends, spring)[0], at(self.ends, spring + springs - 1)[0]);
        let tile_end = (first / TILE + 1).saturating_mul(TILE);
        let wide_first = first / LANES * LANES;
        let wide_end = (last / LANES + 1).saturating_mul(LANES).min(tile_end).min(self.attached - offset);
        let (first, end) =
            if wide_end - wide_first <= 2 * springs { (wide_first, wide_end) } else { (first, last + 1) };
        // Where the presences are is decided when the piece is added.
        let presences = (end - first != springs).then_some(0);
        Piece { first, places: end - first, offset, spring, springs, presences, uniform: true }
    }
}

impl Found<'_> {
    fn add(&mut self, mut piece: Piece, ends: &[[u32; 2]]) {
        if let Some(presences) = &mut piece.presences {
            *presences = self.places;
            let places = self.places as usize..(self.places + piece.places) as usize;
            let places = self.presences.get_mut(places).unwrap_or_default();
            places.fill(0);
            let ends = ends.get(piece.spring as usize..(piece.spring + piece.springs) as usize).unwrap_or_default();
            for [i, _] in ends {
                put(places, i - piece.first, 1);
            }
            self.places += piece.places;
        }
        let (pieces, _) = self.words.as_chunks_mut();
        put(pieces, self.pieces, piece.to_words());
        self.pieces += 1;
        self.springs += piece.springs;
    }
}
