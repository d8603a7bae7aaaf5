//! Particles without springs on the path that a stepper takes them along.

use super::bounce::{Flight, Path};
use crate::Real;
use crate::carried::{Carried, zip};
use crate::contact::touching;
use crate::types::{Plane, StepReport};
use crate::vectors::{along, at, fetch, read, scaled, store};
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
        store(&mut next.position, slot, flight.position);
        store(&mut next.velocity, slot, flight.velocity);
        if R::IS_COMPENSATED {
            let is_free =
                |position| system.planes.iter().all(|plane: &Plane<R>| plane.gap(position) > touching(plane, position));
            let residuals = if bounces.hits == 0 && is_free(start.position) && is_free(flight.position) {
                let a = path.acceleration(&start);
                let drift = scaled(dt, along(start.velocity, curvature * dt, a));
                let position = carry(current.carried_position(), slot, drift);
                let velocity = carry(current.carried_velocity(), slot, scaled(dt, a));
                store(&mut next.position, slot, position.map(|(value, _)| value));
                store(&mut next.velocity, slot, velocity.map(|(value, _)| value));
                [position, velocity].map(|vector| vector.map(|(_, residual)| residual))
            } else {
                [[R::NO_RESIDUAL; 3]; 2]
            };
            let [position, velocity] = residuals;
            store(&mut next.position_residual, slot, position);
            store(&mut next.velocity_residual, slot, velocity);
        }
        report.hits = report.hits.saturating_add(bounces.hits);
        report.capped = report.capped.saturating_add(u32::from(bounces.capped));
        lost += at(system.mass, slot).to_f64() * bounces.lost;
    }
    lost
}

/// The sum of a slot's vector and an increment.
fn carry<R: Real>(from: Carried<'_, R>, slot: u32, increment: [R; 3]) -> [(R, R::Residual); 3] {
    zip(zip(fetch(from.value, slot), fetch(from.residual, slot)), increment)
        .map(|((value, residual), increment)| value.plus(residual, increment))
}
