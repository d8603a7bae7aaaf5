//! The room that an implicit solve needs, owned by the steppers that do it.

use super::block::Symmetric;
use super::room::{Direct, Room};
use super::worth::LinearSolver;
use crate::Real;
use crate::contact::Support;
use crate::types::Full;
use crate::world::{Column, Plan, Storage, System};

/// 21 reals and a support a particle, 6 reals a spring, and the [`Room`] for a factor.
pub struct Workspace<R: Real, M: Storage, const FILL: usize> {
    /// Direction, residual, spare, search and product.
    vectors: [M::Particles<[R; 3]>; 5],
    blocks: M::Particles<Symmetric<R>>,
    support: M::Particles<Support<R>>,
    axis: M::Springs<[R; 3]>,
    force_density: M::Springs<R>,
    resistance: M::Springs<[R; 2]>,
    room: Room<R, M, FILL>,
}

/// The same as slices.
pub struct Scratch<'a, R> {
    /// The solution of the linear system so far, and so where a line search goes, m/s.
    pub direction: &'a mut [[R; 3]],
    /// Of the equation, kg·m/s.
    pub residual: &'a mut [[R; 3]],
    /// What is left of the linear system's right-hand side, kg·m/s; the velocities that a line search starts from, m/s.
    pub spare: &'a mut [[R; 3]],
    /// The search direction of the conjugate gradients; the velocities now, where the equation is linearised once.
    pub search: &'a mut [[R; 3]],
    /// The matrix times that, and then what the preconditioner makes of the rest.
    pub product: &'a mut [[R; 3]],
    /// The matrix's diagonal blocks, or their inverses; the impulses of the springs.
    pub blocks: &'a mut [Symmetric<R>],
    /// What planes take from each particle.
    pub support: &'a mut [Support<R>],
    /// d̂ of each spring.
    pub axis: &'a mut [[R; 3]],
    /// Tension over length of each spring, N/m.
    pub force_density: &'a mut [R],
    /// The spring's part of the matrix, along d̂ more than across it, and across it, kg.
    pub resistance: &'a mut [[R; 2]],
    /// The factor.
    pub direct: Direct<'a, R>,
}

impl<R: Real, M: Storage, const FILL: usize> Workspace<R, M, FILL> {
    /// Without room for anything yet.
    pub const fn new() -> Self {
        Self {
            vectors: [const { Column::EMPTY }; 5],
            blocks: Column::EMPTY,
            support: Column::EMPTY,
            axis: Column::EMPTY,
            force_density: Column::EMPTY,
            resistance: Column::EMPTY,
            room: Room::new(),
        }
    }

    /// Makes room for what springs pull at.
    pub fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        let (particles, springs) = (plan.attached as usize, plan.springs as usize);
        for column in &mut self.vectors {
            column.fit(particles)?;
        }
        self.blocks.fit(particles)?;
        self.support.fit(particles)?;
        self.axis.fit(springs)?;
        self.force_density.fit(springs)?;
        self.resistance.fit(springs)
    }

    /// What solves the linear systems of a step of `dt`, with room for the world.
    pub fn linear_solver(&mut self, system: &System<'_, R>, dt: R) -> Result<LinearSolver, Full> {
        self.fit(&system.plan)?;
        Ok(self.room.prepare(system, dt))
    }

    /// As slices, for a step of `dt`.
    pub fn lend(&mut self, system: &System<'_, R>, dt: R) -> Scratch<'_, R> {
        self.room.prepare(system, dt);
        let [direction, residual, spare, search, product] = &mut self.vectors;
        Scratch {
            direction: direction.items_mut(),
            residual: residual.items_mut(),
            spare: spare.items_mut(),
            search: search.items_mut(),
            product: product.items_mut(),
            blocks: self.blocks.items_mut(),
            support: self.support.items_mut(),
            axis: self.axis.items_mut(),
            force_density: self.force_density.items_mut(),
            resistance: self.resistance.items_mut(),
            direct: self.room.lend(),
        }
    }
}
