//! Who takes part in a step: the stepper advances the state, the response answers collisions, the observer looks on.

use crate::Real;
use crate::types::{Full, StepError, StepReport};
use crate::world::{Plan, View};

/// A rule that makes the state a time step later from the state now.
///
/// Whoever takes one takes a `&mut dyn Stepper<R>` too: so a program that chooses while it runs has one copy of the rest.
pub trait Stepper<R: Real> {
    /// Makes room for a world.
    ///
    /// # Errors
    /// If the workspace has a fixed capacity and the world is larger.
    fn fit(&mut self, _plan: &Plan) -> Result<(), Full> {
        Ok(())
    }

    /// Refuses a world that it cannot step.
    ///
    /// # Errors
    /// If the world has what the stepper's rule does not know.
    fn accept(&self, _plan: &Plan) -> Result<(), StepError> {
        Ok(())
    }

    /// Writes the state `dt` seconds after the current one to the next one. Planes are not its business.
    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport;

    /// Writes the state at most `most` seconds after the current one to the next one, and returns after how many: fewer
    /// where it chooses the lengths of its steps itself.
    fn advance_up_to(&mut self, view: &mut View<'_, R>, most: R, report: &mut StepReport) -> R {
        report.add(&self.advance(view, most));
        most
    }

    /// Whether it does. A stepper whose [`advance_up_to`](Self::advance_up_to) may return less than `most` has to say so here:
    /// what others return is taken for the whole step without a look, so that nothing of steps in parts is in a program that
    /// takes none.
    fn chooses_parts(&self) -> bool {
        false
    }

    /// A step begins.
    fn begins(&mut self, _view: &View<'_, R>) {}

    /// It has failed: what takes steps in parts makes the state what it was.
    fn fails(&mut self, _view: &mut View<'_, R>) {}

    /// The world as it is `after` seconds, at most `dt`, into the step of `dt` that has just been made from the current state to
    /// the next one, collisions aside; nothing if it cannot tell.
    fn between<'a>(&'a mut self, _view: &'a mut View<'_, R>, _dt: R, _after: R) -> Option<View<'a, R>> {
        None
    }

    /// The order of its accuracy.
    fn order(&self) -> u32;

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

    /// Particles are about to be moved to other slots while their state stays as it is, because some have fallen
    /// asleep: what it remembers of each must find it there.
    fn rearranged(&mut self, _view: &View<'_, R>) {}
}

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
        stepper: &mut (impl Stepper<R> + ?Sized),
        dt: R,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError>;
}

/// Somebody who follows a world through its steps, part by part. `()` looks away, and costs nothing.
pub trait Observer<R: Real> {
    /// Whether anything is done with what it is told.
    fn watches(&self) -> bool;

    /// The stepper has written the state `dt` seconds after the current one to the next one; collisions have not been
    /// answered yet.
    fn advanced(&mut self, view: &mut View<'_, R>, dt: R);

    /// The same, with who advanced: it may be able to tell what is between the two states.
    fn advanced_by(&mut self, view: &mut View<'_, R>, dt: R, _stepper: &mut (impl Stepper<R> + ?Sized)) {
        self.advanced(view, dt);
    }

    /// Impacts have taken this energy, J.
    fn lost_in_impacts(&mut self, energy: f64);

    /// Islands have fallen asleep, and the kinetic energy that was left in them, J, is gone.
    fn fell_asleep(&mut self, _energy: f64) {}

    /// A step begins.
    fn begins(&mut self) {}

    /// It has failed: whatever it has been told since the step began has not been.
    fn fails(&mut self) {}
}

impl<R: Real> Observer<R> for () {
    fn watches(&self) -> bool {
        false
    }
    fn advanced(&mut self, _view: &mut View<'_, R>, _dt: R) {}
    fn lost_in_impacts(&mut self, _energy: f64) {}
}
