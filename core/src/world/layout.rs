//! The data layout: which columns there are, and what each costs. Structure of arrays throughout.

use super::storage::{Column, Storage};
use super::view::State;
use crate::Real;
use crate::carried::Carried;
use crate::types::{AddParticleError, AddSpringError, Full, Hold, Particle, Spring};
use crate::vectors::{Columns, ColumnsMut};

/// One spring as one of its particles sees it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Incidence {
    /// The slot of the particle at the other end.
    pub neighbour: u32,
    /// The spring.
    pub spring: u32,
}

/// Positions and velocities: 6 reals a particle, and as many residuals where numbers have any.
#[derive(Clone)]
pub struct StateColumns<R: Real, M: Storage> {
    /// m
    pub position: [M::Particles<R>; 3],
    /// m/s
    pub velocity: [M::Particles<R>; 3],
    /// Of positions.
    pub position_residual: [M::Particles<R::Residual>; 3],
    /// Of velocities.
    pub velocity_residual: [M::Particles<R::Residual>; 3],
}

/// What a particle has: 14 reals and 13 bytes, that is 69 bytes in `f32` and 125 in `f64`; 12 residuals more where numbers
/// have any, and 117 bytes.
///
/// Particles are kept in *slots*: first those that springs pull at, then those in free flight, each in the order of
/// their numbers; where islands may sleep, as `islands.rs` says, and where a mesh is numbered badly, as `renumber.rs`
/// says. Nobody outside sees a slot.
#[derive(Clone)]
pub struct ParticleColumns<R: Real, M: Storage> {
    /// The state now and the state that a step is making: 12 reals. A step that fails leaves the first untouched.
    pub state: [StateColumns<R, M>; 2],
    /// kg: 1 real.
    pub mass: M::Particles<R>,
    /// 1/kg, 0 where pinned or kinematic: 1 real.
    pub inverse_mass: M::Particles<R>,
    /// The slot of each particle: 4 bytes.
    pub slot_of: M::Particles<u32>,
    /// The particle in each slot: 4 bytes.
    pub particle_at: M::Particles<u32>,
    /// Where the incidences of each slot end; they begin where those of the slot before end: 4 bytes.
    pub incidence_end: M::Particles<u32>,
    /// How it rests, by number (`rest.rs`): 1 byte.
    pub rest: M::Particles<u8>,
}

/// What a spring has: 3 reals and 34 bytes, that is 46 bytes in `f32` and 58 in `f64`.
///
/// They are kept in the order in which their forces are added (`order.rs`).
#[derive(Clone)]
pub struct SpringColumns<R: Real, M: Storage> {
    /// The slots of its particles, the lower first once they are in order: 8 bytes.
    pub ends: M::Springs<[u32; 2]>,
    /// N/m: 1 real.
    pub stiffness: M::Springs<R>,
    /// N·s/m: 1 real.
    pub damping: M::Springs<R>,
    /// m: 1 real.
    pub rest_length: M::Springs<R>,
    /// The incidences of all particles, two a spring, read as one list: 16 bytes.
    pub incidences: M::Springs<[Incidence; 2]>,
    /// Its number: 4 bytes.
    pub number: M::Springs<u32>,
    /// The pieces of diagonals, in order, at most a word a spring: 4 bytes.
    pub pieces: M::Springs<u32>,
    /// Whether there is a spring at each place of a piece that has gaps, at most two a spring: 2 bytes.
    pub presences: M::Springs<[u8; 2]>,
}

impl<R: Real, M: Storage> StateColumns<R, M> {
    pub const EMPTY: Self = Self {
        position: [const { Column::EMPTY }; 3],
        velocity: [const { Column::EMPTY }; 3],
        position_residual: [const { Column::EMPTY }; 3],
        velocity_residual: [const { Column::EMPTY }; 3],
    };

    pub fn position(&self) -> Carried<'_, R> {
        Carried { value: items(&self.position), residual: items(&self.position_residual) }
    }

    pub fn velocity(&self) -> Carried<'_, R> {
        Carried { value: items(&self.velocity), residual: items(&self.velocity_residual) }
    }

    #[cfg_attr(feature = "compact", inline(never))]
    pub fn lend(&mut self) -> State<'_, R> {
        State {
            position: items_mut(&mut self.position),
            velocity: items_mut(&mut self.velocity),
            position_residual: items_mut(&mut self.position_residual),
            velocity_residual: items_mut(&mut self.velocity_residual),
        }
    }

    /// Makes room for so many particles.
    pub fn fit(&mut self, count: usize) -> Result<(), Full> {
        fit(&mut self.position, count)?;
        fit(&mut self.velocity, count)?;
        fit(&mut self.position_residual, count)?;
        fit(&mut self.velocity_residual, count)
    }

    /// Nothing where there is no room.
    fn push(&mut self, position: R::Vec3, velocity: R::Vec3) -> Option<()> {
        push::<R, M>(&mut self.position, &mut self.position_residual, position)?;
        push::<R, M>(&mut self.velocity, &mut self.velocity_residual, velocity)
    }
}

