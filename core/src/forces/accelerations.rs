//! The second pass: one sum a particle.

use crate::Real;
use crate::vectors::{Columns, ColumnsMut, along, at, difference, fetch, read, store};
use crate::world::{Incidence, System};

/// a = g, or 0 where pinned or kinematic.
pub fn set_gravity<R: Real>(system: &System<'_, R>, out: ColumnsMut<'_, R>) {
    for (column, g) in out.into_iter().zip(system.gravity) {
        for (a, w) in column.iter_mut().zip(system.inverse_mass) {
            *a = if *w == R::ZERO { R::ZERO } else { g };
        }
    }
}

/// a += f/m of the springs, for every particle that has some.
pub fn add_springs<R: Real>(
    system: &System<'_, R>,
    position: Columns<'_, R>,
    force_density: &[R],
    mut out: ColumnsMut<'_, R>,
) {
    for (slot, incidences) in system.springs.by_slot(system.plan.attached) {
        let inverse_mass = at(system.inverse_mass, slot);
        if inverse_mass == R::ZERO {
            // Held, whatever pulls: 0 times an infinite force would not be 0.
            continue;
        }
        let force = net_force(position, force_density, slot, incidences);
        let acceleration = along(fetch(read(&out), slot), inverse_mass, force);
        store(&mut out, slot, acceleration);
    }
}

/// Σ q (x_j − x_i) over the springs of a particle, in the order of their numbers, N.
#[inline(always)]
pub fn net_force<R: Real>(
    position: Columns<'_, R>,
    force_density: &[R],
    slot: u32,
    incidences: &[Incidence],
) -> [R; 3] {
    let here = fetch(position, slot);
    incidences.iter().fold([R::ZERO; 3], |force, incidence| {
        let d = difference(fetch(position, incidence.neighbour), here);
        along(force, at(force_density, incidence.spring), d)
    })
}
