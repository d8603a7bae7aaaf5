//! From the distance between two runs to the error of the finer one.

use super::choice::{Choice, Ratio};
use crate::scene::Precision;

/// Between frames and steps runs are interpolated to sixth order: no more is made of a higher one. Of the difference of a
/// method of eighth order four times its error is read, which is a margin for what is not as it is for short steps.
const MOST_ORDER: u32 = 6;
/// Both runs round, each in its own way, and springs that hit planes may be hit one step sooner in one of them: no more
/// than this is taken off a difference that may be as large as an error, so that it never is more than three of them.
const MOST_OF_OTHERS: f64 = 3.0;
/// Runs that are this part of the scene apart are no small change of each other any more: nothing is taken off.
const FAR: f64 = 0.03;
/// The epsilon of `f32` over that of `f64`.
const ROUNDINGS: f64 = 536_870_912.0;

/// How differences are read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    divisor: f64,
    /// m
    far: f64,
}

impl Estimate {
    /// For pairs like this one, in a scene of that size (m), with planes or without.
    #[must_use]
    pub fn of(choice: &Choice, size: f64, has_planes: bool) -> Self {
        let divisor = match choice.ratio {
            // Nothing but rounding, which is the coarser precision's.
            Ratio::One if choice.precision == Precision::F64 => ROUNDINGS,
            Ratio::One => 1.0,
            ratio => {
                let divisor = ratio.value().powi(choice.order.min(MOST_ORDER) as i32) - 1.0;
                let is_smooth = choice.precision == Precision::F64 && !has_planes;
                if is_smooth { divisor } else { divisor.min(MOST_OF_OTHERS) }
            }
        };
        Self { divisor, far: FAR * size }
    }

    /// The error of the finer run (m), as far as it is known, from its distance to the coarser (m).
    #[must_use]
    pub fn error(&self, difference: f64) -> f64 {
        if difference.is_nan() {
            f64::INFINITY
        } else if difference < self.far || self.divisor < 1.0 {
            difference / self.divisor
        } else {
            difference
        }
    }

    /// The largest difference (m) that is read as no more than an error, m.
    #[must_use]
    pub fn difference(&self, error: f64) -> f64 {
        (error * self.divisor).min(self.far).max(error * self.divisor.min(1.0))
    }
}
