//! What makes a linear system easy: a factor of its matrix, or at least the inverses of its diagonal blocks.

use super::block::{Symmetric, add_spring, inverse, times_symmetric};
use super::factor::Factor;
use super::linearised::Linearisation;
use crate::Real;
use crate::world::System;

/// An approximate inverse of a matrix.
pub enum Preconditioner<'a, 'b, R> {
    /// The inverses of the diagonal blocks, by slot (block Jacobi).
    Blocks(&'a [Symmetric<R>]),
    /// A factor: of this very matrix, or of one that it was near to.
    Factor(&'a mut Factor<'b, R>),
}

impl<R: Real> Preconditioner<'_, '_, R> {
    /// Writes what it makes of r to `out`, by slot.
    pub fn apply(&mut self, r: &[[R; 3]], out: &mut [[R; 3]]) {
        match self {
            Self::Blocks(blocks) => {
                for ((out, r), block) in out.iter_mut().zip(r).zip(blocks.iter()) {
                    *out = times_symmetric(*block, *r);
                }
            }
            Self::Factor(factor) => factor.solve(r, out),
        }
    }
}

/// The inverses of the matrix's diagonal blocks; they are positive definite since the masses are.
pub fn invert_blocks<R: Real>(system: &System<'_, R>, matrix: &Linearisation<'_, R>, blocks: &mut [Symmetric<R>]) {
    add_up_diagonal(system, matrix, blocks);
    for block in blocks.iter_mut() {
        *block = inverse(*block);
    }
}

/// The matrix's diagonal blocks, by slot.
pub fn add_up_diagonal<R: Real>(system: &System<'_, R>, matrix: &Linearisation<'_, R>, blocks: &mut [Symmetric<R>]) {
    for (block, mass) in blocks.iter_mut().zip(system.mass) {
        *block = [*mass, *mass, *mass, R::ZERO, R::ZERO, R::ZERO];
    }
    let springs = system.springs.ends.iter().zip(matrix.axis.iter().zip(matrix.resistance));
    for (ends, (&axis, &[stretch, across])) in springs {
        for slot in ends {
            if let Some(block) = blocks.get_mut(*slot as usize) {
                *block = add_spring(*block, axis, stretch, across);
            }
        }
    }
}
