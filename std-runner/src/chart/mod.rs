//! Charts as SVG: curves over axes that are linear or logarithmic, drawn without any font of the system.
//!
//! Text is written in [`INK`], lines of the grid in [`GRID`], on [`PAPER`]: a page that is dark can recolour these three.

mod axis;
mod legend;
mod look;
mod mark;
mod mosaic;
mod plot;
mod sheet;

pub use axis::{Axis, Scale};
pub use legend::Entry;
pub use look::{Colour, Dash, GREY, Look, Shape, colour, grey};
pub use mosaic::{Mosaic, Mosaics};
pub use sheet::{ChartError, GRID, INK, PAPER, Sheet};

/// Points that belong together, joined in their order.
#[derive(Clone, Debug)]
pub struct Curve {
    /// In the units of the axes; what is no number, or not above 0 on a logarithmic axis, is left out.
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub look: Look,
}

/// Curves over two axes.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Above it.
    pub title: String,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// In the order in which they are drawn.
    pub curves: Vec<Curve>,
    /// Points with a ring around them.
    pub ringed: Vec<(f64, f64)>,
    /// Values of x up to which nothing is known: shaded, with what to write there.
    pub unknown: Option<(f64, String)>,
    /// Orders of accuracy whose slopes are shown at the lower left, for work over error on logarithmic axes: −1/p.
    pub orders: Vec<u32>,
}
