//! The textbook loop compiled for the vector instructions of this machine, as `-C target-cpu=native` compiles it, so that
//! both can be timed in one run.
#![allow(
    unsafe_code,
    reason = "calls into functions compiled for instructions that the machine has been found to have"
)]

use hooke::Lanes;

use crate::textbook::Textbook;
use crate::vector::Vector;

/// Steps with semi-implicit Euler, `time_step` in s, on the widest vectors that there are.
pub fn step_semi_implicit_euler<V: Vector>(textbook: &mut Textbook<V>, time_step: V::Real) {
    #[cfg(target_arch = "x86_64")]
    match Lanes::widest() {
        // SAFETY: `widest` has found the instructions that the function is compiled for.
        Lanes::Avx512 => return unsafe { avx512(textbook, time_step) },
        // SAFETY: likewise.
        Lanes::Avx2 => return unsafe { avx2(textbook, time_step) },
        Lanes::Baseline => {}
    }
    textbook.step_semi_implicit_euler(time_step);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<V: Vector>(textbook: &mut Textbook<V>, time_step: V::Real) {
    textbook.step_semi_implicit_euler(time_step);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn avx512<V: Vector>(textbook: &mut Textbook<V>, time_step: V::Real) {
    textbook.step_semi_implicit_euler(time_step);
}
