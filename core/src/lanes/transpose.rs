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
#[cfg(target_arch = "x86_64")]
macro_rules! turn_by {
    ($single:path, $double:path) => {
        #[inline(always)]
        fn turn<R: Real>(self, rows: &Rows<R>) -> Turned<R> {
            let mut turned = [[R::ZERO; 8]; 6];
            // SAFETY: there is no value of a set whose instructions are not there, and the arrays hold what their
            // pointers say: `R` is the float of its size, as nothing but `f32` and `f64` is a `Real`.
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
    turn_by!(x86::single_by_fours, x86::double_by_twos);
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
pub use avx::Avx;

#[cfg(all(target_arch = "x86_64", feature = "std"))]
mod avx {
    use super::{Rows, Set, Turned, x86};
    use crate::Real;

    /// AVX2, or more: wider vectors would gain nothing here.
    #[derive(Clone, Copy)]
    pub struct Avx(());

    impl Avx {
        /// # Safety
        /// To be made, and used, only by functions that are compiled for AVX2.
        #[inline(always)]
        pub unsafe fn new() -> Self {
            Self(())
        }
    }

    impl Set for Avx {
        turn_by!(x86::single_by_eights, x86::double_by_fours);
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use core::arch::x86_64::{
        __m128, __m128d, __m256, __m256d, _mm_loadu_pd, _mm_loadu_ps, _mm_movehl_ps, _mm_movelh_ps, _mm_storeu_pd,
        _mm_storeu_ps, _mm_unpackhi_pd, _mm_unpackhi_ps, _mm_unpacklo_pd, _mm_unpacklo_ps, _mm256_loadu_pd,
        _mm256_loadu_ps, _mm256_permute2f128_pd, _mm256_permute2f128_ps, _mm256_shuffle_ps, _mm256_storeu_pd,
        _mm256_storeu_ps, _mm256_unpackhi_pd, _mm256_unpackhi_ps, _mm256_unpacklo_pd, _mm256_unpacklo_ps,
    };

    /// x, y and z of four particles.
    #[target_feature(enable = "sse2")]
    #[inline]
    fn four(a: __m128, b: __m128, c: __m128, d: __m128) -> [__m128; 3] {
        let (low, low_after) = (_mm_unpacklo_ps(a, b), _mm_unpacklo_ps(c, d));
        let (high, high_after) = (_mm_unpackhi_ps(a, b), _mm_unpackhi_ps(c, d));
        [_mm_movelh_ps(low, low_after), _mm_movehl_ps(low_after, low), _mm_movelh_ps(high, high_after)]
    }

    /// # Safety
    /// `rows` are eight rows of eight, `turned` six of eight.
    #[target_feature(enable = "sse2")]
    #[inline]
    pub unsafe fn single_by_fours(rows: *const f32, turned: *mut f32) {
        for vector in 0..2 {
            for half in 0..2 {
                // SAFETY: rows 4 to 7 at most, from place 4 on at most, and columns likewise.
                unsafe {
                    let row = |row: usize| _mm_loadu_ps(rows.add((4 * half + row) * 8 + 4 * vector));
                    for (axis, column) in four(row(0), row(1), row(2), row(3)).into_iter().enumerate() {
                        _mm_storeu_ps(turned.add((3 * vector + axis) * 8 + 4 * half), column);
                    }
                }
            }
        }
    }

    /// # Safety
    /// `rows` are eight rows of eight, `turned` six of eight.
    #[target_feature(enable = "sse2")]
    #[inline]
    pub unsafe fn double_by_twos(rows: *const f64, turned: *mut f64) {
        for vector in 0..2 {
            for pair in 0..4 {
                // SAFETY: rows 6 and 7 at most, from place 6 on at most, and columns likewise.
                unsafe {
                    let half = |row: usize, from: usize| -> __m128d {
                        _mm_loadu_pd(rows.add((2 * pair + row) * 8 + 4 * vector + from))
                    };
                    let (a, b) = (half(0, 0), half(1, 0));
                    let z = _mm_unpacklo_pd(half(0, 2), half(1, 2));
                    let columns = [_mm_unpacklo_pd(a, b), _mm_unpackhi_pd(a, b), z];
                    for (axis, column) in columns.into_iter().enumerate() {
                        _mm_storeu_pd(turned.add((3 * vector + axis) * 8 + 2 * pair), column);
                    }
                }
            }
        }
    }

    /// Each of x, y and z of four positions and four velocities.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn four_pairs(a: __m256, b: __m256, c: __m256, d: __m256) -> [__m256; 3] {
        let (low, low_after) = (_mm256_unpacklo_ps(a, b), _mm256_unpacklo_ps(c, d));
        let (high, high_after) = (_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d));
        [
            _mm256_shuffle_ps::<0x44>(low, low_after),
            _mm256_shuffle_ps::<0xEE>(low, low_after),
            _mm256_shuffle_ps::<0x44>(high, high_after),
        ]
    }

    /// # Safety
    /// `rows` are eight rows of eight, `turned` six of eight.
    #[target_feature(enable = "avx2")]
    #[inline]
    pub unsafe fn single_by_eights(rows: *const f32, turned: *mut f32) {
        // SAFETY: eight whole rows are read, and six whole columns written.
        unsafe {
            let row = |row: usize| _mm256_loadu_ps(rows.add(row * 8));
            let first = four_pairs(row(0), row(1), row(2), row(3));
            let second = four_pairs(row(4), row(5), row(6), row(7));
            for (axis, (first, second)) in first.into_iter().zip(second).enumerate() {
                _mm256_storeu_ps(turned.add(axis * 8), _mm256_permute2f128_ps::<0x20>(first, second));
                _mm256_storeu_ps(turned.add((3 + axis) * 8), _mm256_permute2f128_ps::<0x31>(first, second));
            }
        }
    }

    /// # Safety
    /// `rows` are eight rows of eight, `turned` six of eight.
    #[target_feature(enable = "avx2")]
    #[inline]
    pub unsafe fn double_by_fours(rows: *const f64, turned: *mut f64) {
        for vector in 0..2 {
            for half in 0..2 {
                // SAFETY: rows 4 to 7 at most, from place 4 on at most, and columns likewise.
                unsafe {
                    let row = |row: usize| -> __m256d { _mm256_loadu_pd(rows.add((4 * half + row) * 8 + 4 * vector)) };
                    let (a, b, c, d) = (row(0), row(1), row(2), row(3));
                    let (even, even_after) = (_mm256_unpacklo_pd(a, b), _mm256_unpacklo_pd(c, d));
                    let (odd, odd_after) = (_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(c, d));
                    let columns = [
                        _mm256_permute2f128_pd::<0x20>(even, even_after),
                        _mm256_permute2f128_pd::<0x20>(odd, odd_after),
                        _mm256_permute2f128_pd::<0x31>(even, even_after),
                    ];
                    for (axis, column) in columns.into_iter().enumerate() {
                        _mm256_storeu_pd(turned.add((3 * vector + axis) * 8 + 4 * half), column);
                    }
                }
            }
        }
    }
}
