//! Coloured cells over two logarithmic axes, with a curve over them, side by side.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::drawing::IntoDrawingArea;
use plotters::prelude::{Cartesian2d, ChartBuilder, DrawingArea, PathElement, Rectangle, SVGBackend, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, IntoFont, IntoTextStyle, TRANSPARENT};

use super::axis::{Axis, Places};
use super::legend::{self, Entry};
use super::look::Colour;
use super::sheet::{ChartError, Drawn, FONT, INK, PAPER, SCALE};

/// Of one mosaic, pixels.
const WIDTH: i32 = 380;
const HEIGHT: i32 = 424;
/// For each line of the title.
const LINE: i32 = 26 * SCALE;
/// For the numbers at the left.
const LEFT: i32 = 64 * SCALE;

/// Cells of one colour each, evenly spaced.
#[derive(Clone, Debug)]
pub struct Mosaic {
    /// Above what it is beside: of a row the first has one, and there is room for it above the others.
    pub heading: String,
    /// Above it.
    pub title: String,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// In the middle of each column, at least two, growing.
    pub columns: Vec<f64>,
    /// In the middle of each row, at least two, growing.
    pub rows: Vec<f64>,
    /// Row by row, from below.
    pub cells: Vec<Colour>,
    /// Over the cells.
    pub curve: Vec<(f64, f64)>,
}

/// Mosaics in columns, and what their colours mean.
#[derive(Clone, Debug)]
pub struct Mosaics {
    /// Row by row.
    pub mosaics: Vec<Mosaic>,
    /// In a row, at least one.
    pub columns: usize,
    /// At the right.
    pub legend: Vec<Entry>,
}

impl Mosaics {
    /// As one SVG that needs nothing else.
    ///
    /// # Errors
    /// If a mosaic has no room for its axes.
    pub fn svg(&self) -> Result<String, ChartError> {
        let mut text = String::new();
        self.draw(&mut text).map_err(|error| ChartError::from(error.to_string()))?;
        Ok(text)
    }

    fn draw(&self, text: &mut String) -> Drawn {
        let columns = self.columns.max(1);
        let rows = self.mosaics.len().div_ceil(columns).max(1);
        let width = SCALE * WIDTH * columns as i32;
        let side = legend::width(&self.legend);
        let height = (SCALE * HEIGHT * rows as i32).max(legend::height(&self.legend));
        let root = SVGBackend::with_string(text, ((width + side) as u32, height as u32)).into_drawing_area();
        root.fill(&PAPER)?;
        let (mosaics, key) = root.split_horizontally(width);
        let (mosaics, _) = mosaics.split_vertically(SCALE * HEIGHT * rows as i32);
        for (mosaic, area) in self.mosaics.iter().zip(mosaics.split_evenly((rows, columns))) {
            mosaic.draw(&area)?;
        }
        legend::draw(&key, &self.legend)?;
        root.present()
    }
}

impl Mosaic {
    fn draw(&self, area: &DrawingArea<SVGBackend<'_>, Shift>) -> Drawn {
        let (x, y) = (edges(&self.x, &self.columns), edges(&self.y, &self.rows));
        let (head, body) = area.split_vertically(2 * LINE);
        let style = (FONT, 17 * SCALE).with_color(INK).into_text_style(&head).pos(Pos::new(HPos::Left, VPos::Bottom));
        for (text, line) in [(&self.heading, 1), (&self.title, 2)] {
            head.draw(&Text::new(text.clone(), (LEFT + 8 * SCALE, line * LINE), style.clone()))?;
        }
        let mut built = ChartBuilder::on(&body)
            .margin(8 * SCALE)
            .margin_right(16 * SCALE)
            .x_label_area_size(46 * SCALE)
            .y_label_area_size(LEFT)
            .build_cartesian_2d(self.x.places(range(&x)), self.y.places(range(&y)))?;
        self.tiles(built.plotting_area(), &x, &y)?;
        built
            .configure_mesh()
            .bold_line_style(TRANSPARENT)
            .light_line_style(TRANSPARENT)
            .axis_style(INK.stroke_width(SCALE as u32))
            .label_style((FONT, 14 * SCALE).into_font().color(&INK))
            .axis_desc_style((FONT, 15 * SCALE).into_font().color(&INK))
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .x_labels(99)
            .y_labels(99)
            .x_label_formatter(&|place| self.x.written(*place))
            .y_label_formatter(&|place| self.y.written(*place))
            .draw()?;
        let within = |(x_at, y_at): &(f64, f64)| range(&x).contains(x_at) && range(&y).contains(y_at);
        let placed = self.curve.iter().filter_map(|(x, y)| Some((self.x.place(*x)?, self.y.place(*y)?)));
        let curve: Vec<(f64, f64)> = placed.filter(within).collect();
        // Bright around dark: it is seen on every colour.
        for (colour, width) in [(PAPER, 6), (INK, 3)] {
            built
                .plotting_area()
                .draw(&PathElement::new(curve.clone(), colour.stroke_width((width * SCALE / 2) as u32)))?;
        }
        Ok(())
    }

    /// Neighbours of one colour in a row are one tile. Each reaches a little under the next, so that no seam shows.
    fn tiles(&self, inside: &DrawingArea<SVGBackend<'_>, Cartesian2d<Places, Places>>, x: &[f64], y: &[f64]) -> Drawn {
        let count = self.columns.len();
        for (row, cells) in self.cells.chunks(count).enumerate() {
            let (Some(bottom), Some(top)) = (y.get(row), y.get(row + 1)) else { continue };
            let top = (top + 0.1 * (top - bottom)).min(range(y).end);
            let mut from = 0;
            for tile in cells.chunk_by(|left, right| left == right) {
                let until = from + tile.len();
                if let (Some(left), Some(right), Some(colour)) = (x.get(from), x.get(until), tile.first()) {
                    let right = (right + 0.1 * (right - left) / tile.len() as f64).min(range(x).end);
                    inside.draw(&Rectangle::new([(*left, *bottom), (right, top)], colour.filled()))?;
                }
                from = until;
            }
        }
        Ok(())
    }
}

/// Half-way between the middles, in places.
fn edges(axis: &Axis, middles: &[f64]) -> Vec<f64> {
    let places: Vec<f64> = middles.iter().filter_map(|middle| axis.place(*middle)).collect();
    let half = match places[..] {
        [first, second, ..] => 0.5 * (second - first),
        _ => 0.5,
    };
    let first = places.first().map(|place| place - half);
    first.into_iter().chain(places.iter().map(|place| place + half)).collect()
}

/// A little more, so that a tick at an edge has its place.
fn range(edges: &[f64]) -> Range<f64> {
    edges.first().copied().unwrap_or(0.0) - 1e-9..edges.last().copied().unwrap_or(1.0) + 1e-9
}
