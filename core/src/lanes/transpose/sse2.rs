//! By vectors of 128 bits.

use core::arch::x86_64::{
    __m128, __m128d, _mm_loadu_pd, _mm_loadu_ps, _mm_movehl_ps, _mm_movelh_ps, _mm_storeu_pd, _mm_storeu_ps,
    _mm_unpackhi_pd, _mm_unpackhi_ps, _mm_unpacklo_pd, _mm_unpacklo_ps,
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
