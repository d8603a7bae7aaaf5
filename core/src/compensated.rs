//! Single precision that converges like double.

use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::Real;
use crate::compiled::Compiled;

/// An `f32` in a world whose positions and velocities carry what their sums have lost in rounding, so that machines
/// without `f64` get errors of `f64`'s kind: steps may be as short as they like, and places as far from the origin.
///
/// Forces are computed in `f32`, from differences of positions that the residuals correct; increments are added with
/// their rounding errors kept (Kahan, *Further remarks on reducing truncation errors*, 1965).
/// Positions and velocities are given and told in `f64`. That takes 6 reals more a particle and state, and 1.2 to 1.5 times
/// the time of `f32` in the caches, twice that beyond them.
///
/// Explicit steppers carry residuals; implicit ones step as in `f32`, and a bounce rounds what bounces to `f32`; so does the
/// exact flight of [`crate::Auto`], once. What dampers do, and how far a step drifts, follows from velocities without their
/// residuals: what flies at a constant speed is off by up to 6e-8 of its way.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Compensated(f32);

impl fmt::Display for Compensated {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

macro_rules! operators {
    ($($trait:ident, $method:ident;)*) => {
        $(impl $trait for Compensated {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })*
    };
}

operators! {
    Add, add;
    Sub, sub;
    Mul, mul;
    Div, div;
}

impl Neg for Compensated {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl AddAssign for Compensated {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.0 += other.0;
    }
}

impl SubAssign for Compensated {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        self.0 -= other.0;
    }
}

impl Real for Compensated {
    type Coordinate = f64;
    type Vec3 = glam::DVec3;
    type Residual = Self;
    type Loops = Compiled;
    const IS_COMPENSATED: bool = true;
    const NO_RESIDUAL: Self = Self::ZERO;
    const NO_RESIDUALS: &'static [Self] = &[];
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const EPSILON: Self = Self(f32::EPSILON);
    const INFINITY: Self = Self(f32::INFINITY);

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(Real::sqrt(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(value as f32)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self.0)
    }
    #[inline(always)]
    fn carry(coordinate: f64) -> (Self, Self) {
        let rounded = Self::from_f64(coordinate);
        (rounded, Self::from_f64(coordinate - rounded.to_f64()))
    }
    #[inline(always)]
    fn told(self, residual: Self) -> f64 {
        self.to_f64() + residual.to_f64()
    }
    #[inline(always)]
    fn corrected(self, minuend: Self, subtrahend: Self) -> Self {
        self + (minuend - subtrahend)
    }
    #[inline(always)]
    fn plus(self, residual: Self, increment: Self) -> (Self, Self) {
        let increment = increment + residual;
        let sum = self + increment;
        // Exact where the number is the larger of the two, and else off by a rounding of the increment, which has one.
        (sum, increment - (sum - self))
    }
}
