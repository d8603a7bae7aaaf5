//! Who reaches an error first.

use super::Bench;
use super::contender::Contender;
use super::point::Point;
use super::reference::Reference;
use super::sweep::Swept;

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
    levels(&bench.reference).map(|error| Winner { error, run: fastest(&bench.swept, error) }).collect()
}

/// The errors that winners are sought for, m.
pub(super) fn levels(reference: &Reference) -> impl Iterator<Item = f64> {
    let floor = reference.floor();
    (1..=10).map(|exponent| 10.0_f64.powi(-exponent)).filter(move |error| *error >= floor)
}

/// The cheapest run of all whose error is no larger, m.
pub(super) fn fastest(swept: &[Swept], error: f64) -> Option<(Contender, Point)> {
    let runs = swept.iter().flat_map(|swept| swept.points.iter().map(|point| (swept.contender, *point)));
    let good = runs.filter(|(_, point)| point.error.is_some_and(|reached| reached <= error));
    good.min_by(|(_, left), (_, right)| left.seconds.total_cmp(&right.seconds))
}

/// What to use over a range of errors: the same contender, with longer steps for the larger ones.
#[derive(Clone, Copy, Debug)]
pub struct Recommended {
    /// Who.
    pub contender: Contender,
    /// The largest error that it wins at, m, and with which run.
    pub loosest: (f64, Point),
    /// The smallest.
    pub tightest: (f64, Point),
}

/// Who wins from which error to which, from the largest to the smallest.
#[must_use]
pub fn recommended(winners: &[Winner]) -> Vec<Recommended> {
    let mut found: Vec<Recommended> = Vec::new();
    for winner in winners {
        let Some((contender, point)) = winner.run else { continue };
        let tightest = (winner.error, point);
        match found.last_mut().filter(|last| last.contender == contender) {
            Some(last) => last.tightest = tightest,
            None => found.push(Recommended { contender, loosest: tightest, tightest }),
        }
    }
    found
}
