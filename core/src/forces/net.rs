//! What the springs of a single particle pull it with.

use super::law::{Damped, Tension};
use crate::Real;
use crate::vectors::{Columns, along, difference, fetch};
use crate::world::System;

/// Σ q (x_j − x_i) over the springs of a particle, N.
pub fn pull<R: Real>(system: &System<'_, R>, position: Columns<'_, R>, velocity: Columns<'_, R>, slot: u32) -> [R; 3] {
    let (here, v) = (fetch(position, slot), fetch(velocity, slot));
    system.springs.of_slot(slot).iter().fold([R::ZERO; 3], |force, incidence| {
        let d = difference(fetch(position, incidence.neighbour), here);
        let rate = difference(fetch(velocity, incidence.neighbour), v);
        let (q, _) = Damped::force_density(system.springs.law(incidence.spring), d, rate);
        along(force, q, d)
    })
}
