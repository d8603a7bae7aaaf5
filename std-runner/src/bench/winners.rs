//! Who reaches an error first.

use super::sweep::{Contender, Point};
use super::{Bench, Swept};

/// The cheapest run that was measured whose error is no larger.
#[derive(Clone, Copy, Debug)]
pub struct Winner {
    /// The error that was asked for, m.
    pub error: f64,
    /// Who won, and with which run; nothing if nobody got there.
    pub run: Option<(Contender, Point)>,
}

/// For errors of 1e-1, 1e-2, … 1e-10 m, as far as the reference is known.
#[must_use]
pub fn winners(bench: &Bench) -> Vec<Winner> {
    (1..=10)
        .map(|exponent| 10.0_f64.powi(-exponent))
        .filter(|error| *error >= bench.reference.floor())
        .map(|error| Winner { error, run: fastest(&bench.swept, error) })
        .collect()
}

fn fastest(swept: &[Swept], error: f64) -> Option<(Contender, Point)> {
    let runs = swept.iter().flat_map(|swept| swept.points.iter().map(|point| (swept.contender, *point)));
    let good = runs.filter(|(_, point)| point.error.is_some_and(|reached| reached <= error));
    good.min_by(|(_, left), (_, right)| left.seconds.total_cmp(&right.seconds))
}
