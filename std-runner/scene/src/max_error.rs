//! An accuracy asked for in place of a time step.

use super::names::{CollisionForm, Precision, StepperName};

/// How far off a run may be, and what of the rest is not to be chosen for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxError {
    /// The largest distance of any particle from where it should be at any time, m; more than 0.
    pub error: f64,
    /// This stepper and no other.
    pub stepper: Option<StepperName>,
    /// This precision and no other.
    pub precision: Option<Precision>,
    /// This form of collisions; if left out the one that keeps the order of steppers.
    pub collision: Option<CollisionForm>,
}

impl MaxError {
    /// An error in metres, and everything else left open.
    #[must_use]
    pub fn of(error: f64) -> Self {
        Self { error, stepper: None, precision: None, collision: None }
    }
}
