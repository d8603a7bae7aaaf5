//! How far a number may be off by rounding and still count as what it should be.

use crate::Real;

/// Roundings that a position or a velocity may be away from a plane's and still count as on it: a dozen operations
/// at most lie between a hit and the next test, each wrong by half an EPSILON of the largest term.
const ROUNDINGS: f64 = 32.0;

/// What roundings may leave of a number of this size.
#[inline(always)]
pub fn rounding<R: Real>(size: R) -> R {
    R::from_f64(ROUNDINGS) * R::EPSILON * size
}
