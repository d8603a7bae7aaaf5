//! One chart: axes, shade, triangles, curves, rings.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::{Cartesian2d, ChartBuilder, DrawingArea, PathElement, Rectangle, SVGBackend, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, IntoFont, IntoTextStyle, TRANSPARENT};

use super::axis::Places;
use super::look::GREY;
use super::mark::{line, mark, ring};
use super::sheet::{Drawn, FONT, GRID, INK, SCALE};
use super::{Chart, Curve};

/// Where curves are drawn.
type Area<'a> = DrawingArea<SVGBackend<'a>, Cartesian2d<Places, Places>>;

/// The height of the triangles of orders, at most so many decades of time.
const TALLEST: f64 = 0.5;

pub(super) fn plot(area: &DrawingArea<SVGBackend<'_>, Shift>, chart: &Chart) -> Drawn {
    let points = || chart.curves.iter().flat_map(|curve| seen(chart, curve));
    let x = chart.x.range(points().map(|(x, _)| x));
    let y = chart.y.range(points().map(|(_, y)| y));
    let mut built = ChartBuilder::on(area)
        .margin(10 * SCALE)
        .margin_right(20 * SCALE)
        .caption(&chart.title, (FONT, 19 * SCALE).into_font().color(&INK))
        .x_label_area_size(46 * SCALE)
        .y_label_area_size(78 * SCALE)
        .build_cartesian_2d(chart.x.places(x.clone()), chart.y.places(y.clone()))?;
    if let Some((_, what)) = &chart.unknown {
        unknown(chart, built.plotting_area(), &x, &y, what)?;
    }
    built
        .configure_mesh()
        .bold_line_style(GRID.stroke_width(SCALE as u32))
        .light_line_style(TRANSPARENT)
        .axis_style(INK.stroke_width(SCALE as u32))
        .label_style((FONT, 15 * SCALE).into_font().color(&INK))
        .axis_desc_style((FONT, 17 * SCALE).into_font().color(&INK))
        .x_desc(&chart.x.label)
        .y_desc(&chart.y.label)
        .x_labels(99)
        .y_labels(99)
        .x_label_formatter(&|place| chart.x.written(*place))
        .y_label_formatter(&|place| chart.y.written(*place))
        .draw()?;
    let inside = built.plotting_area();
    if !chart.orders.is_empty() {
        triangles(inside, &chart.orders, &x, &y, known_from(chart, &x))?;
    }
    for curve in &chart.curves {
        let places: Vec<(f64, f64)> = placed(chart, curve);
        line(inside, places.clone(), &curve.look)?;
        for place in places {
            mark(inside, place, &curve.look)?;
        }
    }
    for place in chart.ringed.iter().filter_map(|point| at(chart, *point)) {
        ring(inside, place, INK.stroke_width(SCALE as u32))?;
    }
    Ok(())
}

/// The points of a curve that have a place.
fn seen<'a>(chart: &'a Chart, curve: &'a Curve) -> impl Iterator<Item = (f64, f64)> + 'a {
    curve.points.iter().copied().filter(|point| at(chart, *point).is_some())
}

fn placed(chart: &Chart, curve: &Curve) -> Vec<(f64, f64)> {
    curve.points.iter().filter_map(|point| at(chart, *point)).collect()
}

fn at(chart: &Chart, (x, y): (f64, f64)) -> Option<(f64, f64)> {
    Some((chart.x.place(x)?, chart.y.place(y)?))
}

/// Where what is known begins.
fn known_from(chart: &Chart, x: &Range<f64>) -> f64 {
    let until = chart.unknown.as_ref().and_then(|(until, _)| chart.x.place(*until));
    until.map_or(x.start, |until| until.clamp(x.start, x.end))
}

/// The shade over what is not known.
fn unknown(chart: &Chart, inside: &Area<'_>, x: &Range<f64>, y: &Range<f64>, what: &str) -> Drawn {
    let until = known_from(chart, x);
    if until > x.start {
        inside.draw(&Rectangle::new([(x.start, y.start), (until, y.end)], GRID.mix(0.6).filled()))?;
        let style = (FONT, 13 * SCALE).into_font().transform(FontTransform::Rotate270).color(&INK);
        let beside = (until - 0.005 * (x.end - x.start), y.end - 0.02 * (y.end - y.start));
        inside.draw(&Text::new(what.to_owned(), beside, style.pos(Pos::new(HPos::Right, VPos::Bottom))))?;
    }
    Ok(())
}

/// Right triangles with one corner in common: up by the same time, to the left by what an order makes of it. They are at
/// the lower left, where nobody is.
fn triangles(inside: &Area<'_>, orders: &[u32], x: &Range<f64>, y: &Range<f64>, known_from: f64) -> Drawn {
    let highest = orders.iter().copied().max().map_or(1.0, f64::from);
    let (width, height) = (x.end - x.start, y.end - y.start);
    let leg = (0.3 * (x.end - known_from) / highest).min(0.2 * height).min(TALLEST);
    let right = known_from + 0.05 * width + highest * leg;
    let (bottom, top) = (y.start + 0.05 * height, y.start + 0.05 * height + leg);
    let line = GREY.stroke_width(SCALE as u32);
    inside.draw(&PathElement::new(vec![(right, bottom), (right, top), (right - highest * leg, top)], line))?;
    for order in orders {
        let left = right - leg * f64::from(*order);
        inside.draw(&PathElement::new(vec![(right, bottom), (left, top)], line))?;
        let style =
            (FONT, 13 * SCALE).with_color(INK).into_text_style(inside).pos(Pos::new(HPos::Center, VPos::Bottom));
        inside.draw(&Text::new(order.to_string(), (left, top + 0.008 * height), style))?;
    }
    let style = (FONT, 13 * SCALE).with_color(INK).into_text_style(inside).pos(Pos::new(HPos::Left, VPos::Bottom));
    inside.draw(&Text::new("order".to_owned(), (right + 0.01 * width, top + 0.008 * height), style))
}
