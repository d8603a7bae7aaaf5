//! Marks and lines, wherever they are drawn.

use plotters::coord::CoordTranslate;
use plotters::element::DashedPathElement;
use plotters::prelude::{Circle, DrawingArea, EmptyElement, PathElement, Polygon, SVGBackend};
use plotters::style::{Color, ShapeStyle};

use super::look::{Dash, Look, Shape};
use super::sheet::{Drawn, PAPER, SCALE};

/// From the middle of a mark to its edge.
const RADIUS: i32 = 4 * SCALE;

/// A mark at a place.
pub(super) fn mark<C: CoordTranslate>(area: &DrawingArea<SVGBackend<'_>, C>, at: C::From, look: &Look) -> Drawn
where
    C::From: Clone,
{
    let Some(shape) = look.shape else { return Ok(()) };
    let r = if look.is_thin { 3 * RADIUS / 4 } else { RADIUS };
    let inside: ShapeStyle = if look.is_filled { look.colour.filled() } else { PAPER.filled() };
    let edge = look.colour.stroke_width(2 * SCALE as u32);
    let outline = match shape {
        Shape::Circle => {
            area.draw(&(EmptyElement::at(at.clone()) + Circle::new((0, 0), r, inside)))?;
            return area.draw(&(EmptyElement::at(at) + Circle::new((0, 0), r, edge)));
        }
        Shape::Square => vec![(-r, -r), (r, -r), (r, r), (-r, r)],
        Shape::Diamond => vec![(0, -r - 2), (r + 2, 0), (0, r + 2), (-r - 2, 0)],
        Shape::Up => vec![(0, -r - 1), (r + 1, r), (-r - 1, r)],
        Shape::Down => vec![(0, r + 1), (r + 1, -r), (-r - 1, -r)],
    };
    let closed: Vec<(i32, i32)> = outline.iter().chain(outline.first()).copied().collect();
    area.draw(&(EmptyElement::at(at.clone()) + Polygon::new(outline, inside)))?;
    area.draw(&(EmptyElement::at(at) + PathElement::new(closed, edge)))
}

/// A ring around a place.
pub(super) fn ring<C: CoordTranslate>(area: &DrawingArea<SVGBackend<'_>, C>, at: C::From, style: ShapeStyle) -> Drawn {
    area.draw(&(EmptyElement::at(at) + Circle::new((0, 0), 2 * RADIUS, style)))
}

/// A line through places.
pub(super) fn line<C: CoordTranslate>(area: &DrawingArea<SVGBackend<'_>, C>, points: Vec<C::From>, look: &Look) -> Drawn
where
    C::From: Clone,
{
    let width = if look.is_thin { SCALE } else { 2 * SCALE } as u32;
    let style = look.colour.stroke_width(width);
    match look.dash {
        Dash::Solid => area.draw(&PathElement::new(points, style)),
        Dash::Dashed => area.draw(&DashedPathElement::new(points, 7 * SCALE, 4 * SCALE, style)),
        Dash::Dotted => area.draw(&DashedPathElement::new(points, 2 * SCALE, 4 * SCALE, style)),
    }
}
