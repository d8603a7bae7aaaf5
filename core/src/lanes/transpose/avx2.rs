//! By vectors of 256 bits.

use core::arch::x86_64::{
    __m256, __m256d, _mm256_loadu_pd, _mm256_loadu_ps, _mm256_permute2f128_pd, _mm256_permute2f128_ps,
    _mm256_shuffle_ps, _mm256_storeu_pd, _mm256_storeu_ps, _mm256_unpackhi_pd, _mm256_unpackhi_ps, _mm256_unpacklo_pd,
    _mm256_unpacklo_ps,
};

use super::{Rows, Set, Turned};
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
    const BYTES_OF_SIX: usize = 64;

    turn_by!(single_by_eights, double_by_fours);
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
unsafe fn single_by_eights(rows: *const f32, turned: *mut f32) {
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
unsafe fn double_by_fours(rows: *const f64, turned: *mut f64) {
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
