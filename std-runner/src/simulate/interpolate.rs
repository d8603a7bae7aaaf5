//! Frames between two steps.

use hooke::Real;

/// A position (m) and a velocity (m/s).
pub type Moment<R> = ([R; 3], [R; 3]);

/// The cubic Hermite curve through two moments `duration` seconds apart, at the fraction `s` of the way.
pub fn hermite<R: Real>((x_0, v_0): Moment<R>, (x_1, v_1): Moment<R>, duration: f64, s: f64) -> Moment<R> {
    let weights = [(1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s), s * (1.0 - s) * (1.0 - s) * duration];
    let late = [s * s * (3.0 - 2.0 * s), s * s * (s - 1.0) * duration];
    let slope = 6.0 * s * (1.0 - s) / duration;
    let rates = [(1.0 - s) * (1.0 - 3.0 * s), s * (3.0 * s - 2.0)];
    let each = |axis: usize, of: &dyn Fn([f64; 4]) -> f64| {
        let component = |vector: [R; 3]| vector.get(axis).copied().unwrap_or_default().to_f64();
        R::from_f64(of([component(x_0), component(v_0), component(x_1), component(v_1)]))
    };
    let position = |[x_0, v_0, x_1, v_1]: [f64; 4]| weights[0] * x_0 + weights[1] * v_0 + late[0] * x_1 + late[1] * v_1;
    let velocity = |[x_0, v_0, x_1, v_1]: [f64; 4]| slope * (x_1 - x_0) + rates[0] * v_0 + rates[1] * v_1;
    ([0, 1, 2].map(|axis| each(axis, &position)), [0, 1, 2].map(|axis| each(axis, &velocity)))
}
