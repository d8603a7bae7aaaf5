//! Preconditioned conjugate gradients.

use super::preconditioner::Preconditioner;
use super::residual::norm;
use super::workspace::Scratch;
use crate::Real;
use crate::compiled::HotLoops;
use crate::contact::Support;
use crate::sums::sum;
use crate::vectors::{along, at, dot, scaled};
use crate::world::System;

/// What a solve came to.
#[derive(Clone, Copy, Debug, Default)]
pub struct Solved {
    /// Products with the matrix.
    pub iterations: u32,
    /// Whether the residual fell to the target.
    pub converged: bool,
    /// Whether a direction was met along which the matrix is not positive.
    pub indefinite: bool,
    /// What is left of it, √kg·m/s.
    pub residual: f64,
}

impl Solved {
    /// Whether there is nothing that another preconditioner could add.
    pub fn is_final(&self) -> bool {
        self.converged || self.indefinite
    }
}

impl<R: Real> Scratch<'_, R> {
    /// Sets out from 0 for the solution of A·direction = −residual over the particles that are neither held nor supported.
    pub fn set_out(&mut self, system: &System<'_, R>) {
        self.direction.as_flattened_mut().fill(R::ZERO);
        for (rest, residual) in self.spare.as_flattened_mut().iter_mut().zip(self.residual.as_flattened()) {
            *rest = -R::ONE * *residual;
        }
        confine(system, self.support, self.spare);
    }

    /// Goes on to a residual norm of `target`, in `most` iterations at most. (Hestenes and Stiefel 1952; with the planes'
    /// supports filtered out as in Baraff and Witkin 1998, §5.3.)
    pub fn go_on(&mut self, system: &System<'_, R>, preconditioner: Preconditioner, target: f64, most: u32) -> Solved {
        let count = system.plan.attached;
        let mut solved = Solved { residual: norm(system, self.spare), ..Solved::default() };
        let mut energy = R::ZERO;
        while solved.residual > target && solved.iterations < most {
            self.precondition(preconditioner);
            confine(system, self.support, self.product);
            let next = inner_product(count, self.spare, self.product);
            // In exact arithmetic the search directions are conjugate to each other.
            let ratio = if solved.iterations == 0 { R::ZERO } else { next / energy };
            for (search, preconditioned) in self.search.iter_mut().zip(self.product.iter()) {
                let first = solved.iterations == 0;
                *search = if first { *preconditioned } else { along(*preconditioned, ratio, *search) };
            }
            energy = next;
            for ((product, search), mass) in self.product.iter_mut().zip(self.search.iter()).zip(system.mass) {
                *product = scaled(*mass, *search);
            }
            R::Loops::multiply(self, system);
            confine(system, self.support, self.product);
            solved.iterations += 1;
            let curvature = inner_product(count, self.search, self.product);
            let length = energy / curvature;
            if !(length.is_finite() && length > R::ZERO) {
                solved.indefinite = true;
                break;
            }
            go_along(self.direction, length, self.search);
            go_along(self.spare, -length, self.product);
            solved.residual = norm(system, self.spare);
        }
        solved.converged = solved.residual <= target;
        solved
    }
}

/// a·b
#[inline(never)]
fn inner_product<R: Real>(count: u32, a: &[[R; 3]], b: &[[R; 3]]) -> R {
    sum(count, |slot| dot(at(a, slot), at(b, slot)))
}

/// a + s b, in place of a.
fn go_along<R: Real>(a: &mut [[R; 3]], s: R, b: &[[R; 3]]) {
    for (a, b) in a.as_flattened_mut().iter_mut().zip(b.as_flattened()) {
        *a += s * *b;
    }
}

/// Takes from a vector what is held or supported.
fn confine<R: Real>(system: &System<'_, R>, support: &[Support<R>], vector: &mut [[R; 3]]) {
    if system.plan.held > 0 {
        for (value, inverse_mass) in vector.iter_mut().zip(system.inverse_mass) {
            if *inverse_mass == R::ZERO {
                *value = const { [R::ZERO; 3] };
            }
        }
    }
    if system.support.is_some() {
        for (value, support) in vector.iter_mut().zip(support) {
            *value = support.allow(*value);
        }
    }
}
