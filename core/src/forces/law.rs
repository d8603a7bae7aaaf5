//! The law of a spring.

use crate::Real;
use crate::vectors::dot;
use crate::world::Law;

/// The *force density* of a spring along d = x_j − x_i whose ends part at v = v_j − v_i, its tension over its length:
/// q = (k (l − l_rest) + k_d l̇)/l, N/m; and whether it has a direction.
///
/// The force on particle i is then q d, and that on j its opposite. A spring of length 0 has no direction: its q is 0.
/// (The name is Schek's, *The force density method*, 1974.)
#[inline(always)]
pub fn force_density<R: Real, const DAMPED: bool>(law: Law<R>, d: [R; 3], v: [R; 3]) -> (R, bool) {
    let l = dot(d, d).sqrt();
    let inverse_length = R::ONE / l;
    let mut tension = law.stiffness * (l - law.rest_length);
    if DAMPED {
        let rate = dot(v, d) * inverse_length;
        tension += law.damping * rate;
    }
    let has_direction = l != R::ZERO;
    (if has_direction { tension * inverse_length } else { R::ZERO }, has_direction)
}
