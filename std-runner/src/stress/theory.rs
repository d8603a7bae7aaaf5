//! Where theory puts the largest stable step of one damped oscillator, in radians: h = ω dt.

use crate::scene::StepperName;

/// The limit on h of a stepper at a damping ratio, where there is a formula; infinite where nothing limits it.
#[must_use]
pub fn oscillator_limit(stepper: StepperName, damping_ratio: f64) -> Option<f64> {
    let zeta = damping_ratio;
    match stepper {
        StepperName::ExplicitEuler if zeta <= 1.0 => Some(2.0 * zeta),
        // 2(ζ − √(ζ² − 1)), without the difference.
        StepperName::ExplicitEuler => Some(2.0 / (zeta + (zeta * zeta - 1.0).sqrt())),
        StepperName::SemiImplicitEuler => Some(semi_implicit(zeta)),
        // The acceleration that it keeps is as if the damping were twice as strong.
        StepperName::VelocityVerlet => Some(semi_implicit(2.0 * zeta)),
        StepperName::Rk4 => Some(runge_kutta(zeta)),
        StepperName::ImplicitEuler
        | StepperName::ImplicitEulerLinearised
        | StepperName::ImplicitMidpoint
        | StepperName::TrBdf2 => Some(f64::INFINITY),
        _ => None,
    }
}

/// 2(√(1 + ζ²) − ζ), without the difference.
fn semi_implicit(zeta: f64) -> f64 {
    2.0 / (1.0_f64.hypot(zeta) + zeta)
}

/// Where |1 + z + z²/2 + z³/6 + z⁴/24| first exceeds 1, z being h times an eigenvalue of the oscillator.
fn runge_kutta(zeta: f64) -> f64 {
    // It is stable up to 2.5 at any ζ up to 1; past that the faster of two decays limits it.
    let grows = |h: f64| eigenvalues(zeta, h).into_iter().any(|z| polynomial(z) > 1.0);
    let (mut stable, mut unstable) = (0.0, 3.5);
    let first = (1..=3500).map(|part| f64::from(part) * 1e-3).find(|h| *h > 0.1 && grows(*h));
    if let Some(first) = first {
        (stable, unstable) = (first - 1e-3, first);
    }
    while unstable - stable > 1e-9 {
        let middle = 0.5 * (stable + unstable);
        if grows(middle) {
            unstable = middle;
        } else {
            stable = middle;
        }
    }
    unstable
}

/// h (−ζ ± √(ζ² − 1)), real and imaginary part.
fn eigenvalues(zeta: f64, h: f64) -> [[f64; 2]; 2] {
    let root = (zeta * zeta - 1.0).abs().sqrt();
    [1.0, -1.0].map(|sign| if zeta < 1.0 { [-zeta * h, sign * root * h] } else { [(sign * root - zeta) * h, 0.0] })
}

/// |1 + z + z²/2 + z³/6 + z⁴/24|², by Horner's rule.
fn polynomial([a, b]: [f64; 2]) -> f64 {
    let [x, y] = [4.0, 3.0, 2.0, 1.0]
        .into_iter()
        .fold([1.0, 0.0], |[x, y], divisor| [1.0 + (x * a - y * b) / divisor, (x * b + y * a) / divisor]);
    x * x + y * y
}
