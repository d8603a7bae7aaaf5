//! Tables that stand for many particles and springs.

mod block;
mod cloth;
mod cloud;
mod lattice;
mod mesh;
mod rope;

use crate::model::{ModelParticle, ModelSpring};

use super::error::Problem;
use super::size::Size;

pub(super) use block::Block;
pub(super) use cloth::Cloth;
pub(super) use cloud::Cloud;
pub(super) use mesh::{Mesh, MeshEntry};
pub(super) use rope::Rope;

/// One such table.
pub(super) trait Generator {
    /// Refuses what cannot be made.
    fn check(&self) -> Result<(), Problem>;

    /// How much it makes, known before any of it is made.
    fn size(&self) -> Size;

    /// Its particles, in the order of their numbers.
    fn particles(&self, out: &mut Vec<ModelParticle>);

    /// Its springs, where its particles are numbered from `first` on.
    fn springs(&self, first: u32, out: &mut Vec<ModelSpring>);
}
