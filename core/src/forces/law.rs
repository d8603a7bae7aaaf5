//! The law of a spring.

use super::tiles::SpringsOf;
use crate::Real;
use crate::compiled::HotLoops;
use crate::lanes::Present;
use crate::vectors::dot;
use crate::world::Law;

/// What the tension of a spring is made of.
pub trait Tension: Copy + Send {
    /// The same for springs that are not damped.
    type Undamped: Tension;
    /// Whether there is any in such a spring.
    const PULLS_UNDAMPED: bool;
    /// Whether it depends on velocities.
    const READS_VELOCITY: bool;

    /// The *force density* of a spring along d = x_j − x_i whose ends part at v = v_j − v_i, its tension over its length,
    /// N/m; and whether it has a direction.
    ///
    /// The force on particle i is then q d, and that on j its opposite. A spring of length 0 has no direction: its q is 0.
    /// (The name is Schek's, *The force density method*, 1974.)
    fn force_density<R: Real>(law: Law<R>, d: [R; 3], v: [R; 3]) -> (R, bool);
}

/// What can be asked of all springs.
pub trait Pull: Tension {
    /// Adds the forces of the springs that begin in a tile. Returns how many of them have length 0.
    fn pull<R: Real>(lanes: Present, springs: SpringsOf<'_, '_, '_, R, Self>) -> Option<u32>;
}

/// q = k (l − l_rest)/l
#[derive(Clone, Copy)]
pub struct Elastic;

impl Tension for Elastic {
    type Undamped = Self;
    const PULLS_UNDAMPED: bool = true;
    const READS_VELOCITY: bool = false;

    #[inline(always)]
    fn force_density<R: Real>(law: Law<R>, d: [R; 3], _v: [R; 3]) -> (R, bool) {
        let l = dot(d, d).sqrt();
        let inverse_length = R::ONE / l;
        directed(l, law.stiffness * (l - law.rest_length) * inverse_length)
    }
}

/// q = (k (l − l_rest) + k_d l̇)/l
#[derive(Clone, Copy)]
pub struct Damped;

impl Tension for Damped {
    type Undamped = Elastic;
    const PULLS_UNDAMPED: bool = true;
    const READS_VELOCITY: bool = true;

    #[inline(always)]
    fn force_density<R: Real>(law: Law<R>, d: [R; 3], v: [R; 3]) -> (R, bool) {
        let l = dot(d, d).sqrt();
        let inverse_length = R::ONE / l;
        let rate = dot(v, d) * inverse_length;
        let tension = law.stiffness * (l - law.rest_length) + law.damping * rate;
        directed(l, tension * inverse_length)
    }
}

impl Pull for Damped {
    fn pull<R: Real>(lanes: Present, springs: SpringsOf<'_, '_, '_, R, Self>) -> Option<u32> {
        R::Loops::pull(lanes, springs)
    }
}

/// q = k_d l̇/l, without a root: what damping makes of any vectors v, be they velocities or not.
#[derive(Clone, Copy)]
pub struct Damping;

impl Tension for Damping {
    type Undamped = Self;
    const PULLS_UNDAMPED: bool = false;
    const READS_VELOCITY: bool = true;

    #[inline(always)]
    fn force_density<R: Real>(law: Law<R>, d: [R; 3], v: [R; 3]) -> (R, bool) {
        let squared = dot(d, d);
        directed(squared, law.damping * dot(v, d) / squared)
    }
}

impl Pull for Damping {
    fn pull<R: Real>(lanes: Present, springs: SpringsOf<'_, '_, '_, R, Self>) -> Option<u32> {
        R::Loops::damp(lanes, springs)
    }
}

/// A force density where there is a length.
#[inline(always)]
fn directed<R: Real>(length: R, force_density: R) -> (R, bool) {
    let has_direction = length != R::ZERO;
    (if has_direction { force_density } else { R::ZERO }, has_direction)
}
