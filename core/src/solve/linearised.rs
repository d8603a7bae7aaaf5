//! The matrix of an implicit step, kept spring by spring.

use super::evaluate::Evaluated;
use crate::Real;
use crate::vectors::{along, at, difference, dot, put, scaled};
use crate::world::System;

/// The springs linearised about a state: A = M + dt·C + dt²·K, made positive definite.
///
/// A spring with force density q = (k (l − l_rest) + k_d l̇)/l resists a relative velocity u of its ends with
/// (dt·k_d + dt²·k) d̂(d̂·u) + dt²·max(0, q) (u − d̂(d̂·u)). The second part is negative in a compressed spring, which
/// would rather buckle: there it is left out (Teran et al. 2005, *Robust quasistatic finite elements*), unless asked for.
pub struct Linearisation<'a, R> {
    /// d̂
    pub axis: &'a [[R; 3]],
    /// What a spring resists with along d̂ more than across it, and across it, kg.
    pub resistance: &'a [[R; 2]],
}

/// What of the springs' resistance a linearisation keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// dt²·K, made positive definite.
    Stiffness,
    /// dt·C + dt²·K, made positive definite.
    Definite,
    /// dt·C + dt²·K as it is. It may lead nowhere, but near a solution it is usually definite too, and leads there faster.
    All,
}

/// Linearises about the state that the springs were evaluated in.
pub fn linearise<R: Real>(
    system: &System<'_, R>,
    evaluated: &Evaluated<'_, R>,
    resistance: &mut [[R; 2]],
    dt: R,
    keep: Keep,
) {
    let springs = system.springs;
    let square = dt * dt;
    let parameters = springs.stiffness.iter().zip(springs.damping).zip(springs.rest_length);
    let evaluated = evaluated.axis.iter().zip(evaluated.force_density.iter());
    for ((resistance, (axis, q)), ((k, k_d), rest_length)) in resistance.iter_mut().zip(evaluated).zip(parameters) {
        let rate = if keep == Keep::Stiffness { R::ZERO } else { *k_d };
        let across = if *axis == [R::ZERO; 3] {
            // Without a direction it resists all alike, if it would at this length at all.
            if *rest_length > R::ZERO { R::ZERO } else { *k }
        } else if keep == Keep::All {
            *q
        } else {
            q.at_least(R::ZERO)
        };
        let across = square * across;
        *resistance = [dt * rate + square * *k - across, across];
    }
}

impl<R: Real> Linearisation<'_, R> {
    /// Adds (A − M) u to `out`. Slots that are held get what the springs pull at them with.
    pub fn add_product(&self, system: &System<'_, R>, u: &[[R; 3]], out: &mut [[R; 3]]) {
        let springs = system.springs.ends.iter().zip(self.axis.iter().zip(self.resistance));
        for (&[i, j], (axis, &[stretch, across])) in springs {
            let relative = difference(at(u, i), at(u, j));
            let pull = along(scaled(across, relative), stretch * dot(*axis, relative), *axis);
            put(out, i, along(at(out, i), R::ONE, pull));
            put(out, j, along(at(out, j), -R::ONE, pull));
        }
    }
}
