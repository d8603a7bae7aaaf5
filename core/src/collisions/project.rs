//! The response that also puts particles back on the plane.

use super::parts::advance_in_parts;
use super::reflect::{answer, finish};
use crate::Real;
use crate::forces::energy;
use crate::roles::{Observer, Response, Stepper};
use crate::types::{StepError, StepReport};
use crate::world::View;

/// Like [`super::Reflect`], and a particle that is answered is moved along the normal to n·x = offset.
///
/// Of first order in the time step. Lifting a particle changes its potential energy, and that of its springs; the
/// ledger counts it with the impact.
#[derive(Clone, Copy, Debug, Default)]
pub struct Project;

impl<R: Real> Response<R> for Project {
    fn step(
        &mut self,
        view: &mut View<'_, R>,
        stepper: &mut (impl Stepper<R> + ?Sized),
        dt: R,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        let mut report = advance_in_parts(view, stepper, dt, observer)?;
        let watched = observer.watches() && view.system.plan.planes > 0;
        let potential = |view: &View<'_, R>| energy::potential(&view.system, &view.next);
        let before = if watched { potential(view) } else { 0.0 };
        let mut answer = answer(&view.system, &mut view.next, watched, true);
        if watched && answer.hits > 0 {
            answer.lost += before - potential(view);
        }
        finish(view, &mut report, &answer, observer)?;
        Ok(report)
    }
}
