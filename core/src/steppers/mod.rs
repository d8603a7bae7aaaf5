//! Steppers, one a file: they differ only where the mathematics does, and each owns what it needs to remember.

mod auto;
mod explicit_euler;
mod implicit_euler;
mod implicit_euler_linearised;
mod semi_implicit_euler;
mod velocity_verlet;

pub use auto::{Auto, Choice, Chosen};
pub use explicit_euler::ExplicitEuler;
pub use implicit_euler::ImplicitEuler;
pub use implicit_euler_linearised::ImplicitEulerLinearised;
pub use semi_implicit_euler::SemiImplicitEuler;
pub use velocity_verlet::VelocityVerlet;

use crate::Real;
use crate::types::{Full, StepReport};
use crate::world::{Plan, View};

/// A rule that makes the state a time step later from the state now.
pub trait Stepper<R: Real> {
    /// Makes room for a world.
    ///
    /// # Errors
    /// If the workspace has a fixed capacity and the world is larger.
    fn fit(&mut self, _plan: &Plan) -> Result<(), Full> {
        Ok(())
    }

    /// Writes the state `dt` seconds after the current one to the next one. Planes are not its business.
    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport;

    /// β in the path x + τ v + β τ² a that it takes a particle along that nothing but gravity pulls at.
    fn curvature(&self) -> R;

    /// Flies the particles that no spring pulls at exactly from the time `from`, at which they are in the current state,
    /// to the end of the step, and returns the energy lost in impacts, J. Nothing if it does not: they then take the
    /// path above.
    fn fly(&mut self, _view: &mut View<'_, R>, _from: f64, _report: &mut StepReport) -> Option<f64> {
        None
    }

    /// Writes the particles that [`Stepper::fly`] flies, as they will be at a time within the next step, to the next
    /// state. False if there is no such flight.
    fn look_ahead(&mut self, _view: &mut View<'_, R>, _time: f64) -> bool {
        false
    }
}
