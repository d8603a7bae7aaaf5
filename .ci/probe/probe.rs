//! What a program makes of the core, one function a question: `.ci/assembly` looks for their instructions.
#![no_std]

use hooke::{ExplicitEuler, Real, Reflect, StepError, World};

#[inline(always)]
fn roots<R: Real>(squares: &[R], roots: &mut [R]) {
    for (root, square) in roots.iter_mut().zip(squares) {
        *root = square.sqrt();
    }
}

/// A loop over roots in single precision.
#[inline(never)]
pub fn single_roots(squares: &[f32], out: &mut [f32]) {
    roots(squares, out);
}

/// A loop over roots in double precision.
#[inline(never)]
pub fn double_roots(squares: &[f64], out: &mut [f64]) {
    roots(squares, out);
}

/// A loop over roots in single precision, where the instruction set is chosen at run time.
///
/// # Safety
/// The machine has AVX2.
#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2")]
pub fn single_roots_avx2(squares: &[f32], out: &mut [f32]) {
    roots(squares, out);
}

/// A loop over roots in double precision, where the instruction set is chosen at run time.
///
/// # Safety
/// The machine has AVX2.
#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2")]
pub fn double_roots_avx2(squares: &[f64], out: &mut [f64]) {
    roots(squares, out);
}

/// A step in single precision: the roots of its springs' lengths.
///
/// # Errors
/// As [`World::step`].
#[inline(never)]
pub fn single_step(world: &mut World<f32, 8, 8, 1>) -> Result<(), StepError> {
    world.step(&mut ExplicitEuler, &mut Reflect, 1e-3).map(|_| ())
}
