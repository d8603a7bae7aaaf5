//! When a particle meets a plane on the path of a stepper of high order.

use crate::Real;
use crate::contact::touching;
use crate::roles::Stepper;
use crate::types::{Plane, StepReport};
use crate::vectors::{dot, fetch, read};
use crate::world::View;

/// Steps that are spent on finding one hit: each squares what is missing.
const MOST_STEPS: u32 = 8;

/// The time after which a particle meets a plane, by Newton's method: steps of that length, each corrected by the gap that
/// is left over the speed at its end. `guess` is where the parabola between the two states of a whole step has it.
///
/// The path of the stepper itself is as exact as it is: no interpolation is. Nothing if it turns round before it gets
/// there. A path that dips beyond a plane and is back within one step is not noticed.
pub fn locate<R: Real>(
    view: &mut View<'_, R>,
    stepper: &mut (impl Stepper<R> + ?Sized),
    slot: u32,
    plane: &Plane<R>,
    guess: R,
    rest: R,
    report: &mut StepReport,
) -> Option<R> {
    let mut tau = guess;
    for _ in 0..MOST_STEPS {
        let mut attached = view.attached();
        report.add(&stepper.advance(&mut attached, tau));
        let position = fetch(read(&attached.next.position), slot);
        let speed = dot(plane.normal, fetch(read(&attached.next.velocity), slot));
        let gap = plane.gap(position);
        if gap.abs() <= touching(plane, position) {
            return Some(tau);
        }
        let next = tau - gap / speed;
        // Not a number is no time either.
        if !(speed < R::ZERO && next > R::ZERO && next < rest) {
            return None;
        }
        tau = next;
    }
    Some(tau)
}
