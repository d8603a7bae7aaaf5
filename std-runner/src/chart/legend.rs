//! What the marks and lines of a chart mean.

use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, Rectangle, SVGBackend, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, IntoTextStyle};

use super::look::{Colour, Look};
use super::mark::{line, mark, ring};
use super::sheet::{Drawn, FONT, INK, SCALE};

/// One line of a legend.
#[derive(Clone, Debug)]
pub enum Entry {
    /// What the entries below it are.
    Heading(String),
    /// A curve that is drawn so.
    Curve(Look, String),
    /// A point with a ring around it.
    Ringed(String),
    /// A cell of that colour.
    Cell(Colour, String),
}

/// From one line to the next.
const LINE: i32 = 22 * SCALE;
/// From the left to the text.
const INDENT: i32 = 44 * SCALE;

/// Of a letter, about.
const LETTER: i32 = 8 * SCALE;

/// How wide a legend of such entries is.
pub(super) fn width(entries: &[Entry]) -> i32 {
    let letters = |entry: &Entry| match entry {
        Entry::Heading(text) | Entry::Curve(_, text) | Entry::Ringed(text) | Entry::Cell(_, text) => {
            text.chars().count() as i32
        }
    };
    entries.iter().map(letters).max().map_or(0, |most| INDENT + LETTER * most)
}

/// How high a legend of so many entries is.
pub(super) fn height(entries: &[Entry]) -> i32 {
    LINE * (entries.len() as i32 + 2)
}

pub(super) fn draw(area: &DrawingArea<SVGBackend<'_>, Shift>, entries: &[Entry]) -> Drawn {
    for (number, entry) in entries.iter().enumerate() {
        let y = LINE * (number as i32 + 2);
        let text = |text: &str, x: i32, size: i32| {
            let style = (FONT, size * SCALE).with_color(INK).into_text_style(area);
            area.draw(&Text::new(text.to_owned(), (x, y), style.pos(Pos::new(HPos::Left, VPos::Center))))
        };
        match entry {
            Entry::Heading(heading) => text(heading, 4 * SCALE, 15)?,
            Entry::Curve(look, name) => {
                line(area, vec![(4 * SCALE, y), (INDENT - 8 * SCALE, y)], look)?;
                mark(area, (INDENT / 2 - 2 * SCALE, y), look)?;
                text(name, INDENT, 16)?;
            }
            Entry::Cell(colour, name) => {
                let corners = [(10 * SCALE, y - 7 * SCALE), (INDENT - 14 * SCALE, y + 7 * SCALE)];
                area.draw(&Rectangle::new(corners, colour.filled()))?;
                text(name, INDENT, 16)?;
            }
            Entry::Ringed(name) => {
                ring(area, (INDENT / 2 - 2 * SCALE, y), INK.stroke_width(SCALE as u32))?;
                text(name, INDENT, 16)?;
            }
        }
    }
    Ok(())
}
