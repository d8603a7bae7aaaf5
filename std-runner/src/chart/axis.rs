//! One axis: what it measures, from where to where, and where it has ticks.

use std::ops::Range;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};

/// How values become places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// By their size.
    Linear,
    /// By their logarithm: only what is above 0 has a place.
    Logarithmic,
}

/// What is measured along one side of a chart.
#[derive(Clone, Debug)]
pub struct Axis {
    /// With the unit.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// How a value is written at a tick.
    pub tick: fn(f64) -> String,
    /// What it has to reach at least.
    pub reach: Option<(f64, f64)>,
}

/// At most so many ticks.
const MOST_TICKS: f64 = 9.0;
/// Room beyond the outermost points, as a part of the axis.
const MARGIN: f64 = 0.04;

impl Axis {
    /// An axis that reaches as far as its values.
    #[must_use]
    pub fn new(label: impl Into<String>, scale: Scale, tick: fn(f64) -> String) -> Self {
        Self { label: label.into(), scale, tick, reach: None }
    }

    /// Where a value lies; nothing if it has no place.
    pub(super) fn place(&self, value: f64) -> Option<f64> {
        match self.scale {
            Scale::Linear => Some(value),
            Scale::Logarithmic => (value > 0.0).then(|| value.log10()),
        }
        .filter(|place| place.is_finite())
    }

    /// What is written at a place.
    pub(super) fn written(&self, place: f64) -> String {
        (self.tick)(match self.scale {
            Scale::Linear => place,
            Scale::Logarithmic => 10.0_f64.powf(place),
        })
    }

    /// The places that hold all these values.
    pub(super) fn range(&self, values: impl Iterator<Item = f64>) -> Range<f64> {
        let reach = self.reach.into_iter().flat_map(|(from, to)| [from, to]);
        let places = values.chain(reach).filter_map(|value| self.place(value));
        let (low, high) =
            places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| (low.min(place), high.max(place)));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        let margin = if high > low { MARGIN * (high - low) } else { 0.5 };
        low - margin..high + margin
    }

    /// For what draws it.
    pub(super) fn places(&self, range: Range<f64>) -> Places {
        let ticks = self.ticks(&range);
        Places { range, ticks }
    }

    /// Where ticks are: at whole powers of ten, or at round numbers where there are few of these.
    fn ticks(&self, range: &Range<f64>) -> Vec<f64> {
        let width = range.end - range.start;
        match self.scale {
            Scale::Logarithmic if width < 2.5 => {
                let decades = range.start.floor() as i32..=range.end.ceil() as i32;
                let values =
                    decades.flat_map(|decade| [1.0, 2.0, 5.0].map(|digit: f64| digit.log10() + f64::from(decade)));
                values.filter(|place| range.contains(place)).collect()
            }
            Scale::Logarithmic => multiples((width / MOST_TICKS).ceil(), range),
            Scale::Linear => multiples(round_up(width / MOST_TICKS), range),
        }
    }
}

/// The places along an axis, for what draws it.
pub(super) struct Places {
    range: Range<f64>,
    ticks: Vec<f64>,
}

impl Ranged for Places {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, place: &f64, (from, to): (i32, i32)) -> i32 {
        let part = (place - self.range.start) / (self.range.end - self.range.start);
        from + (part * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        // Light lines between the ticks are not drawn.
        if hint.bold_points() == 0 { Vec::new() } else { self.ticks.clone() }
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

/// All multiples of a number in a range.
fn multiples(of: f64, range: &Range<f64>) -> Vec<f64> {
    let (first, last) = ((range.start / of).ceil() as i64, (range.end / of).floor() as i64);
    (first..=last).map(|multiple| multiple as f64 * of).collect()
}

/// To 1, 2 or 5 times a power of ten.
fn round_up(value: f64) -> f64 {
    let decade = 10.0_f64.powf(value.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|digit| digit * decade).find(|round| *round >= value).unwrap_or(10.0 * decade)
}
