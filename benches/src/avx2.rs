//! The textbook loop compiled for AVX2, so that it can be timed in one run with what every x86-64 can do.
//!
//! `-C target-cpu=native` on a machine with AVX-512 makes `Vec3` and `DVec3` 25 times slower, where stores through masks
//! are waited for, and leaves `Vec3A` as it is: AVX2 is the best there is for this loop.
#![allow(
    unsafe_code,
    reason = "calls into functions compiled for instructions that the machine has been found to have"
)]

use hooke::Lanes;

use crate::textbook::Textbook;
use crate::vector::Vector;

/// Steps with semi-implicit Euler, `time_step` in s, by AVX2 where there is.
pub fn step_semi_implicit_euler<V: Vector>(textbook: &mut Textbook<V>, time_step: V::Real) {
    #[cfg(target_arch = "x86_64")]
    if Lanes::widest() >= Lanes::Avx2 {
        // SAFETY: `widest` has found it.
        return unsafe { step(textbook, time_step) };
    }
    textbook.step_semi_implicit_euler(time_step);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn step<V: Vector>(textbook: &mut Textbook<V>, time_step: V::Real) {
    textbook.step_semi_implicit_euler(time_step);
}
