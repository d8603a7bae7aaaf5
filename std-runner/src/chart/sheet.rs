//! Charts beside and below each other in one SVG, with one legend.

use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::{IntoDrawingArea, SVGBackend};
use plotters::style::RGBColor;

use super::Chart;
use super::legend::{self, Entry};
use super::plot::plot;

/// Of text and axes.
pub const INK: RGBColor = RGBColor(0x20, 0x24, 0x28);
/// Of lines behind.
pub const GRID: RGBColor = RGBColor(0xDC, 0xDF, 0xE2);
/// Of what is drawn on.
pub const PAPER: RGBColor = RGBColor(0xFF, 0xFF, 0xFF);
/// Whatever font of that kind who looks at it has.
pub(super) const FONT: &str = "sans-serif";
/// Places are whole numbers of so small a part of a pixel.
pub(super) const SCALE: i32 = 4;

/// Of one chart, pixels.
const WIDTH: i32 = 620;
const HEIGHT: i32 = 440;

/// A chart could not be drawn.
#[derive(Debug, thiserror::Error)]
#[error("a chart cannot be drawn: {0}")]
pub struct ChartError(String);

impl From<String> for ChartError {
    fn from(reason: String) -> Self {
        Self(reason)
    }
}

/// What came of drawing something.
pub(super) type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Charts in columns, and what their curves mean.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Row by row.
    pub charts: Vec<Chart>,
    /// Charts in a row, at least one.
    pub columns: usize,
    /// At the right.
    pub legend: Vec<Entry>,
}

impl Sheet {
    /// As one SVG that needs nothing else.
    ///
    /// # Errors
    /// If a chart has no room for its axes.
    pub fn svg(&self) -> Result<String, ChartError> {
        let mut text = String::new();
        self.draw(&mut text).map_err(|error| ChartError(error.to_string()))?;
        Ok(text)
    }

    fn draw(&self, text: &mut String) -> Drawn {
        let columns = self.columns.clamp(1, self.charts.len().max(1));
        let rows = self.charts.len().div_ceil(columns);
        let width = SCALE * WIDTH * columns as i32;
        let side = legend::width(&self.legend);
        let height = (SCALE * HEIGHT * rows as i32).max(legend::height(&self.legend));
        let root = SVGBackend::with_string(text, ((width + side) as u32, height as u32)).into_drawing_area();
        root.fill(&PAPER)?;
        let (charts, key) = root.split_horizontally(width);
        for (chart, area) in self.charts.iter().zip(charts.split_evenly((rows, columns))) {
            plot(&area, chart)?;
        }
        legend::draw(&key, &self.legend)?;
        root.present()
    }
}
