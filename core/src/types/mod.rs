//! What a caller hands over and gets back: particles, springs, planes, errors, reports.

mod error;
mod particle;
mod plane;
mod report;
mod sleep;
mod spring;

pub use error::{AddParticleError, AddPlaneError, AddSpringError, Full, SetError, StepError};
pub use particle::{Hold, Particle};
pub use plane::Plane;
pub use report::StepReport;
pub use sleep::Sleep;
pub use spring::Spring;
