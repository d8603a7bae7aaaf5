//! How curves are told apart: by colour and shape of their marks, and by dashes.

use plotters::style::RGBColor;

/// Red, green and blue.
pub type Colour = RGBColor;

/// What stands back.
pub const GREY: Colour = RGBColor(0x90, 0x94, 0x98);

/// Colours that people of all kinds of sight tell apart, on white and on black, in an order in which neighbours differ in
/// lightness too (after Okabe and Ito, and Tol).
const COLOURS: [Colour; 12] = [
    RGBColor(0x99, 0x33, 0x66),
    RGBColor(0xE6, 0x84, 0x9B),
    RGBColor(0x70, 0x5C, 0xD6),
    RGBColor(0x8F, 0xB4, 0xE8),
    RGBColor(0xB8, 0x55, 0xB0),
    RGBColor(0xDD, 0xAA, 0x22),
    RGBColor(0x1B, 0x8A, 0x4B),
    RGBColor(0xE0, 0x6C, 0x1F),
    RGBColor(0x00, 0x77, 0xBB),
    RGBColor(0x2F, 0xB5, 0xC9),
    RGBColor(0x7D, 0x55, 0x32),
    RGBColor(0x8A, 0x7F, 0x1E),
];

/// The outline of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// ●
    Circle,
    /// ■
    Square,
    /// ◆
    Diamond,
    /// ▲
    Up,
    /// ▼
    Down,
}

const SHAPES: [Shape; 5] = [Shape::Circle, Shape::Square, Shape::Diamond, Shape::Up, Shape::Down];

/// How a line is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Not at all.
    Solid,
    /// Long dashes.
    Dashed,
    /// Short ones.
    Dotted,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Of line and marks.
    pub colour: Colour,
    /// Of the line.
    pub dash: Dash,
    /// Of the marks; nothing for a line without them.
    pub shape: Option<Shape>,
    /// Whether marks are filled.
    pub is_filled: bool,
    /// Whether it is drawn thin.
    pub is_thin: bool,
}

/// The colour and the shape of the curve with this number: no two of the first sixty have both in common.
#[must_use]
pub fn colour(number: usize) -> (Colour, Shape) {
    let of = |count: usize| number % count;
    (
        COLOURS.get(of(COLOURS.len())).copied().unwrap_or(GREY),
        SHAPES.get(of(SHAPES.len())).copied().unwrap_or(Shape::Circle),
    )
}

/// For what stands back: grey, and told apart by shape, filling and dashes; no two of the first fifteen are the same.
#[must_use]
pub fn grey(number: usize) -> Look {
    let (_, shape) = colour(number);
    let round = number / SHAPES.len();
    let dash = match round {
        0 => Dash::Solid,
        1 => Dash::Dashed,
        _ => Dash::Dotted,
    };
    Look { colour: GREY, dash, shape: Some(shape), is_filled: round.is_multiple_of(2), is_thin: true }
}
