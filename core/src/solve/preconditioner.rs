//! What makes a linear system easy: a factor of its matrix, or at least the inverses of its diagonal blocks.

use super::block::{add_spring, inverse, times_symmetric};
use super::workspace::Scratch;
use crate::Real;
use crate::world::System;

/// An approximate inverse of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preconditioner {
    /// The inverses of the diagonal blocks (block Jacobi).
    Blocks,
    /// The factor: of this very matrix, or of one that it was near to.
    Factor,
}

impl<R: Real> Scratch<'_, R> {
    /// Writes what a preconditioner makes of the rest to the product.
    pub fn precondition(&mut self, preconditioner: Preconditioner) {
        if preconditioner == Preconditioner::Factor {
            self.direct.factor.solve(self.spare, self.product);
            return;
        }
        for ((out, r), block) in self.product.iter_mut().zip(self.spare.iter()).zip(self.blocks.iter()) {
            *out = times_symmetric(*block, *r);
        }
    }

    /// The inverses of the matrix's diagonal blocks; they are positive definite since the masses are.
    pub fn invert_blocks(&mut self, system: &System<'_, R>) {
        self.add_up_diagonal(system);
        for block in self.blocks.iter_mut() {
            *block = inverse(*block);
        }
    }

    /// The matrix's diagonal blocks.
    pub fn add_up_diagonal(&mut self, system: &System<'_, R>) {
        for (block, mass) in self.blocks.iter_mut().zip(system.mass) {
            *block = [*mass, *mass, *mass, R::ZERO, R::ZERO, R::ZERO];
        }
        let springs = system.springs.ends.iter().zip(self.axis.iter().zip(self.resistance.iter()));
        for (ends, (&axis, &[stretch, across])) in springs {
            for slot in ends {
                if let Some(block) = self.blocks.get_mut(*slot as usize) {
                    *block = add_spring(*block, axis, stretch, across);
                }
            }
        }
    }
}
