//! The real numbers: `f32` and `f64` behind one short trait.

use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::square_root;

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// A floating-point number that a world can be made of: `f32` or `f64`.
///
/// Every operation is the correctly rounded one of IEEE 754, so a step gives the same bits on every machine.
/// There is no fused multiply-add here on purpose: it rounds once where others round twice.
pub trait Real:
    sealed::Sealed
    + Copy
    + Debug
    + Display
    + Default
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + Send
    + Sync
    + 'static
{
    /// `glam`'s vector of three of these: the type of positions and velocities at the surface.
    type Vec3: Copy + Debug + PartialEq + From<[Self; 3]> + Into<[Self; 3]>;
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// Positive infinity.
    const INFINITY: Self;

    /// The square root, correctly rounded.
    #[must_use]
    fn sqrt(self) -> Self;
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
    /// The same number as an `f64`; exact.
    fn to_f64(self) -> f64;

    /// The larger of two numbers; `self` if `other` is NaN.
    #[must_use]
    fn at_least(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    /// The smaller of two numbers; `self` if `other` is NaN.
    #[must_use]
    fn at_most(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
}

macro_rules! real {
    ($type:ident, $vector:ty, $square_root:path) => {
        impl Real for $type {
            type Vec3 = $vector;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EPSILON: Self = $type::EPSILON;
            const INFINITY: Self = $type::INFINITY;

            #[inline(always)]
            fn sqrt(self) -> Self {
                $square_root(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $type::abs(self)
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                $type::is_finite(self)
            }
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $type
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }
    };
}

real!(f32, glam::Vec3, square_root::single);
real!(f64, glam::DVec3, square_root::double);
