//! A linear spring with damping along its axis.

use crate::Real;

use super::AddSpringError;

/// A linear spring between two particles, with damping along its axis.
///
/// With d = x_j − x_i, l = |d|, d̂ = d/l and l̇ = (v_j − v_i)·d̂, it pulls particle i with
/// (k (l − l_rest) + k_d l̇) d̂ and particle j with the opposite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<R> {
    /// The numbers of the particles i and j; different.
    pub between: [u32; 2],
    /// k, N/m; finite, 0 or more.
    pub stiffness: R,
    /// k_d, N·s/m; finite, 0 or more.
    pub damping: R,
    /// l_rest, m; finite, 0 or more.
    pub rest_length: R,
}

impl<R: Real> Spring<R> {
    /// An undamped spring.
    #[must_use]
    pub fn new(between: [u32; 2], stiffness: R, rest_length: R) -> Self {
        Self { between, stiffness, damping: R::ZERO, rest_length }
    }

    /// Which of its parameters is negative or not finite, if any is.
    #[cfg_attr(feature = "compact", inline(never))]
    pub(crate) fn wrong(&self) -> Option<AddSpringError<R>> {
        let is_wrong = |value: R| !(value >= R::ZERO && value.is_finite());
        if is_wrong(self.stiffness) {
            return Some(AddSpringError::Stiffness(self.stiffness));
        }
        if is_wrong(self.damping) {
            return Some(AddSpringError::Damping(self.damping));
        }
        is_wrong(self.rest_length).then_some(AddSpringError::RestLength(self.rest_length))
    }

    /// The same spring with another damping (N·s/m).
    #[must_use]
    pub fn with_damping(self, damping: R) -> Self {
        Self { damping, ..self }
    }
}
