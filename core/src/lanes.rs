//! Vector instructions: a kernel's body is written once, compiled for each set of them, and the widest that the
//! machine has is chosen when it runs.
//!
//! The bodies are plain loops over slices that the compiler vectorises. That leaves the language's own rounding rules
//! in force, so every set gives the same bits without a line that sees to it. Compared on the hot loop, `f32`, in ns a
//! spring (`cargo bench -p hooke-benches --bench lanes`, AMD EPYC): plain loops 1.0, intrinsics 1.0 and `pulp` 1.1 with
//! AVX2; plain loops 2.2 and `wide`, which has only the instructions of the whole program, 1.8 with SSE2.
#![allow(
    unsafe_code,
    reason = "calls into functions compiled for instructions that the machine has been found to have"
)]

mod transpose;

pub use transpose::{Rows, Set};

#[cfg(all(target_arch = "x86_64", feature = "std"))]
use transpose::Avx;
use transpose::Whole;

/// A set of vector instructions, narrowest first; none of them shows in the bits. A world steps with the widest that there is; this is how to ask for
/// less, to compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Lanes {
    /// What the whole program has been compiled for: SSE2 on x86-64 unless it was told more.
    Baseline,
    /// 256 bits: eight `f32` or four `f64`.
    Avx2,
    /// 512 bits: sixteen `f32` or eight `f64`.
    Avx512,
}

impl Lanes {
    /// The widest of those that any machine is found to have. Without the feature `std` none is looked for.
    pub(crate) const MOST: Self = if cfg!(feature = "std") { Self::Avx512 } else { Self::Baseline };

    /// The widest set that this machine has, of those that are chosen when the program runs: with the feature `std`,
    /// on x86-64.
    #[must_use]
    pub fn widest() -> Self {
        #[cfg(all(target_arch = "x86_64", feature = "std"))]
        {
            use std::is_x86_feature_detected as has;
            if has!("avx512f") && has!("avx512vl") && has!("avx512dq") && has!("avx512bw") {
                return Self::Avx512;
            }
            if has!("avx2") {
                return Self::Avx2;
            }
        }
        Self::Baseline
    }
}

/// A set of instructions that the machine has been found to have: asked once, not for every loop.
#[derive(Clone, Copy, Debug)]
pub struct Present(Lanes);

impl Present {
    /// The widest that there is, up to `most`.
    pub fn up_to(most: Lanes) -> Self {
        Self(most.min(Lanes::widest()))
    }

    /// No wider than `most`.
    pub fn at_most(self, most: Lanes) -> Self {
        Self(self.0.min(most))
    }
}

/// A loop that is worth vector instructions.
pub trait Kernel {
    /// What it returns.
    type Output;
    /// Its body: to be marked `#[inline(always)]`, as all that it calls, so that it is compiled for each set, which it
    /// is told. With the feature `compact` some of what it calls is compiled once, for the whole program's set.
    fn run(self, set: impl Set) -> Self::Output;
}

/// Runs a kernel on these lanes.
#[inline]
pub fn run<K: Kernel>(lanes: Present, kernel: K) -> K::Output {
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    match lanes.0 {
        // SAFETY: `up_to` has found the instructions that the function is compiled for.
        Lanes::Avx512 => return unsafe { avx512(kernel) },
        // SAFETY: likewise.
        Lanes::Avx2 => return unsafe { avx2(kernel) },
        Lanes::Baseline => {}
    }
    let _ = lanes;
    kernel.run(Whole)
}

/// A loop that writes to six columns, three and three of a kind. They are arguments of a function that is compiled by itself, because only of those
/// does the compiler know that nothing else overlaps them: else it tests that before each loop, with more instructions
/// than a short loop has.
pub trait SixColumns<R, S = R> {
    /// What it returns.
    type Output;
    /// Its body: to be marked `#[inline(always)]`, as all that it calls.
    fn run(self, a: &mut [R], b: &mut [R], c: &mut [R], d: &mut [S], e: &mut [S], f: &mut [S]) -> Self::Output;
}

/// Runs a loop on six columns on these lanes.
#[allow(clippy::too_many_arguments, reason = "an array of them would hide that they do not overlap")]
#[inline(always)]
pub fn run_on_six<R, S, K: SixColumns<R, S>>(
    lanes: Present,
    kernel: K,
    a: &mut [R],
    b: &mut [R],
    c: &mut [R],
    d: &mut [S],
    e: &mut [S],
    f: &mut [S],
) -> K::Output {
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    match lanes.0 {
        // SAFETY: `up_to` has found the instructions that the function is compiled for.
        Lanes::Avx512 => return unsafe { avx512_on_six(kernel, a, b, c, d, e, f) },
        // SAFETY: likewise.
        Lanes::Avx2 => return unsafe { avx2_on_six(kernel, a, b, c, d, e, f) },
        Lanes::Baseline => {}
    }
    let _ = lanes;
    baseline_on_six(kernel, a, b, c, d, e, f)
}

/// The function that a loop on six columns is compiled in, with these attributes.
macro_rules! on_six {
    ($name:ident, $(#[$attribute:meta])*) => {
        $(#[$attribute])*
        fn $name<R, S, K: SixColumns<R, S>>(
            kernel: K,
            a: &mut [R],
            b: &mut [R],
            c: &mut [R],
            d: &mut [S],
            e: &mut [S],
            f: &mut [S],
        ) -> K::Output {
            kernel.run(a, b, c, d, e, f)
        }
    };
}

on_six!(baseline_on_six, #[inline(never)]);
on_six!(
    avx2_on_six,
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    #[target_feature(enable = "avx2")]
);
on_six!(
    avx512_on_six,
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
);

#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[target_feature(enable = "avx2")]
fn avx2<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: this is compiled for AVX2.
    kernel.run(unsafe { Avx::new() })
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn avx512<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: AVX2 is part of what this is compiled for.
    kernel.run(unsafe { Avx::new() })
}