/// Appends a vector. Nothing where there is no room.
#[cfg_attr(feature = "compact", inline(never))]
fn push<R: Real, M: Storage>(
    columns: &mut [M::Particles<R>; 3],
    residuals: &mut [M::Particles<R::Residual>; 3],
    vector: R::Vec3,
) -> Option<()> {
    let coordinates: [R::Coordinate; 3] = vector.into();
    for ((column, residuals), coordinate) in columns.iter_mut().zip(residuals).zip(&coordinates) {
        let (value, residual) = R::carry(*coordinate);
        column.push(value).ok()?;
        residuals.push(residual).ok()?;
    }
    Some(())
}

fn fit<T: Copy + Default, C: Column<T>>(columns: &mut [C; 3], count: usize) -> Result<(), Full> {
    for column in columns {
        column.fit(count)?;
    }
    Ok(())
}

fn items<T: Copy, C: Column<T>>([x, y, z]: &[C; 3]) -> Columns<'_, T> {
    [x.items(), y.items(), z.items()]
}

fn items_mut<T: Copy, C: Column<T>>([x, y, z]: &mut [C; 3]) -> ColumnsMut<'_, T> {
    [x.items_mut(), y.items_mut(), z.items_mut()]
}

impl<R: Real, M: Storage> ParticleColumns<R, M> {
    pub const EMPTY: Self = Self {
        state: [StateColumns::EMPTY, StateColumns::EMPTY],
        mass: Column::EMPTY,
        inverse_mass: Column::EMPTY,
        slot_of: Column::EMPTY,
        particle_at: Column::EMPTY,
        incidence_end: Column::EMPTY,
        rest: Column::EMPTY,
    };

    pub fn count(&self) -> u32 {
        // Numbers are 32 bits wide: `push` refuses the particle that would not have one.
        self.particle_at.items().len() as u32
    }

    /// Appends a particle that has been checked.
    pub fn push(&mut self, particle: Particle<R>) -> Result<u32, AddParticleError<R>> {
        self.push_columns(&particle).ok_or(AddParticleError::Full(particle))
    }

    fn push_columns(&mut self, particle: &Particle<R>) -> Option<u32> {
        let number = self.count();
        if number == u32::MAX {
            return None;
        }
        // Every column has the same capacity, so the first one to be pushed to decides for all.
        self.particle_at.push(number).ok()?;
        self.slot_of.push(number).ok()?;
        self.incidence_end.push(0).ok()?;
        self.rest.push(0).ok()?;
        let free = particle.hold == Hold::Free;
        self.mass.push(particle.mass).ok()?;
        self.inverse_mass.push(if free { R::ONE / particle.mass } else { R::ZERO }).ok()?;
        let velocity = if particle.hold == Hold::Pinned { [R::Coordinate::ZERO; 3].into() } else { particle.velocity };
        for state in &mut self.state {
            state.push(particle.position, velocity)?;
        }
        Some(number)
    }
}

impl<R: Real, M: Storage> SpringColumns<R, M> {
    pub const EMPTY: Self = Self {
        ends: Column::EMPTY,
        stiffness: Column::EMPTY,
        damping: Column::EMPTY,
        rest_length: Column::EMPTY,
        incidences: Column::EMPTY,
        number: Column::EMPTY,
        pieces: Column::EMPTY,
        presences: Column::EMPTY,
    };

    pub fn count(&self) -> u32 {
        self.ends.items().len() as u32
    }

    /// Appends a spring that has been checked, between two slots.
    pub fn push(&mut self, spring: Spring<R>, ends: [u32; 2]) -> Result<u32, AddSpringError<R>> {
        self.push_columns(&spring, ends).ok_or(AddSpringError::Full(spring))
    }

    fn push_columns(&mut self, spring: &Spring<R>, ends: [u32; 2]) -> Option<u32> {
        let number = self.count();
        // Each spring has two incidences, and those are counted in 32 bits.
        if number >= u32::MAX / 2 {
            return None;
        }
        self.ends.push(ends).ok()?;
        self.stiffness.push(spring.stiffness).ok()?;
        self.damping.push(spring.damping).ok()?;
        self.rest_length.push(spring.rest_length).ok()?;
        self.incidences.push([Incidence::default(); 2]).ok()?;
        self.number.push(number).ok()?;
        self.pieces.push(0).ok()?;
        self.presences.push([0; 2]).ok()?;
        Some(number)
    }
}
