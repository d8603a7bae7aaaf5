//! Preconditioned conjugate gradients.

use super::linearised::Linearisation;
use super::preconditioner::Preconditioner;
use super::residual::norm;
use crate::Real;
use crate::contact::Support;
use crate::sums::sum;
use crate::vectors::{along, at, dot, scaled};
use crate::world::System;

/// A linear system on its way to its solution, by slot.
pub struct Unknowns<'a, R> {
    /// The solution so far.
    pub direction: &'a mut [[R; 3]],
    /// What is left of the right-hand side.
    pub rest: &'a mut [[R; 3]],
    /// The search direction.
    pub search: &'a mut [[R; 3]],
    /// The matrix times that, and then what the preconditioner makes of the rest.
    pub product: &'a mut [[R; 3]],
}

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

/// Sets out from 0 for the solution of A·direction = −residual over the particles that are neither held nor supported.
pub fn set_out<R: Real>(
    system: &System<'_, R>,
    support: &[Support<R>],
    residual: &[[R; 3]],
    unknowns: &mut Unknowns<'_, R>,
) {
    unknowns.direction.fill([R::ZERO; 3]);
    for (rest, residual) in unknowns.rest.as_flattened_mut().iter_mut().zip(residual.as_flattened()) {
        *rest = -R::ONE * *residual;
    }
    confine(system, support, unknowns.rest);
}

/// Goes on to a residual norm of `target`, in `most` iterations at most. (Hestenes and Stiefel 1952; with the planes'
/// supports filtered out as in Baraff and Witkin 1998, §5.3.)
pub fn conjugate_gradients<R: Real>(
    system: &System<'_, R>,
    matrix: &Linearisation<'_, R>,
    support: &[Support<R>],
    preconditioner: &mut Preconditioner<'_, '_, R>,
    unknowns: &mut Unknowns<'_, R>,
    target: f64,
    most: u32,
) -> Solved {
    let Unknowns { direction, rest, search, product } = unknowns;
    let count = system.plan.attached;
    let mut solved = Solved { residual: norm(system, rest), ..Solved::default() };
    let mut energy = R::ZERO;
    while solved.residual > target && solved.iterations < most {
        preconditioner.apply(rest, product);
        confine(system, support, product);
        let next = inner_product(count, rest, product);
        // In exact arithmetic the search directions are conjugate to each other.
        let ratio = if solved.iterations == 0 { R::ZERO } else { next / energy };
        for (search, preconditioned) in search.iter_mut().zip(product.iter()) {
            *search = if solved.iterations == 0 { *preconditioned } else { along(*preconditioned, ratio, *search) };
        }
        energy = next;
        for ((product, search), mass) in product.iter_mut().zip(search.iter()).zip(system.mass) {
            *product = scaled(*mass, *search);
        }
        matrix.add_product(system, search, product);
        confine(system, support, product);
        solved.iterations += 1;
        let curvature = inner_product(count, search, product);
        let length = energy / curvature;
        if !(length.is_finite() && length > R::ZERO) {
            solved.indefinite = true;
            break;
        }
        go_along(direction, length, search);
        go_along(rest, -length, product);
        solved.residual = norm(system, rest);
    }
    solved.converged = solved.residual <= target;
    solved
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
                *value = [R::ZERO; 3];
            }
        }
    }
    if system.support.is_some() {
        for (value, support) in vector.iter_mut().zip(support) {
            *value = support.allow(*value);
        }
    }
}
