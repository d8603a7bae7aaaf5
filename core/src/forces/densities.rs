//! The first pass: one scalar a spring.

use crate::Real;
use crate::vectors::{Columns, difference, dot, fetch};
use crate::world::Springs;

/// The *force density* of each spring, its tension over its length: q = (k (l − l_rest) + k_d l̇)/l, N/m.
///
/// The force on particle i is then q d with d = x_j − x_i, and that on j its opposite. A spring of length 0 has no
/// direction: its q is 0. Returns how many there are of those. (The name is Schek's, *The force density method*,
/// 1974.)
pub fn force_densities<R: Real, const DAMPED: bool>(
    springs: Springs<'_, R>,
    position: Columns<'_, R>,
    velocity: Columns<'_, R>,
    force_density: &mut [R],
) -> u32 {
    let Springs { ends, stiffness, damping, rest_length, .. } = springs;
    let parameters = stiffness.iter().zip(damping).zip(rest_length);
    let mut degenerate = 0;
    for ((q, &[i, j]), ((&k, &k_d), &l_rest)) in force_density.iter_mut().zip(ends).zip(parameters) {
        let d = difference(fetch(position, j), fetch(position, i));
        let l = dot(d, d).sqrt();
        let inverse_length = R::ONE / l;
        let mut tension = k * (l - l_rest);
        if DAMPED {
            let v = difference(fetch(velocity, j), fetch(velocity, i));
            let rate = dot(v, d) * inverse_length;
            tension += k_d * rate;
        }
        let has_direction = l != R::ZERO;
        *q = if has_direction { tension * inverse_length } else { R::ZERO };
        degenerate += u32::from(!has_direction);
    }
    degenerate
}
