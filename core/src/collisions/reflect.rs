//! The response that turns velocities round and leaves positions.

use core::ops::Range;

use super::parts::advance_in_parts;
use crate::Real;
use crate::lanes::{self, Kernel, Set};
use crate::reach::Reach;
use crate::roles::{Observer, Response, Stepper};
use crate::types::{Plane, StepError, StepReport};
use crate::vectors::{Columns, along, at, dot, fetch, read, triples, window};
use crate::world::{State, System, TILE, View, stretches};

/// Particles that are looked at together for whether a plane is in reach: enough that it costs next to nothing.
const STRETCH: u32 = 4 * TILE;

/// Once, after the positions are updated, planes in file order: a particle with n·x < offset and n·v < 0 gets −e times
/// its normal velocity. It stays where it is.
///
/// Of first order in the time step, and a particle at rest sinks: each step's fall is answered only afterwards.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reflect;

impl<R: Real> Response<R> for Reflect {
    fn step(
        &mut self,
        view: &mut View<'_, R>,
        stepper: &mut (impl Stepper<R> + ?Sized),
        dt: R,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        let mut report = advance_in_parts(view, stepper, dt, observer)?;
        let answer = answer(&view.system, &mut view.next, observer.watches(), false);
        finish(view, &mut report, &answer, observer)?;
        Ok(report)
    }
}

/// What a response did at the end of a step.
#[derive(Clone, Copy, Debug, Default)]
pub struct Answer {
    /// Bounces.
    pub hits: u32,
    /// Kinetic energy lost in them, J.
    pub lost: f64,
    /// Whether a particle may have been so fast or so far that what it was given is not finite.
    pub overflows: bool,
}

/// Reflects every particle that satisfies the condition of a plane, and puts it on the plane if it is to be projected. The
/// energy that is lost is counted if it is `watched`.
pub fn answer<R: Real>(
    system: &System<'_, R>,
    state: &mut State<'_, R>,
    is_watched: bool,
    is_projected: bool,
) -> Answer {
    let mut answer = Answer::default();
    if system.planes.is_empty() {
        return answer;
    }
    if cfg!(feature = "small") {
        // Whoever is beyond a plane is found one by one.
        let mut start = 0;
        while start < system.plan.particles {
            let slots = start..start.saturating_add(STRETCH).min(system.plan.particles);
            start = slots.end;
            for plane in system.planes {
                answer_tile(system, state, plane, slots.clone(), [is_watched, is_projected], &mut answer);
            }
        }
        return answer;
    }
    for slots in stretches(0..system.plan.particles, STRETCH) {
        let reach = Reach::at(system.lanes, read(&state.position), slots.clone());
        let before = answer.hits;
        for plane in system.planes {
            // What has been hit may have been displaced, and the box is then no longer its own.
            let may_meet = answer.hits > before || reach.may_meet(plane);
            if may_meet
                && lanes::run(system.lanes, AnyBeyond { plane, position: window(read(&state.position), slots.clone()) })
            {
                answer_tile(system, state, plane, slots.clone(), [is_watched, is_projected], &mut answer);
            }
        }
    }
    answer
}

/// Whether any particle is beyond a plane: few are, and those that are not need not be looked at one by one.
struct AnyBeyond<'a, R: Real> {
    plane: &'a Plane<R>,
    position: Columns<'a, R>,
}

impl<R: Real> Kernel for AnyBeyond<'_, R> {
    type Output = bool;

    #[inline(always)]
    fn run(self, _set: impl Set) -> bool {
        let beyond = triples(self.position).map(|position| u32::from(self.plane.gap(position) < R::ZERO));
        beyond.fold(0, |any, beyond| any | beyond) != 0
    }
}

fn answer_tile<R: Real>(
    system: &System<'_, R>,
    state: &mut State<'_, R>,
    plane: &Plane<R>,
    slots: Range<u32>,
    [is_watched, is_projected]: [bool; 2],
    answer: &mut Answer,
) {
    for slot in slots {
        let position = fetch(read(&state.position), slot);
        let gap = plane.gap(position);
        if gap >= R::ZERO || !system.is_dynamic(slot) {
            continue;
        }
        let velocity = fetch(read(&state.velocity), slot);
        let speed = dot(plane.normal, velocity);
        if speed < R::ZERO {
            let change = -(R::ONE + plane.restitution) * speed;
            let velocity = along(velocity, change, plane.normal);
            let position = if is_projected { along(position, -gap, plane.normal) } else { position };
            state.put_velocity(slot, velocity);
            state.put_position(slot, position);
            // A sum is not finite if one of them is not; if it alone is not, whoever looks finds that all of them are.
            let ([x, y, z], [u, v, w]) = (position, velocity);
            answer.overflows |= !(x + y + z + u + v + w).is_finite();
            answer.hits += 1;
            if is_watched {
                let (before, after) = (speed.to_f64(), (plane.restitution * speed).to_f64());
                answer.lost += 0.5 * at(system.mass, slot).to_f64() * (before * before - after * after);
            }
        }
    }
}

/// Makes the next state, in which collisions have been answered, the current one.
pub(crate) fn finish<R: Real>(
    view: &mut View<'_, R>,
    report: &mut StepReport,
    answer: &Answer,
    observer: &mut impl Observer<R>,
) -> Result<(), StepError> {
    if answer.overflows {
        view.is_next_finite = false;
        view.refuse_non_finite()?;
    }
    report.hits += answer.hits;
    if answer.hits > 0 {
        observer.lost_in_impacts(answer.lost);
    }
    view.commit(view.end, answer.hits > 0);
    Ok(())
}
