//! The observed order of accuracy: the slope of error against time step, both on logarithmic axes.

/// What a sweep over time steps showed.
#[derive(Clone, Debug)]
pub struct Order {
    /// The time steps, s.
    pub time_steps: Vec<f64>,
    /// The error at each.
    pub errors: Vec<f64>,
    /// The slope of the straight line closest to all points in the least-squares sense.
    pub slope: f64,
    /// The slope from each point to the next.
    pub pairwise: Vec<f64>,
}

/// Measures `error(dt)` at every time step and the slopes between.
///
/// An error of 0, infinity or NaN has no logarithm: it makes the slopes NaN, which passes no comparison.
///
/// # Panics
/// There are fewer than two time steps.
pub fn observed(time_steps: &[f64], error: impl FnMut(f64) -> f64) -> Order {
    assert!(time_steps.len() >= 2, "a slope takes two points");
    let errors: Vec<f64> = time_steps.iter().copied().map(error).collect();
    let points: Vec<[f64; 2]> = time_steps.iter().zip(&errors).map(|(dt, error)| [dt.ln(), error.ln()]).collect();
    let pairwise = points.windows(2).map(|pair| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]));
    Order { slope: least_squares_slope(&points), pairwise: pairwise.collect(), time_steps: time_steps.to_vec(), errors }
}

/// Σ (x − x̄)(y − ȳ) / Σ (x − x̄)²
fn least_squares_slope(points: &[[f64; 2]]) -> f64 {
    let mean = |axis: usize| points.iter().map(|p| p[axis]).sum::<f64>() / points.len() as f64;
    let [x_mean, y_mean] = [mean(0), mean(1)];
    let covariance: f64 = points.iter().map(|[x, y]| (x - x_mean) * (y - y_mean)).sum();
    let variance: f64 = points.iter().map(|[x, _]| (x - x_mean).powi(2)).sum();
    covariance / variance
}
