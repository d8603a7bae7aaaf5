//! The end of a step that hits have cut too often: what would go on is stopped on the planes it has come to.

use super::bounce::half_square;
use super::reflect::Answer;
use crate::Real;
use crate::contact::{resting, touching};
use crate::forces::energy::potential;
use crate::vectors::{along, at, dot, fetch, read};
use crate::world::View;

/// Times that the planes are gone through: what one puts right, another may put wrong in the corner between them.
const MOST_ROUNDS: u32 = 16;

/// Puts every particle of the next state that has gone through a plane since the current one back on it, and takes
/// from it the velocity with which it goes further. Where the energies that this changes are `watched`, they count.
///
/// What cannot be put right so, in a sharp corner, goes nowhere: it stays where it was, at rest.
/// A particle that was beyond a plane before is not moved by it, but goes no deeper either.
pub fn stop_all<R: Real>(view: &mut View<'_, R>, watched: bool) -> Answer {
    let energy = |view: &View<'_, R>| if watched { potential(&view.system, &view.next) } else { 0.0 };
    let before = energy(view);
    let mut answer = Answer::default();
    for round in 0..MOST_ROUNDS {
        let stopped = stop_once(view, &mut answer, round + 1 == MOST_ROUNDS);
        if stopped == 0 {
            break;
        }
        answer.hits = answer.hits.saturating_add(stopped);
    }
    answer.lost += before - energy(view);
    answer
}

/// Once through all planes, `finally` or not. Returns how many particles it has stopped, and adds up the kinetic energy taken.
fn stop_once<R: Real>(view: &mut View<'_, R>, answer: &mut Answer, finally: bool) -> u32 {
    let View { system, current, next, .. } = view;
    let mut stopped = 0;
    for plane in system.planes {
        for slot in (0..system.plan.attached).filter(|slot| system.is_dynamic(*slot)) {
            let (position, velocity) = (fetch(read(&next.position), slot), fetch(read(&next.velocity), slot));
            let (gap, speed) = (plane.gap(position), dot(plane.normal, velocity));
            let depth = plane.gap(fetch(read(&current.position), slot)).at_most(R::ZERO) - gap;
            let sinks = depth > touching(plane, position);
            let falls = gap < R::ZERO && speed < -resting(velocity);
            if finally && sinks {
                answer.lost += at(system.mass, slot).to_f64() * half_square(dot(velocity, velocity).sqrt());
                next.put_position(slot, fetch(read(&current.position), slot));
                next.put_velocity(slot, [R::ZERO; 3]);
                stopped += 1;
                continue;
            }
            if sinks {
                next.put_position(slot, along(position, depth, plane.normal));
            }
            if falls {
                next.put_velocity(slot, along(velocity, -speed, plane.normal));
                answer.lost += at(system.mass, slot).to_f64() * half_square(speed);
            }
            stopped += u32::from(sinks || falls);
        }
    }
    stopped
}
