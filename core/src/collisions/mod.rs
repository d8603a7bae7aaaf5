//! Collisions with planes, in three named forms, and flight from plane to plane.

mod bounce;
mod contact;
mod flights;
mod project;
mod reflect;
mod stop;
mod time_of_impact;

pub use flights::Flights;
pub use project::Project;
pub use reflect::Reflect;
pub use time_of_impact::TimeOfImpact;

pub(crate) use contact::{Support, hold_up, support};
pub(crate) use reflect::Answer;

use crate::Real;
use crate::step::Observer;
use crate::steppers::Stepper;
use crate::types::{Full, StepError, StepReport};
use crate::world::{Plan, View};

/// A form of collision response: what happens when a step takes particles through planes.
pub trait Response<R: Real> {
    /// Makes room for a world.
    ///
    /// # Errors
    /// If the workspace has a fixed capacity and the world is larger.
    fn fit(&mut self, _plan: &Plan) -> Result<(), Full> {
        Ok(())
    }

    /// Takes a whole step, collisions included, and makes what comes of it the current state.
    ///
    /// # Errors
    /// If that would not be finite; the state is then as it was.
    fn step(
        &mut self,
        view: &mut View<'_, R>,
        stepper: &mut impl Stepper<R>,
        dt: R,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError>;
}
