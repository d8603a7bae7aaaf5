//! Frames between two steps, as exact as a step is.

/// Where a particle is (m), how fast it moves (m/s), and how fast that changes (m/s²).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knot {
    /// m
    pub position: [f64; 3],
    /// m/s
    pub velocity: [f64; 3],
    /// m/s²
    pub acceleration: [f64; 3],
}

/// The quintic Hermite curve through two moments `duration` seconds apart, at the fraction `s` of the way: its position
/// (m) and velocity (m/s). Its error is (duration/2)⁶/720 times the sixth derivative at most.
#[must_use]
pub fn quintic(start: &Knot, end: &Knot, duration: f64, s: f64) -> ([f64; 3], [f64; 3]) {
    let t = 1.0 - s;
    // Of the end's; the start's are those seen from the other side.
    let place = |s: f64| s * s * s * (10.0 + s * (6.0 * s - 15.0));
    let speed = |s: f64| s * s * s * (-4.0 + s * (7.0 - 3.0 * s));
    let bend = |s: f64| 0.5 * s * s * s * (1.0 + s * (s - 2.0));
    let place_rate = |s: f64| 30.0 * s * s * (1.0 + s * (s - 2.0));
    let speed_rate = |s: f64| s * s * (-12.0 + s * (28.0 - 15.0 * s));
    let bend_rate = |s: f64| 0.5 * s * s * (3.0 + s * (5.0 * s - 8.0));
    let h = duration;
    let mut at = ([0.0; 3], [0.0; 3]);
    for axis in 0..3 {
        let of = |knot: &Knot| (knot.position[axis], knot.velocity[axis], knot.acceleration[axis]);
        let ((x_0, v_0, a_0), (x_1, v_1, a_1)) = (of(start), of(end));
        at.0[axis] = x_0 + place(s) * (x_1 - x_0) - speed(t) * h * v_0
            + speed(s) * h * v_1
            + bend(t) * h * h * a_0
            + bend(s) * h * h * a_1;
        at.1[axis] = place_rate(s) * ((x_1 - x_0) / h) + speed_rate(t) * v_0 + speed_rate(s) * v_1
            - bend_rate(t) * h * a_0
            + bend_rate(s) * h * a_1;
    }
    at
}
