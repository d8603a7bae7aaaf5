//! What can be wrong, one enum an operation. After any of these the world is as it was.

use core::fmt;

use super::{Particle, Plane, Spring};
use crate::Real;

/// A column has no room for what it should hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Full {
    /// How many it can hold.
    pub capacity: usize,
}

/// Why a particle was not added.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AddParticleError<R: Real> {
    /// The world has no room for another; here it is back.
    Full(Particle<R>),
    /// The mass is not positive and finite, or so small that its inverse is not finite.
    Mass(R),
    /// A component of the position or of the velocity is infinite or NaN.
    NotFinite,
}

/// Why a spring was not added.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AddSpringError<R> {
    /// The world has no room for another; here it is back.
    Full(Spring<R>),
    /// There is no particle of this number.
    NoSuchParticle(u32),
    /// Both ends are this particle.
    SameParticle(u32),
    /// The stiffness is negative, infinite or NaN.
    Stiffness(R),
    /// The damping is negative, infinite or NaN.
    Damping(R),
    /// The rest length is negative, infinite or NaN.
    RestLength(R),
}

/// Why a plane was not made or not added.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AddPlaneError<R> {
    /// The world has no room for another; here it is back.
    Full(Plane<R>),
    /// The normal is 0, infinite or NaN.
    Normal,
    /// The point is infinite or NaN, or too far away for its distance from the origin to be finite.
    Point,
    /// The restitution is outside 0…1.
    Restitution(R),
}

/// Why a value was not set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SetError {
    /// There is no particle of this number.
    NoSuchParticle(u32),
    /// A component is infinite or NaN.
    NotFinite,
    /// It must be positive and finite.
    NotPositive,
    /// There is no plane of this number.
    NoSuchPlane(u32),
    /// A parameter of this spring is negative, infinite or NaN.
    Spring(u32),
    /// The restitution is outside 0…1.
    Restitution,
}

/// Why a step was not taken. The state is as it was before it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum StepError {
    /// The time step is not positive and finite.
    TimeStep,
    /// The stepper is for worlds without damping.
    Damped,
    /// The tolerance of the stepper is not positive and finite.
    Tolerance,
    /// The workspace of the stepper or of the response is too small for the world.
    Workspace(Full),
    /// The step would have made this particle's position or velocity infinite or NaN.
    NonFinite {
        /// The first such particle by number.
        particle: u32,
    },
}

impl fmt::Display for Full {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is room for {} only", self.capacity)
    }
}

impl<R: Real> fmt::Display for AddParticleError<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full(_) => write!(f, "the world has no room for another particle"),
            Self::Mass(mass) => write!(f, "the mass {mass} kg, or its inverse, is not positive and finite"),
            Self::NotFinite => write!(f, "the position or the velocity is not finite"),
        }
    }
}

impl<R: Real> fmt::Display for AddSpringError<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full(_) => write!(f, "the world has no room for another spring"),
            Self::NoSuchParticle(number) => write!(f, "there is no particle {number}"),
            Self::SameParticle(number) => write!(f, "both ends are particle {number}"),
            Self::Stiffness(value) => {
                write!(f, "the stiffness {value} N/m is not finite and 0 or more")
            }
            Self::Damping(value) => {
                write!(f, "the damping {value} N·s/m is not finite and 0 or more")
            }
            Self::RestLength(value) => {
                write!(f, "the rest length {value} m is not finite and 0 or more")
            }
        }
    }
}

impl<R: Real> fmt::Display for AddPlaneError<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full(_) => write!(f, "the world has no room for another plane"),
            Self::Normal => write!(f, "the normal is zero or not finite"),
            Self::Point => write!(f, "the point is not finite"),
            Self::Restitution(value) => write!(f, "the restitution {value} is outside 0 to 1"),
        }
    }
}

impl fmt::Display for SetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchParticle(number) => write!(f, "there is no particle {number}"),
            Self::NotFinite => write!(f, "the value is not finite"),
            Self::NotPositive => write!(f, "the value is not positive and finite"),
            Self::NoSuchPlane(number) => write!(f, "there is no plane {number}"),
            Self::Spring(number) => write!(f, "a parameter of spring {number} is not finite and 0 or more"),
            Self::Restitution => write!(f, "the restitution is outside 0 to 1"),
        }
    }
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TimeStep => write!(f, "the time step is not positive and finite"),
            Self::Damped => write!(f, "the stepper is for worlds without damping"),
            Self::Tolerance => write!(f, "the tolerance is not positive and finite"),
            Self::Workspace(full) => write!(f, "the workspace is too small for the world: {full}"),
            Self::NonFinite { particle } => {
                write!(f, "particle {particle} would become infinite or NaN")
            }
        }
    }
}

impl core::error::Error for Full {}
impl<R: Real> core::error::Error for AddParticleError<R> {}
impl<R: Real> core::error::Error for AddSpringError<R> {}
impl<R: Real> core::error::Error for AddPlaneError<R> {}
impl core::error::Error for SetError {}
impl core::error::Error for StepError {}

impl From<Full> for StepError {
    fn from(full: Full) -> Self {
        Self::Workspace(full)
    }
}
