//! How steppers, precisions and forms of collision look in every chart.

use crate::chart::{Dash, Look, colour};
use crate::scene::{Precision, StepperName};

/// Colour and shape by stepper, dashes and filling by precision.
pub(super) fn look(stepper: StepperName, precision: Precision) -> Look {
    let number = StepperName::ALL.iter().position(|known| *known == stepper).unwrap_or(0);
    let (colour, shape) = colour(number);
    Look { colour, shape: Some(shape), dash: dash(precision), is_filled: precision == Precision::F64, is_thin: false }
}

/// `f64` is the plain one: whatever else there is, is broken.
fn dash(precision: Precision) -> Dash {
    let others = Precision::ALL.iter().filter(|other| **other != Precision::F64);
    match others.clone().position(|other| *other == precision) {
        None => Dash::Solid,
        Some(0) => Dash::Dashed,
        Some(_) => Dash::Dotted,
    }
}
