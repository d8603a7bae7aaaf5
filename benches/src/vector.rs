//! What the textbook loop asks of a vector, so that it is written once for three of them.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Sub, SubAssign};
use glam::{DVec3, Vec3, Vec3A};

/// The real numbers that a vector is made of.
pub trait Scalar:
    Copy + Debug + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// 0
    const ZERO: Self;
    /// 1
    const ONE: Self;
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
}

/// Three numbers, in glam's own layout: 12 bytes ([`Vec3`]), 16 ([`Vec3A`], four lanes) or 24 ([`DVec3`]).
pub trait Vector:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Self::Real, Output = Self> + AddAssign + SubAssign
{
    /// What its components are.
    type Real: Scalar;
    /// No length.
    const ZERO: Self;
    /// The nearest vector of this type.
    fn from_components(components: [f64; 3]) -> Self;
    /// Its components, widened.
    fn components(self) -> [f64; 3];
    /// The inner product.
    fn dot(self, other: Self) -> Self::Real;
    /// The Euclidean length.
    fn length(self) -> Self::Real;
}

macro_rules! scalar {
    ($real:ty) => {
        impl Scalar for $real {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            #[inline]
            fn from_f64(value: f64) -> Self {
                value as Self
            }
        }
    };
}

macro_rules! vector {
    ($vector:ty, $real:ty) => {
        impl Vector for $vector {
            type Real = $real;
            const ZERO: Self = Self::ZERO;
            #[inline]
            fn from_components(components: [f64; 3]) -> Self {
                Self::from_array(components.map(|component| component as $real))
            }
            #[inline]
            fn components(self) -> [f64; 3] {
                self.to_array().map(f64::from)
            }
            #[inline]
            fn dot(self, other: Self) -> $real {
                self.dot(other)
            }
            #[inline]
            fn length(self) -> $real {
                self.length()
            }
        }
    };
}

scalar!(f32);
scalar!(f64);
vector!(Vec3, f32);
vector!(Vec3A, f32);
vector!(DVec3, f64);
