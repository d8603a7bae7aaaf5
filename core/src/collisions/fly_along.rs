//! Particles without springs on the path that a stepper takes them along.

use super::bounce::{Flight, Path};
use crate::Real;
use crate::contact::touching;
use crate::types::{Plane, StepReport};
use crate::vectors::{along, at, fetch, read, scaled};
use crate::world::View;

/// Flies the particles without springs through a whole step, along the stepper's path. Returns the energy lost, J.
pub fn fly_along<R: Real>(view: &mut View<'_, R>, curvature: R, dt: R, report: &mut StepReport) -> f64 {
    let View { system, current, next, .. } = view;
    let mut lost = 0.0;
    for slot in system.plan.attached..system.plan.particles {
        let start =
            Flight { position: fetch(read(&current.position), slot), velocity: fetch(read(&current.velocity), slot) };
        let mut flight = start;
        let path = Path::of(system, slot, curvature);
        let bounces = path.fly(&mut flight, dt);
        let is_free =
            |position| system.planes.iter().all(|plane: &Plane<R>| plane.gap(position) > touching(plane, position));
        let [mut position, mut velocity] = next.lend().apart();
        if R::IS_COMPENSATED && bounces.hits == 0 && is_free(start.position) && is_free(flight.position) {
            // The same with its rounding kept.
            let a = path.acceleration(&start);
            let drift = scaled(dt, along(start.velocity, curvature * dt, a));
            position.store(slot, current.carried_position().plus(slot, drift));
            velocity.store(slot, current.carried_velocity().plus(slot, scaled(dt, a)));
        } else {
            position.store(slot, flight.position.map(|component| (component, R::NO_RESIDUAL)));
            velocity.store(slot, flight.velocity.map(|component| (component, R::NO_RESIDUAL)));
        }
        report.hits = report.hits.saturating_add(bounces.hits);
        report.capped = report.capped.saturating_add(u32::from(bounces.capped));
        lost += at(system.mass, slot).to_f64() * bounces.lost;
    }
    lost
}
