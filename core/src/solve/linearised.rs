//! The matrix of an implicit step, kept spring by spring: the springs linearised about a state, A = M + dt·C + dt²·K, made
//! positive definite.
//!
//! A spring with force density q = (k (l − l_rest) + k_d l̇)/l resists a relative velocity u of its ends with
//! (dt·k_d + dt²·k) d̂(d̂·u) + dt²·max(0, q) (u − d̂(d̂·u)). The second part is negative in a compressed spring, which
//! would rather buckle: there it is left out (Teran et al. 2005, *Robust quasistatic finite elements*), unless asked for.

use super::workspace::Scratch;
use crate::Real;
use crate::vectors::{along, at, difference, dot, is_zero, scaled};
use crate::world::System;

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

impl<R: Real> Scratch<'_, R> {
    /// Linearises about the state that the springs were evaluated in.
    pub fn linearise(&mut self, system: &System<'_, R>, dt: R, keep: Keep) {
        let springs = system.springs;
        let square = dt * dt;
        let parameters = springs.stiffness.iter().zip(springs.damping).zip(springs.rest_length);
        let evaluated = self.axis.iter().zip(self.force_density.iter());
        let resistances = self.resistance.iter_mut();
        for ((resistance, (axis, q)), ((k, k_d), rest_length)) in resistances.zip(evaluated).zip(parameters) {
            let rate = if keep == Keep::Stiffness { R::ZERO } else { *k_d };
            let across = if is_zero(*axis) {
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

    /// Adds A − M times the search direction to the product. Slots that are held get what the springs pull at them with.
    pub fn add_product(&mut self, system: &System<'_, R>) {
        let springs = system.springs.ends.iter().zip(self.axis.iter().zip(self.resistance.iter()));
        for (&[i, j], (axis, &[stretch, across])) in springs {
            let relative = difference(at(self.search, i), at(self.search, j));
            let pull = along(scaled(across, relative), stretch * dot(*axis, relative), *axis);
            if let Some(product) = self.product.get_mut(i as usize) {
                *product = along(*product, R::ONE, pull);
            }
            if let Some(product) = self.product.get_mut(j as usize) {
                *product = along(*product, -R::ONE, pull);
            }
        }
    }
}
