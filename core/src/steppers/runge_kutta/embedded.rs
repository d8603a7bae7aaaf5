//! How far a step is off, by formulas of lower order over the same stages.

use super::RungeKutta;
use super::tableau::{Tableau, weighted};
use crate::Real;
use crate::lanes::{self, Kernel, Set};
use crate::vectors::{Columns, cut};
use crate::world::{Column, Storage, TILE, View, tiles};

/// dt² Σ pⱼ Aⱼ and dt Σ qⱼ Aⱼ: what a formula of lower order makes of a position and a velocity, less what the method does.
#[derive(Clone, Copy)]
pub struct Difference<const STAGES: usize> {
    /// p
    pub position: [f64; STAGES],
    /// q
    pub velocity: [f64; STAGES],
}

impl<const STAGES: usize> Difference<STAGES> {
    /// Of a method for equations of first order with these stages; the weights add up to 0.
    pub const fn of(weights: [f64; STAGES], matrix: &[[f64; STAGES]; STAGES]) -> Self {
        Self { position: weighted(&weights, matrix), velocity: weights }
    }
}

/// Weights less others.
pub const fn less<const STAGES: usize>(weights: [f64; STAGES], others: [f64; STAGES]) -> [f64; STAGES] {
    let mut difference = weights;
    let (mut to, mut from) = (difference.as_mut_slice(), others.as_slice());
    while let ([entry, further_to @ ..], [other, further_from @ ..]) = (to, from) {
        *entry -= *other;
        (to, from) = (further_to, further_from);
    }
    difference
}

/// A tableau with formulas of lower order.
pub trait Embedded<const STAGES: usize>: Tableau<STAGES> {
    /// One or two.
    const DIFFERENCES: [Option<Difference<STAGES>>; 2];
    /// The power of the step's length that the estimate falls with.
    const ESTIMATED_ORDER: u32;

    /// The estimate, m, from the sizes of the differences.
    fn estimate(differences: [f64; 2]) -> f64;
}

impl<R: Real, M: Storage, T: Embedded<STAGES>, const STAGES: usize> RungeKutta<R, M, T, STAGES> {
    /// How far the step of `dt` that has just been taken is off, m: in any position or, times `dt`, in any velocity.
    pub fn estimate(&self, view: &View<'_, R>, dt: R) -> f64 {
        let mut known = [Columns::<R>::default(); STAGES];
        for (known, columns) in known.iter_mut().zip(&self.acceleration) {
            *known = columns.each_ref().map(Column::items);
        }
        let sizes = T::DIFFERENCES.map(|difference| {
            let Some(difference) = difference else { return 0.0 };
            let squared = dt.to_f64() * dt.to_f64();
            tiles(0..view.system.plan.particles).fold(0.0, |largest: f64, tile| {
                let stages = known.iter().zip(difference.position.iter().zip(&difference.velocity));
                let mut terms = [(R::ZERO, R::ZERO, Columns::<R>::default()); STAGES];
                for (term, (columns, (p, q))) in terms.iter_mut().zip(stages) {
                    let Some(columns) = cut(*columns, tile.clone()) else { return f64::INFINITY };
                    *term = (R::from_f64(squared * p), R::from_f64(squared * q), columns);
                }
                largest.max(lanes::run(view.system.lanes, Largest { terms: &terms }).to_f64())
            })
        });
        T::estimate(sizes)
    }
}

/// The largest |Σ p A| and |Σ q A| of the particles of a tile along any axis.
struct Largest<'a, R> {
    terms: &'a [(R, R, Columns<'a, R>)],
}

impl<R: Real> Kernel for Largest<'_, R> {
    type Output = R;

    #[inline(always)]
    fn run(self, _set: impl Set) -> R {
        let mut largest = R::ZERO;
        for axis in 0..3 {
            let mut sums = [[R::ZERO; TILE as usize]; 2];
            let [position, velocity] = &mut sums;
            for (p, q, columns) in self.terms.iter().filter(|(p, q, _)| *p != R::ZERO || *q != R::ZERO) {
                let column = columns.get(axis).copied().unwrap_or_default();
                for ((x, v), a) in position.iter_mut().zip(velocity.iter_mut()).zip(column) {
                    *x += *p * *a;
                    *v += *q * *a;
                }
            }
            for sum in sums.as_flattened() {
                largest = largest.at_least(sum.abs());
            }
        }
        largest
    }
}
