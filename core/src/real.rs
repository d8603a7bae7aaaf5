//! The real numbers: `f32`, `f64`, and `f32` with its rounding residual kept, behind one short trait.

use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::compiled::{Compiled, HotLoops};
use crate::square_root;

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
    impl Sealed for crate::Compensated {}
}

/// A floating-point number that a world can be made of: `f32`, `f64` or [`crate::Compensated`].
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
    /// The number that positions and velocities are told in at the surface.
    type Coordinate: Real;
    /// `glam`'s vector of three of those: the type of positions and velocities at the surface.
    type Vec3: Copy + Debug + PartialEq + From<[Self::Coordinate; 3]> + Into<[Self::Coordinate; 3]>;
    /// What a number that is carried from step to step keeps of what it has lost in rounding: nothing but in
    /// [`crate::Compensated`].
    type Residual: Copy + Debug + Default + PartialEq + Send + Sync + 'static;
    /// The hot loops in this precision.
    #[doc(hidden)]
    type Loops: HotLoops<Self>;
    /// Whether there is any.
    const IS_COMPENSATED: bool;
    /// Where nothing has been lost.
    const NO_RESIDUAL: Self::Residual;
    /// As many residuals as anybody asks for, where there are none to be kept; else none.
    const NO_RESIDUALS: &'static [Self::Residual];
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// Positive infinity.
    const INFINITY: Self;

    /// The square root, correctly rounded; NaN of what is less than 0.
    #[must_use]
    fn sqrt(self) -> Self;
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// The nearest number of this type; infinite past its range.
    fn from_f64(value: f64) -> Self;
    /// The same number as an `f64`; exact.
    fn to_f64(self) -> f64;
    /// The number that a coordinate is carried as, and what that leaves of it.
    fn carry(coordinate: Self::Coordinate) -> (Self, Self::Residual);
    /// The coordinate that is carried so.
    fn told(self, residual: Self::Residual) -> Self::Coordinate;
    /// A difference of two carried numbers, given that of the numbers themselves.
    #[must_use]
    fn corrected(self, minuend: Self::Residual, subtrahend: Self::Residual) -> Self;
    /// The sum of a carried number and an increment, carried.
    #[must_use]
    fn plus(self, residual: Self::Residual, increment: Self) -> (Self, Self::Residual);

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
            type Coordinate = Self;
            type Vec3 = $vector;
            type Residual = ();
            type Loops = Compiled;
            const IS_COMPENSATED: bool = false;
            const NO_RESIDUAL: () = ();
            const NO_RESIDUALS: &'static [()] = &[(); usize::MAX];
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
            #[inline(always)]
            fn carry(coordinate: Self) -> (Self, ()) {
                (coordinate, ())
            }
            #[inline(always)]
            fn told(self, _residual: ()) -> Self {
                self
            }
            #[inline(always)]
            fn corrected(self, _minuend: (), _subtrahend: ()) -> Self {
                self
            }
            #[inline(always)]
            fn plus(self, _residual: (), increment: Self) -> (Self, ()) {
                (self + increment, ())
            }
        }
    };
}

real!(f32, glam::Vec3, square_root::single);
real!(f64, glam::DVec3, square_root::double);
