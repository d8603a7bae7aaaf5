//! Preconditioned conjugate gradients.

use super::linearised::Linearisation;
use super::preconditioner::{apply, invert_blocks};
use super::residual::norm;
use super::workspace::Scratch;
use crate::Real;
use crate::sums::sum;
use crate::vectors::{along, at, dot, fetch, read, scaled, store};
use crate::world::System;

/// What a solve came to.
#[derive(Clone, Copy, Debug)]
pub struct Solved {
    /// Products with the matrix.
    pub iterations: u32,
    /// Whether the residual fell to the target.
    pub converged: bool,
    /// What is left of it, √kg·m/s.
    pub residual: f64,
    /// −residual·direction at the start: how steeply the direction leads down, kg·m²/s².
    pub descent: f64,
}

/// Solves A·direction = −residual to a residual norm of `target`, over the particles that are neither held nor
/// supported; the residual is used up. (Hestenes and Stiefel 1952; with the planes' supports filtered out as in Baraff
/// and Witkin 1998, §5.3.)
pub fn conjugate_gradients<R: Real>(system: &System<'_, R>, scratch: &mut Scratch<'_, R>, target: f64) -> Solved {
    let Scratch { direction, residual, search, product, preconditioner, support, axis, along: stretch, across, .. } =
        scratch;
    let matrix = Linearisation { axis: crate::vectors::lend(axis), along: stretch, across };
    let count = system.plan.attached;
    let free = |slot: u32, vector: [R; 3]| {
        if system.is_dynamic(slot) { at(support, slot).allow(vector) } else { [R::ZERO; 3] }
    };
    invert_blocks(system, &matrix, preconditioner);
    for slot in 0..count {
        let r = scaled(-R::ONE, free(slot, fetch(read(residual), slot)));
        store(residual, slot, r);
        store(search, slot, free(slot, apply(preconditioner, slot, r)));
        store(direction, slot, [R::ZERO; 3]);
    }
    let mut energy = sum(count, |slot| dot(fetch(read(residual), slot), fetch(read(search), slot)));
    let mut solved = Solved { iterations: 0, converged: false, residual: norm(system, read(residual)), descent: 0.0 };
    while solved.residual > target && solved.iterations < most_iterations(count) {
        solved.iterations += 1;
        for slot in 0..count {
            let inertia = scaled(at(system.mass, slot), fetch(read(search), slot));
            let row = free(slot, matrix.row(system, read(search), slot, inertia));
            store(product, slot, row);
        }
        let curvature = sum(count, |slot| dot(fetch(read(search), slot), fetch(read(product), slot)));
        let length = energy / curvature;
        if !(length.is_finite() && length > R::ZERO) {
            break;
        }
        // In exact arithmetic the search directions are conjugate, so each adds its own part.
        solved.descent += (length * energy).to_f64();
        for slot in 0..count {
            let (p, a) = (fetch(read(search), slot), fetch(read(product), slot));
            store(direction, slot, along(fetch(read(direction), slot), length, p));
            store(residual, slot, along(fetch(read(residual), slot), -length, a));
        }
        let preconditioned = |slot: u32| free(slot, apply(preconditioner, slot, fetch(read(residual), slot)));
        let next = sum(count, |slot| dot(fetch(read(residual), slot), preconditioned(slot)));
        let ratio = next / energy;
        for slot in 0..count {
            store(search, slot, along(preconditioned(slot), ratio, fetch(read(search), slot)));
        }
        energy = next;
        solved.residual = norm(system, read(residual));
    }
    solved.converged = solved.residual <= target;
    solved
}

/// In exact arithmetic there are as many iterations as unknowns at most; rounding may double them.
fn most_iterations(particles: u32) -> u32 {
    particles.saturating_mul(6).clamp(50, 20_000)
}
