//! The matrix of an implicit step, kept spring by spring and never assembled.

use crate::Real;
use crate::vectors::{Columns, ColumnsMut, along, at, difference, dot, fetch, scaled, store};
use crate::world::System;

/// The springs linearised about a state: A = M + dt·C + dt²·K, made positive definite.
///
/// A spring with force density q = (k (l − l_rest) + k_d l̇)/l resists a relative velocity u of its ends with
/// (dt·k_d + dt²·k) d̂(d̂·u) + dt²·max(0, q) (u − d̂(d̂·u)). The second part is negative in a compressed spring, which
/// would rather buckle: there it is left out (Teran et al. 2005, *Robust quasistatic finite elements*), unless asked for.
pub struct Linearisation<'a, R> {
    /// d̂
    pub axis: ColumnsMut<'a, R>,
    /// kg
    pub along: &'a mut [R],
    /// kg
    pub across: &'a mut [R],
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

impl<R: Real> Linearisation<'_, R> {
    /// Linearises about a state whose force densities are known.
    pub fn about(&mut self, system: &System<'_, R>, position: Columns<'_, R>, force_density: &[R], dt: R, keep: Keep) {
        let springs = system.springs;
        let square = dt * dt;
        for (spring, (q, &[i, j])) in (0..).zip(force_density.iter().zip(springs.ends)) {
            let d = difference(fetch(position, j), fetch(position, i));
            let length = dot(d, d).sqrt();
            let (stiffness, rest_length) = (at(springs.stiffness, spring), at(springs.rest_length, spring));
            let rate = if keep == Keep::Stiffness { R::ZERO } else { at(springs.damping, spring) };
            let (axis, across) = if length > R::ZERO {
                (scaled(R::ONE / length, d), if keep == Keep::All { *q } else { q.at_least(R::ZERO) })
            } else {
                // Without a direction it resists all alike, if it would at this length at all.
                ([R::ZERO; 3], if rest_length > R::ZERO { R::ZERO } else { stiffness })
            };
            store(&mut self.axis, spring, axis);
            crate::vectors::put(self.along, spring, dt * rate + square * stiffness);
            crate::vectors::put(self.across, spring, square * across);
        }
    }

    /// A u for one slot, of which m u is given.
    #[inline(always)]
    pub fn row(&self, system: &System<'_, R>, u: Columns<'_, R>, slot: u32, inertia: [R; 3]) -> [R; 3] {
        let here = fetch(u, slot);
        system.springs.of_slot(slot).iter().fold(inertia, |sum, incidence| {
            let relative = difference(here, fetch(u, incidence.neighbour));
            let axis = fetch(crate::vectors::read(&self.axis), incidence.spring);
            let across = at(self.across, incidence.spring);
            let stretch = (at(self.along, incidence.spring) - across) * dot(axis, relative);
            along(along(sum, across, relative), stretch, axis)
        })
    }
}
