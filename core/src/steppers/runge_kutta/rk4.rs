//! The classical method of order 4.

use super::RungeKutta;
use super::tableau::{FirstOrder, row};

/// Kutta's method of four stages and order 4 (*Beitrag zur näherungsweisen Integration totaler Differentialgleichungen*,
/// 1901).
#[derive(Clone, Copy, Debug)]
pub struct Kutta;

/// The classical Runge-Kutta method: fourth order, four force evaluations a step.
///
/// Undamped it is stable up to ω dt = 2.828, and takes from an oscillation ω⁶dt⁶/72 of its energy a step.
pub type Rk4<R, M> = RungeKutta<R, M, Kutta, 4>;

impl FirstOrder<4> for Kutta {
    const NODES: [f64; 4] = [0.0, 0.5, 0.5, 1.0];
    const MATRIX: [[f64; 4]; 4] = [row(&[]), row(&[0.5]), row(&[0.0, 0.5]), row(&[0.0, 0.0, 1.0])];
    const WEIGHTS: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];
    const ORDER: u32 = 4;
}
