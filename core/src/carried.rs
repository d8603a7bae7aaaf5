//! Columns of numbers that are carried from step to step, with what they keep of their rounding.

use core::ops::Range;

use crate::Real;
use crate::lanes::{self, Present, SixColumns};
use crate::vectors::{
    Columns, ColumnsMut, cut, cut_mut, difference, fetch, fetch_inlined, lend, read, split, store, stretch, triples,
    triples_mut,
};

/// Three columns and their residuals, read.
#[derive(Clone, Copy)]
pub struct Carried<'a, R: Real> {
    pub value: Columns<'a, R>,
    pub residual: Columns<'a, R::Residual>,
}

impl<R: Real> Carried<'_, R> {
    /// The same stretch of all, or nothing if it does not lie in all of them.
    #[inline(always)]
    pub fn cut(self, range: Range<u32>) -> Option<Self> {
        // Where there are none, nothing is to be carried along that says so.
        let residual = if R::IS_COMPENSATED { cut(self.residual, range.clone())? } else { [R::NO_RESIDUALS; 3] };
        Some(Self { value: cut(self.value, range)?, residual })
    }

    /// So many of all from an index on, or nothing if there are fewer.
    #[inline(always)]
    pub fn stretch(self, first: u32, count: usize) -> Option<Self> {
        let residual = if R::IS_COMPENSATED { stretch(self.residual, first, count)? } else { [R::NO_RESIDUALS; 3] };
        Some(Self { value: stretch(self.value, first, count)?, residual })
    }

    /// Vector `to` less vector `from`.
    #[inline(always)]
    pub fn difference(self, to: u32, from: u32) -> [R; 3] {
        let value = difference(fetch_inlined(self.value, to), fetch_inlined(self.value, from));
        corrected(value, fetch_inlined(self.residual, to), fetch_inlined(self.residual, from))
    }

    /// Vector `index`.
    pub fn fetch(self, index: u32) -> [(R, R::Residual); 3] {
        zip(fetch(self.value, index), fetch(self.residual, index))
    }

    /// Writes the vectors of these slots, each number rounded to `f32`.
    #[inline(always)]
    pub fn tell(self, slots: &[u32], to: &mut [[f32; 3]]) {
        for (to, slot) in to.iter_mut().zip(slots) {
            let vector = zip(fetch_inlined(self.value, *slot), fetch_inlined(self.residual, *slot));
            *to = vector.map(|(value, residual)| value.told(residual).to_f64() as f32);
        }
    }

    /// The sum of vector `index` and an increment.
    pub fn plus(self, index: u32, increment: [R; 3]) -> [(R, R::Residual); 3] {
        zip(self.fetch(index), increment).map(|((value, residual), increment)| value.plus(residual, increment))
    }

    /// Vector `index` in `f64`.
    pub fn exactly(self, index: u32) -> [f64; 3] {
        let [x, y, z] = self.fetch(index);
        [x.0.told(x.1).to_f64(), y.0.told(y.1).to_f64(), z.0.told(z.1).to_f64()]
    }
}

/// A difference of vectors, given that of their values.
#[inline(always)]
pub fn corrected<R: Real>(value: [R; 3], minuend: [R::Residual; 3], subtrahend: [R::Residual; 3]) -> [R; 3] {
    let ([x, y, z], [xm, ym, zm], [xs, ys, zs]) = (value, minuend, subtrahend);
    [x.corrected(xm, xs), y.corrected(ym, ys), z.corrected(zm, zs)]
}

/// Component by component.
#[inline(always)]
pub fn zip<A, B>([x, y, z]: [A; 3], [u, v, w]: [B; 3]) -> [(A, B); 3] {
    [(x, u), (y, v), (z, w)]
}

/// Three columns and their residuals, written.
pub struct CarriedMut<'a, R: Real> {
    pub value: ColumnsMut<'a, R>,
    pub residual: ColumnsMut<'a, R::Residual>,
}

impl<R: Real> CarriedMut<'_, R> {
    /// Lent for reading.
    #[inline(always)]
    pub fn read(&self) -> Carried<'_, R> {
        Carried { value: read(&self.value), residual: read(&self.residual) }
    }

    /// Sets vector `index`.
    pub fn store(&mut self, index: u32, vector: [(R, R::Residual); 3]) {
        store(&mut self.value, index, vector.map(|(value, _)| value));
        store(&mut self.residual, index, vector.map(|(_, residual)| residual));
    }

    /// Lent on.
    #[inline(always)]
    pub fn lend(&mut self) -> CarriedMut<'_, R> {
        CarriedMut { value: lend(&mut self.value), residual: lend(&mut self.residual) }
    }
}

impl<'a, R: Real> CarriedMut<'a, R> {
    /// The same stretch of all, or nothing if it does not lie in all of them.
    #[inline(always)]
    pub fn cut(self, range: Range<u32>) -> Option<Self> {
        Some(Self { value: cut_mut(self.value, range.clone())?, residual: cut_mut(self.residual, range)? })
    }

    /// Before and from an index.
    pub fn split(self, index: u32) -> (Self, Self) {
        let (value, upper_value) = split(self.value, index);
        let (residual, upper_residual) = split(self.residual, index);
        (Self { value, residual }, Self { value: upper_value, residual: upper_residual })
    }

    /// Writes the sums of these numbers and the increments that are made of what stands in their places. Returns
    /// whether they are finite.
    #[inline(always)]
    pub fn add<I: Iterator<Item = F>, F: Fn([R; 3]) -> [R; 3]>(
        self,
        lanes: Present,
        from: Carried<'_, R>,
        increments: I,
    ) -> bool {
        let ([x, y, z], [u, v, w]) = (self.value, self.residual);
        lanes::run_on_six(lanes, Sums { from, increments }, x, y, z, u, v, w)
    }
}

/// What is added to, and what makes increments of what stands in the places of the sums.
struct Sums<'a, R: Real, I> {
    from: Carried<'a, R>,
    increments: I,
}

impl<R: Real, I: Iterator<Item = F>, F: Fn([R; 3]) -> [R; 3]> SixColumns<R, R::Residual> for Sums<'_, R, I> {
    /// Whether they are finite.
    type Output = bool;

    #[inline(always)]
    fn run(
        self,
        x: &mut [R],
        y: &mut [R],
        z: &mut [R],
        u: &mut [R::Residual],
        v: &mut [R::Residual],
        w: &mut [R::Residual],
    ) -> bool {
        let from = triples(self.from.value).zip(triples(self.from.residual)).zip(self.increments);
        let mut infinite = 0;
        for ((sum, lost), ((value, residual), increment)) in
            triples_mut([x, y, z]).zip(triples_mut([u, v, w])).zip(from)
        {
            let increments = increment(sum.each_ref().map(|component| **component));
            for ((sum, lost), ((value, residual), increment)) in
                zip(sum, lost).into_iter().zip(zip(zip(value, residual), increments))
            {
                (*sum, *lost) = value.plus(residual, increment);
                infinite |= u32::from(!sum.is_finite());
            }
        }
        infinite == 0
    }
}
