//! The hot loop of steppers with stages: sums of accelerations, some particles at a time, so that their sums stay in
//! registers until all terms are added.

use core::ops::Range;

use super::combination::{Combination, MOST_STAGES};
use crate::Real;
use crate::lanes::{Kernel, Set};
use crate::vectors::{Columns, window};

/// The sums of the particles of a tile.
pub struct Sums<'a, 'b, R: Real> {
    pub combination: &'a mut Combination<'b, R>,
    pub tile: Range<u32>,
    /// The last accelerations, of this tile.
    pub fresh: Columns<'a, R>,
}

/// p, q and A of all slots.
type Term<'a, R> = (R, R, &'a Columns<'a, R>);

/// x and v along an axis.
type Both<R, const SIZE: usize> = ([R; SIZE], [R; SIZE]);

impl<R: Real> Kernel for Sums<'_, '_, R> {
    /// Whether they are finite, if that is asked; nothing if a column is too short.
    type Output = Option<bool>;

    #[inline(always)]
    fn run(self, set: impl Set) -> Option<bool> {
        // A velocity that nobody asks for is written all the same where there is one copy of the loop.
        if self.combination.terms.velocity.is_some() || cfg!(feature = "compact") {
            self.in_blocks::<true>(set)
        } else {
            self.in_blocks::<false>(set)
        }
    }
}

impl<R: Real> Sums<'_, '_, R> {
    /// As many particles at once as registers hold.
    #[inline(always)]
    fn in_blocks<const VELOCITY: bool>(self, set: impl Set) -> Option<bool> {
        match bytes_of_six(set) / size_of::<R>() {
            16 => self.sum::<16, VELOCITY>(),
            8 => self.sum::<8, VELOCITY>(),
            4 => self.sum::<4, VELOCITY>(),
            2 => self.sum::<2, VELOCITY>(),
            _ => self.sum::<1, VELOCITY>(),
        }
    }

