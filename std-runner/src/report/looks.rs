//! How steppers, precisions and forms of collision look in every chart.

use crate::bench::Contender;
use crate::chart::{Dash, Look, colour};
use crate::scene::{Precision, StepperName};

/// How far on among the shapes that of a stepper is which chooses its steps: in the same colour as with given ones.
const ADAPTIVE: usize = 2;

/// Colour and shape by stepper, dashes and filling by precision.
pub(super) fn look(contender: Contender) -> Look {
    let Contender { stepper, is_adaptive, precision, .. } = contender;
    let number = StepperName::ALL.iter().position(|known| *known == stepper).unwrap_or(0);
    let (_, shape) = colour(if is_adaptive { number + ADAPTIVE } else { number });
    let (colour, _) = colour(number);
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
