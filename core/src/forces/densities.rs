//! One scalar a spring, for those who need it more than once.

use super::law::force_density;
use crate::Real;
use crate::vectors::{Columns, difference, fetch};
use crate::world::Springs;

/// The force density of each spring, N/m. Returns how many springs have length 0.
pub fn force_densities<R: Real, const DAMPED: bool>(
    springs: Springs<'_, R>,
    position: Columns<'_, R>,
    velocity: Columns<'_, R>,
    force_density_of: &mut [R],
) -> u32 {
    let mut degenerate = 0;
    for ((q, &[i, j]), spring) in force_density_of.iter_mut().zip(springs.ends).zip(0..) {
        let d = difference(fetch(position, j), fetch(position, i));
        let v = if DAMPED { difference(fetch(velocity, j), fetch(velocity, i)) } else { [R::ZERO; 3] };
        let (density, has_direction) = force_density::<R, DAMPED>(springs.law(spring), d, v);
        *q = density;
        degenerate += u32::from(!has_direction);
    }
    degenerate
}
