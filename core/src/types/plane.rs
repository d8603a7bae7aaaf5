//! A plane that particles bounce on.

use crate::Real;
use crate::vectors::{dot, rounded, scaled};

use super::AddPlaneError;

/// The plane n·x = offset; particles live on the side that n points to.
///
/// A particle hits it when n·x < offset while n·v < 0. Its normal velocity then becomes −e times itself and its
/// tangential velocity is kept.
///
/// ```
/// use hooke::{AddPlaneError, Plane};
///
/// let slope = Plane::<f64>::through([0.0, 0.0, 1.0], [3.0, 0.0, 4.0], 0.5)?;
/// assert!((slope.offset() - 0.8).abs() < 1e-15);
/// assert_eq!(Plane::<f64>::through([0.0; 3], [0.0; 3], 0.5), Err(AddPlaneError::Normal));
/// # Ok::<(), AddPlaneError<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<R> {
    pub(crate) normal: [R; 3],
    pub(crate) offset: R,
    pub(crate) restitution: R,
}

impl<R: Real> Plane<R> {
    /// The plane through `point` (m) across `normal`, which need not have length 1, with restitution e from 0 to 1.
    ///
    /// # Errors
    /// If the normal is 0 or not finite, the point or its distance from the origin not finite, or the restitution outside 0…1.
    pub fn through(
        point: impl Into<R::Vec3>,
        normal: impl Into<R::Vec3>,
        restitution: R,
    ) -> Result<Self, AddPlaneError<R>> {
        let point = rounded::<R>(point.into());
        let normal = rounded::<R>(normal.into());
        if !(restitution >= R::ZERO && restitution <= R::ONE) {
            return Err(AddPlaneError::Restitution(restitution));
        }
        if !point.iter().all(|component| component.is_finite()) {
            return Err(AddPlaneError::Point);
        }
        // Divided by its largest component first: the squares of a tiny or huge normal would be 0 or infinite.
        let largest = normal.iter().fold(R::ZERO, |largest, component| largest.at_least(component.abs()));
        if !(largest > R::ZERO && normal.iter().all(|component| component.is_finite())) {
            return Err(AddPlaneError::Normal);
        }
        let direction = normal.map(|component| component / largest);
        let unit = scaled(R::ONE / dot(direction, direction).sqrt(), direction);
        let offset = dot(unit, point);
        if !offset.is_finite() {
            return Err(AddPlaneError::Point);
        }
        Ok(Self { normal: unit, offset, restitution })
    }

    /// n, of length 1.
    #[must_use]
    pub fn normal(&self) -> R::Vec3 {
        self.normal.map(|component| component.told(R::NO_RESIDUAL)).into()
    }

    /// n·x of its points, m.
    #[must_use]
    pub fn offset(&self) -> R {
        self.offset
    }

    /// e, from 0 to 1.
    #[must_use]
    pub fn restitution(&self) -> R {
        self.restitution
    }

    /// How far a position lies above it, m.
    #[inline(always)]
    pub(crate) fn gap(&self, position: [R; 3]) -> R {
        dot(self.normal, position) - self.offset
    }
}
