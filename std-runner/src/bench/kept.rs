//! Points of an earlier measurement that still hold.

use std::collections::HashMap;

use super::asked::Asked;
use super::contender::Contender;
use super::point::Point;

/// What was measured before.
#[derive(Clone, Debug, Default)]
pub struct Kept(HashMap<(Contender, Asked), Point>);

impl Kept {
    /// How many points.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.len()
    }

    pub(super) fn find(&self, contender: Contender, asked: Asked) -> Option<Point> {
        self.0.get(&(contender, asked)).copied()
    }
}

impl FromIterator<(Contender, Point)> for Kept {
    fn from_iter<I: IntoIterator<Item = (Contender, Point)>>(points: I) -> Self {
        Self(points.into_iter().map(|(contender, point)| ((contender, point.asked), point)).collect())
    }
}
