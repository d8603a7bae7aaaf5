//! A point mass.

use crate::Real;

/// How a particle is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// It moves as the forces on it say.
    #[default]
    Free,
    /// It stays where it is: its inverse mass and its velocity are 0.
    Pinned,
    /// It moves with the velocity that it is given, whatever pulls at it: its inverse mass is 0.
    Kinematic,
}

/// A point mass, as a caller describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<R: Real> {
    /// m; finite.
    pub position: R::Vec3,
    /// m/s; finite; taken as 0 for a pinned particle.
    pub velocity: R::Vec3,
    /// kg; positive and finite.
    pub mass: R,
    /// Free, pinned or kinematic.
    pub hold: Hold,
}

impl<R: Real> Particle<R> {
    /// A free particle of 1 kg at rest at `position` (m).
    #[must_use]
    pub fn at(position: impl Into<R::Vec3>) -> Self {
        Self { position: position.into(), velocity: [R::Coordinate::ZERO; 3].into(), mass: R::ONE, hold: Hold::Free }
    }

    /// The same particle with another mass (kg).
    #[must_use]
    pub fn with_mass(self, mass: R) -> Self {
        Self { mass, ..self }
    }

    /// The same particle with another velocity (m/s).
    #[must_use]
    pub fn with_velocity(self, velocity: impl Into<R::Vec3>) -> Self {
        Self { velocity: velocity.into(), ..self }
    }

    /// The same particle, pinned where it is.
    #[must_use]
    pub fn pinned(self) -> Self {
        Self { hold: Hold::Pinned, ..self }
    }

    /// The same particle, moving with its velocity whatever pulls at it.
    #[must_use]
    pub fn kinematic(self) -> Self {
        Self { hold: Hold::Kinematic, ..self }
    }
}
