//! Vectors of eight particles, particle by particle, turned into columns: shuffles that a compiler does not find by
//! itself. Nothing is computed, so no bit depends on which of them is taken.
//!
//! With plain code turning the vectors of a mesh and the law of its springs took 18 instructions a spring together, AVX2
//! in `f32`; so they take 8.

use crate::Real;

/// Position and velocity of eight particles, each x, y, z and a place left over.
pub type Rows<R> = [[R; 8]; 8];

/// x, y, z of the positions and then of the velocities.
pub type Turned<R> = [[R; 8]; 6];

/// One of the sets of instructions, as a kernel's body gets to know which one it is being compiled for.
pub trait Set: Copy {
    /// Bytes of each of six columns that fit its registers at once, beside what is added to them; where there are no
    /// vectors, one item at a time does: long stretches of unrolled code would only take flash.
    const BYTES_OF_SIX: usize =
        match cfg!(any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "simd128")) {
            // One vector, for the sake of less code.
            true if cfg!(feature = "compact") => 16,
            true => 32,
            false => 0,
        };

    /// Turns rows into columns.
    #[inline(always)]
    fn turn<R: Real>(self, rows: &Rows<R>) -> Turned<R> {
        let mut turned = [[R::ZERO; 8]; 6];
        for (place, [x, y, z, _, u, v, w, _]) in rows.iter().enumerate() {
            for (column, component) in turned.iter_mut().zip([x, y, z, u, v, w]) {
                if let Some(to) = column.get_mut(place) {
                    *to = *component;
                }
            }
        }
        turned
    }
}

/// [`Set::turn`] by the shuffles for `f32` and for `f64` that a set has.
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
macro_rules! turn_by {
    ($single:path, $double:path) => {
        #[inline(always)]
        fn turn<R: Real>(self, rows: &Rows<R>) -> Turned<R> {
            let mut turned = [[R::ZERO; 8]; 6];
            // SAFETY: there is no value of a set whose instructions are not there, and the arrays hold what their
            // pointers say: `R` is the float of its size, or one in disguise, as nothing else is a `Real`.
            unsafe {
                match size_of::<R>() {
                    4 => $single((&raw const *rows).cast(), (&raw mut turned).cast()),
                    _ => $double((&raw const *rows).cast(), (&raw mut turned).cast()),
                }
            }
            turned
        }
    };
}

/// What the whole program has been compiled for.
#[derive(Clone, Copy)]
pub struct Whole;

#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
impl Set for Whole {}

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
impl Set for Whole {
    turn_by!(sse2::single_by_fours, sse2::double_by_twos);
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
mod avx2;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
mod sse2;

#[cfg(all(target_arch = "x86_64", feature = "std"))]
pub use avx2::Avx;
