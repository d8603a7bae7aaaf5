//! How large a time step may be on the damped oscillator ẍ = −x − 2ζẋ, in units of 1/ω: h = ω dt.
//!
//! Closed forms come from the amplification matrix of one step; where there is none,
//! the matrix is built from the step itself and its spectral radius is computed.

/// One step of a linear method on (x, v, a), a being an acceleration kept from the step before if the method keeps one.
pub type Step = fn(state: [f64; 3], zeta: f64, h: f64) -> [f64; 3];

/// −x − 2ζv
fn acceleration(x: f64, v: f64, zeta: f64) -> f64 {
    -x - 2.0 * zeta * v
}

/// v' = v + h a(x, v), x' = x + h v
#[must_use]
pub fn explicit_euler([x, v, _]: [f64; 3], zeta: f64, h: f64) -> [f64; 3] {
    [x + h * v, v + h * acceleration(x, v, zeta), 0.0]
}

/// v' = v + h a(x, v), x' = x + h v'
#[must_use]
pub fn semi_implicit_euler([x, v, _]: [f64; 3], zeta: f64, h: f64) -> [f64; 3] {
    let v = v + h * acceleration(x, v, zeta);
    [x + h * v, v, 0.0]
}

/// v' = v + h (−x − 2ζv'), x' = x + h v': only the damping is implicit.
#[must_use]
pub fn semi_implicit_euler_damping_implicit([x, v, _]: [f64; 3], zeta: f64, h: f64) -> [f64; 3] {
    let v = (v - h * x) / (1.0 + 2.0 * zeta * h);
    [x + h * v, v, 0.0]
}

/// v' = v + h a(x', v'), x' = x + h v'
#[must_use]
pub fn implicit_euler([x, v, _]: [f64; 3], zeta: f64, h: f64) -> [f64; 3] {
    let v = (v - h * x) / (1.0 + 2.0 * zeta * h + h * h);
    [x + h * v, v, 0.0]
}

/// Velocity Verlet with the damping at the predicted velocity v + h a, where a = a(x, v) is computed anew:
/// two force evaluations a step where there is damping.
#[must_use]
pub fn verlet_fresh([x, v, _]: [f64; 3], zeta: f64, h: f64) -> [f64; 3] {
    verlet_kept([x, v, acceleration(x, v, zeta)], zeta, h)
}

/// The same where a is what the step before computed, at its own predicted velocity: one force evaluation a step.
///
/// v½ = v + ½h a, x' = x + h v½, a' = a(x', v + h a), v' = v½ + ½h a'
#[must_use]
pub fn verlet_kept([x, v, a]: [f64; 3], zeta: f64, h: f64) -> [f64; 3] {
    let half = v + 0.5 * h * a;
    let x = x + h * half;
    let next = acceleration(x, v + h * a, zeta);
    [x, half + 0.5 * h * next, next]
}

/// The same with the damping at the velocity v½, which lags half a step behind x'.
#[must_use]
pub fn verlet_lagged([x, v, a]: [f64; 3], zeta: f64, h: f64) -> [f64; 3] {
    let half = v + 0.5 * h * a;
    let x = x + h * half;
    let next = acceleration(x, half, zeta);
    [x, half + 0.5 * h * next, next]
}

/// The first three kicks of S₆, which its last three mirror (Blanes and Moan 2002).
pub const KICKS: [f64; 3] = [0.209515106613362, -0.143851773179818, 0.434336666566456];

/// The first three drifts, which the last three mirror, and the one in the middle.
const DRIFTS: [f64; 4] = [0.0792036964311957, 0.353172906049774, -0.0420650803577195, 0.2193769557534996];

/// Drifts x' = x + a h v and kicks by turns, each kick the first four terms of the series of v′ = −x − 2ζv.
#[must_use]
pub fn blanes_moan_s6([mut x, mut v, _]: [f64; 3], zeta: f64, h: f64) -> [f64; 3] {
    let [a_1, a_2, a_3, a_4] = DRIFTS;
    let [b_1, b_2, b_3] = KICKS;
    for (a, b) in [(a_1, b_1), (a_2, b_2), (a_3, b_3), (a_4, b_3), (a_3, b_2), (a_2, b_1), (a_1, 0.0)] {
        x += a * h * v;
        let mut term = acceleration(x, v, zeta);
        for order in [1.0, 2.0, 3.0, 4.0] {
            term *= b * h / order;
            v += term;
            term *= -2.0 * zeta;
        }
    }
    [x, v, 0.0]
}

