//! A step in as many parts as the stepper takes it in.

use crate::Real;
use crate::roles::{Observer, Stepper};
use crate::types::{StepError, StepReport};
use crate::world::View;

/// Advances a whole step, the last part of it to the next state.
pub fn advance_in_parts<R: Real>(
    view: &mut View<'_, R>,
    stepper: &mut (impl Stepper<R> + ?Sized),
    dt: R,
    observer: &mut impl Observer<R>,
) -> Result<StepReport, StepError> {
    let mut report = StepReport::default();
    // In `f64`, as thousands of parts add up in no other.
    let mut left = dt.to_f64();
    loop {
        let rest = R::from_f64(left);
        let part = stepper.advance_up_to(view, rest, &mut report);
        view.refuse_non_finite()?;
        observer.advanced_by(view, part, stepper);
        // The first half is known where a program is compiled: what parts take is then left out.
        if !stepper.chooses_parts() || part >= rest {
            report.substeps = 1;
            return Ok(report);
        }
        view.commit(view.clock.later(part.to_f64()), false);
        left -= part.to_f64();
    }
}