    #[inline(always)]
    fn sum<const BLOCK: usize, const VELOCITY: bool>(mut self) -> Option<bool> {
        let Combination { terms, known, .. } = &*self.combination;
        let known = *known;
        let mut last = (terms.of(known.len()), self.fresh);
        let none = Columns::default();
        let mut gathered: [Term<'_, R>; MOST_STAGES] = [(R::ZERO, R::ZERO, &none); MOST_STAGES];
        let mut places = gathered.iter_mut();
        for (stage, columns) in known.iter().enumerate() {
            let (p, q) = terms.of(stage);
            if p != R::ZERO || q != R::ZERO {
                *places.next()? = (p, q, columns);
            }
        }
        let left = places.len();
        let mut terms = gathered.get(..MOST_STAGES - left)?;
        if last.0 == (R::ZERO, R::ZERO)
            && let [others @ .., (p, q, columns)] = terms
        {
            // The last does not count: another one is.
            (terms, last) = (others, ((*p, *q), window(**columns, self.tile.clone())));
        }
        let count = (self.tile.end - self.tile.start) as usize;
        let mut finite = true;
        if count < BLOCK {
            for place in 0..count {
                finite &= self.block::<1, VELOCITY>(terms, last, place)?;
            }
            return Some(finite);
        }
        let mut place = 0;
        while place < count {
            // What is left at the end is summed with some of those before it once more: sums read nothing that they write.
            finite &= self.block::<BLOCK, VELOCITY>(terms, last, place.min(count - BLOCK))?;
            place += BLOCK;
        }
        Some(finite)
    }

    /// Those of some particles, from a place in the tile on.
    #[inline(always)]
    fn block<const SIZE: usize, const VELOCITY: bool>(
        &mut self,
        summed: &[Term<'_, R>],
        (factors, fresh): ((R, R), Columns<'_, R>),
        place: usize,
    ) -> Option<bool> {
        let Combination { terms, is_step, carries_velocity, state, first, to, .. } = &mut *self.combination;
        let slot = self.tile.start as usize + place;
        let x = chunks::<R, SIZE>(state.0.value, slot)?;
        let v = chunks::<R, SIZE>(state.1.value, slot)?;
        let ([x, y, z], [u, v, w]) = (x, v);
        let kept = |v: &[R; SIZE]| if R::IS_COMPENSATED && *carries_velocity { [R::ZERO; SIZE] } else { *v };
        // Axis by axis in so many words: loops over axes that the compiler leaves alone would keep sums in memory.
        let mut sums = [
            (drifted(x, u, terms.drift), kept(u)),
            (drifted(y, v, terms.drift), kept(v)),
            (drifted(z, w, terms.drift), kept(w)),
        ];
        for (p, q, columns) in summed {
            add::<R, SIZE, VELOCITY>(&mut sums, (*p, *q), chunks(**columns, slot)?);
        }
        add::<R, SIZE, VELOCITY>(&mut sums, factors, chunks(fresh, place)?);
        let [(x, u), (y, v), (z, w)] = &sums;
        let to_slot = slot - *first as usize;
        let [x_to, y_to, z_to] = &mut to.position;
        *chunk_mut(x_to, to_slot)? = *x;
        *chunk_mut(y_to, to_slot)? = *y;
        *chunk_mut(z_to, to_slot)? = *z;
        let mut finite = !*is_step || are_finite(x) && are_finite(y) && are_finite(z);
        if VELOCITY {
            let [u_to, v_to, w_to] = &mut to.velocity;
            *chunk_mut(u_to, to_slot)? = *u;
            *chunk_mut(v_to, to_slot)? = *v;
            *chunk_mut(w_to, to_slot)? = *w;
            finite &= !*is_step || are_finite(u) && are_finite(v) && are_finite(w);
        }
        Some(finite)
    }
}

#[inline(always)]
fn bytes_of_six<S: Set>(_set: S) -> usize {
    S::BYTES_OF_SIX
}

/// x + h v, or what that adds to x where it is added later.
#[inline(always)]
fn drifted<R: Real, const SIZE: usize>(x: &[R; SIZE], v: &[R; SIZE], h: R) -> [R; SIZE] {
    let mut sum = [R::ZERO; SIZE];
    for ((to, x), v) in sum.iter_mut().zip(x).zip(v) {
        let drift = h * *v;
        *to = if R::IS_COMPENSATED { drift } else { *x + drift };
    }
    sum
}

/// Adds p A to the positions, and q A to the velocities.
#[inline(always)]
fn add<R: Real, const SIZE: usize, const VELOCITY: bool>(
    [x, y, z]: &mut [Both<R, SIZE>; 3],
    factors: (R, R),
    [a_x, a_y, a_z]: [&[R; SIZE]; 3],
) {
    add_along::<R, SIZE, VELOCITY>(x, factors, a_x);
    add_along::<R, SIZE, VELOCITY>(y, factors, a_y);
    add_along::<R, SIZE, VELOCITY>(z, factors, a_z);
}

#[inline(always)]
fn add_along<R: Real, const SIZE: usize, const VELOCITY: bool>(
    (position, velocity): &mut Both<R, SIZE>,
    (p, q): (R, R),
    a: &[R; SIZE],
) {
    for ((x, v), a) in position.iter_mut().zip(velocity).zip(a) {
        *x += p * *a;
        if VELOCITY {
            *v += q * *a;
        }
    }
}

#[inline(always)]
fn are_finite<R: Real, const SIZE: usize>(sums: &[R; SIZE]) -> bool {
    sums.iter().fold(true, |finite, value| finite & value.is_finite())
}

/// So many items of three columns, from a place on.
#[inline(always)]
fn chunks<T, const SIZE: usize>([x, y, z]: Columns<'_, T>, place: usize) -> Option<[&[T; SIZE]; 3]> {
    let range = place..place + SIZE;
    Some([x.get(range.clone())?.first_chunk()?, y.get(range.clone())?.first_chunk()?, z.get(range)?.first_chunk()?])
}

/// So many items, to be written.
#[inline(always)]
fn chunk_mut<T, const SIZE: usize>(column: &mut [T], place: usize) -> Option<&mut [T; SIZE]> {
    column.get_mut(place..place + SIZE)?.first_chunk_mut()
}