/// h below which explicit Euler is stable: 2ζ for ζ ≤ 1, else 2(ζ − √(ζ² − 1)), written without the difference.
#[must_use]
pub fn explicit_euler_limit(zeta: f64) -> f64 {
    if zeta <= 1.0 { 2.0 * zeta } else { 2.0 / (zeta + (zeta * zeta - 1.0).sqrt()) }
}

/// h below which semi-implicit Euler is stable: 2(√(1 + ζ²) − ζ), written without the difference.
#[must_use]
pub fn semi_implicit_euler_limit(zeta: f64) -> f64 {
    2.0 / (1.0f64.hypot(zeta) + zeta)
}

/// h below which semi-implicit Euler with implicit damping is stable: 2(√(1 + ζ²) + ζ).
#[must_use]
pub fn semi_implicit_euler_damping_implicit_limit(zeta: f64) -> f64 {
    2.0 * (1.0f64.hypot(zeta) + zeta)
}

/// h below which [`verlet_fresh`] is stable: 2/(√(1 − 3ζ²) + ζ) for ζ ≤ ½, else 1/ζ.
///
/// Its matrix has 1 + trace + determinant = 4 − 4ζh + (4ζ² − 1)h² and 1 − trace + determinant = h²(1 − ζh):
/// the first to vanish sends an eigenvalue through −1 or 1.
#[must_use]
pub fn verlet_fresh_limit(zeta: f64) -> f64 {
    if zeta <= 0.5 { 2.0 / ((1.0 - 3.0 * zeta * zeta).sqrt() + zeta) } else { 1.0 / zeta }
}

/// h below which [`verlet_kept`] is stable: 2(√(1 + 4ζ²) − 2ζ), which is semi-implicit Euler's at twice the damping.
#[must_use]
pub fn verlet_kept_limit(zeta: f64) -> f64 {
    semi_implicit_euler_limit(2.0 * zeta)
}

/// The largest magnitude of an eigenvalue of a step's amplification matrix.
///
/// By Gelfand's formula, ρ = lim ‖Mⁿ‖^{1/n}, n doubled 40 times: whatever Mⁿ grows by as a power of n is 1 + 1e-10 by then.
#[must_use]
pub fn spectral_radius(step: Step, zeta: f64, h: f64) -> f64 {
    let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Columns in place of rows: a matrix and its transpose have the same eigenvalues.
    let mut matrix = columns.map(|unit| step(unit, zeta, h));
    let mut logarithm = 0.0;
    let mut power = 1.0;
    for _ in 0..40 {
        let norm = matrix.as_flattened().iter().map(|m| m * m).sum::<f64>().sqrt();
        if norm == 0.0 {
            return 0.0;
        }
        logarithm += norm.ln() / power;
        let scaled = matrix.map(|row| row.map(|entry| entry / norm));
        matrix = scaled.map(|row| std::array::from_fn(|column| (0..3).map(|k| row[k] * scaled[k][column]).sum()));
        power *= 2.0;
    }
    logarithm.exp()
}

/// The smallest h up to `largest` at which a step begins to amplify, to 1e-9; `None` if it never does.
#[must_use]
pub fn limit(step: Step, zeta: f64, largest: f64) -> Option<f64> {
    // An amplification below this is what rounding and Gelfand's formula leave of 1.
    let grows = |h: f64| spectral_radius(step, zeta, h) > 1.0 + 1e-9;
    let width = 1e-3;
    let count = (largest / width) as u32;
    let first = (1..=count).find(|&number| grows(f64::from(number) * width))?;
    let (mut stable, mut unstable) = (f64::from(first - 1) * width, f64::from(first) * width);
    while unstable - stable > 1e-9 {
        let middle = 0.5 * (stable + unstable);
        if grows(middle) {
            unstable = middle;
        } else {
            stable = middle;
        }
    }
    Some(unstable)
}
