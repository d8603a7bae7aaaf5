//! The room that an implicit solve needs, owned by the steppers that do it.

use crate::Real;
use crate::contact::Support;
use crate::types::Full;
use crate::vectors::ColumnsMut;
use crate::world::{Column, Plan, Storage};

/// 21 reals and a support a particle, 5 reals a spring.
pub struct Workspace<R: Real, M: Storage> {
    base: [M::Particles<R>; 3],
    direction: [M::Particles<R>; 3],
    residual: [M::Particles<R>; 3],
    search: [M::Particles<R>; 3],
    product: [M::Particles<R>; 3],
    preconditioner: [M::Particles<R>; 6],
    support: M::Particles<Support<R>>,
    axis: [M::Springs<R>; 3],
    along: M::Springs<R>,
    across: M::Springs<R>,
}

/// The same as slices.
pub struct Scratch<'a, R> {
    /// The velocities that a line search starts from, m/s.
    pub base: ColumnsMut<'a, R>,
    /// Where it searches, m/s.
    pub direction: ColumnsMut<'a, R>,
    /// Of the equation, and then of its linearisation, kg·m/s.
    pub residual: ColumnsMut<'a, R>,
    /// The search direction of the conjugate gradients.
    pub search: ColumnsMut<'a, R>,
    /// The matrix times that.
    pub product: ColumnsMut<'a, R>,
    /// The inverses of the matrix's diagonal blocks: xx, yy, zz, xy, xz, yz.
    pub preconditioner: [&'a mut [R]; 6],
    /// What planes take from each particle.
    pub support: &'a mut [Support<R>],
    /// d̂ of each spring.
    pub axis: ColumnsMut<'a, R>,
    /// The spring's part of the matrix along d̂, kg.
    pub along: &'a mut [R],
    /// Its part across d̂, kg.
    pub across: &'a mut [R],
}

impl<R: Real, M: Storage> Workspace<R, M> {
    /// Without room for anything yet.
    pub const fn new() -> Self {
        Self {
            base: [const { Column::EMPTY }; 3],
            direction: [const { Column::EMPTY }; 3],
            residual: [const { Column::EMPTY }; 3],
            search: [const { Column::EMPTY }; 3],
            product: [const { Column::EMPTY }; 3],
            preconditioner: [const { Column::EMPTY }; 6],
            support: Column::EMPTY,
            axis: [const { Column::EMPTY }; 3],
            along: Column::EMPTY,
            across: Column::EMPTY,
        }
    }

    /// Makes room for what springs pull at.
    pub fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        let (particles, springs) = (plan.attached as usize, plan.springs as usize);
        let vectors = [&mut self.base, &mut self.direction, &mut self.residual, &mut self.search, &mut self.product];
        let columns = vectors.into_iter().flatten().chain(&mut self.preconditioner);
        columns.into_iter().try_for_each(|column| column.fit(particles))?;
        self.support.fit(particles)?;
        let columns = self.axis.iter_mut().chain([&mut self.along, &mut self.across]);
        columns.into_iter().try_for_each(|column| column.fit(springs))
    }

    /// As slices.
    pub fn lend(&mut self) -> Scratch<'_, R> {
        Scratch {
            base: self.base.each_mut().map(Column::items_mut),
            direction: self.direction.each_mut().map(Column::items_mut),
            residual: self.residual.each_mut().map(Column::items_mut),
            search: self.search.each_mut().map(Column::items_mut),
            product: self.product.each_mut().map(Column::items_mut),
            preconditioner: self.preconditioner.each_mut().map(Column::items_mut),
            support: self.support.items_mut(),
            axis: self.axis.each_mut().map(Column::items_mut),
            along: self.along.items_mut(),
            across: self.across.items_mut(),
        }
    }
}
