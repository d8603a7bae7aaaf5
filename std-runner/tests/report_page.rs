//! Pages and charts: whole, self-contained, with everything escaped that must be.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use hooke_runner::chart::{Axis, Chart, Curve, Dash, Entry, Look, Scale, Sheet, colour};
use hooke_runner::report::{Block, Page, Section};

fn look(number: usize) -> Look {
    let (colour, shape) = colour(number);
    Look { colour, shape: Some(shape), dash: Dash::Solid, is_filled: true, is_thin: false }
}

fn chart(points: Vec<(f64, f64)>, scale: Scale) -> Chart {
    Chart {
        title: "a < b".to_owned(),
        x: Axis::new("error", scale, |value| format!("{value:e}")),
        y: Axis::new("time", scale, |value| format!("{value:e}")),
        curves: vec![Curve { points, look: look(0) }],
        ringed: Vec::new(),
        unknown: None,
        orders: Vec::new(),
    }
}

fn svg(chart: Chart) -> String {
    Sheet { charts: vec![chart], columns: 1, legend: vec![Entry::Curve(look(0), "x & y".to_owned())] }.svg().unwrap()
}

/// How many marks there are, the legend's included: each is a filled circle and a ring.
fn marks(svg: &str) -> usize {
    svg.matches("<circle").count() / 2
}

#[test]
fn charts_leave_out_what_has_no_place_and_escape_text() {
    let points = vec![(1e-3, 1.0), (0.0, 1.0), (1e-2, f64::NAN), (1e-1, 10.0), (-1.0, 1.0)];
    let drawn = svg(chart(points.clone(), Scale::Logarithmic));
    // Two points and the legend.
    assert_eq!(marks(&drawn), 3);
    assert!(drawn.contains("a &lt; b") && drawn.contains("x &amp; y") && !drawn.contains("NaN"), "{drawn}");
    // 0 and −1 have a place on a linear axis.
    assert_eq!(marks(&svg(chart(points, Scale::Linear))), 5);
}

/// 1e-1 … 1e-3 is three decades on 10 times as many pixels: ticks at each power of ten, and nowhere else.
#[test]
fn ticks_of_logarithmic_axes_are_powers_of_ten() {
    let drawn = svg(chart(vec![(1e-6, 1e-6), (1.0, 1.0)], Scale::Logarithmic));
    for exponent in 0..=6 {
        let tick = if exponent == 0 { "\n1e0\n".to_owned() } else { format!("\n1e-{exponent}\n") };
        assert_eq!(drawn.matches(&tick).count(), 2, "{tick} on both axes");
    }
    assert!(!drawn.contains("\n5e-1\n"));
}

#[test]
fn a_chart_without_points_is_a_chart() {
    assert_eq!(marks(&svg(chart(Vec::new(), Scale::Logarithmic))), 1);
    assert_eq!(marks(&svg(chart(vec![(2.0, 2.0)], Scale::Linear))), 2);
}

#[test]
fn a_page_needs_nothing_but_itself_and_shows_text_as_it_is() {
    let page = Page {
        title: "<script>alert(1)</script> & more".to_owned(),
        lead: String::new(),
        sections: vec![Section {
            heading: "one".to_owned(),
            blocks: vec![
                Block::Text("1 < 2 & 3 > 2".to_owned()),
                Block::Table {
                    rows: vec![vec!["head".to_owned(), "h".to_owned()], vec!["<b>".to_owned(), "cell".to_owned()]],
                    caption: "what".to_owned(),
                },
                Block::Figure { svg: svg(chart(vec![(1.0, 1.0)], Scale::Linear)), caption: "drawn".to_owned() },
            ],
        }],
        made_by: "hooke".to_owned(),
    };
    let html = page.html();
    assert!(!html.contains("<script") && html.contains("&lt;script&gt;alert(1)&lt;/script&gt; &amp; more"));
    assert!(html.contains("1 &lt; 2 &amp; 3 &gt; 2") && html.contains("<th scope=\"row\">&lt;b&gt;</th>"));
    assert!(html.contains("<svg") && html.contains("<style>") && html.starts_with("<!DOCTYPE html>"));
    // The only address is that of SVG's own names, which nobody fetches.
    assert_eq!(html.matches("http").count(), html.matches("xmlns=\"http://www.w3.org/2000/svg\"").count());
    assert!(!html.contains("@import") && !html.contains("src="));
}
