//! Who runs a case.

use std::fmt;

use crate::scene::{Precision, StepperName};

/// A stepper in a precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Runner {
    /// How it steps.
    pub stepper: StepperName,
    /// In which numbers.
    pub precision: Precision,
}

impl fmt::Display for Runner {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} {}", self.stepper, self.precision)
    }
}
