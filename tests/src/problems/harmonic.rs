//! The damped oscillator ẍ + 2ζω ẋ + ω² x = 0, which most of the other problems reduce to.

/// Position in m and velocity in m/s at a time in s.
///
/// `omega` is ω in rad/s, `zeta` is ζ, `x0` and `v0` are the start. From Landau & Lifshitz, "Mechanics", § 25:
///
/// - ζ < 1: x = e^{−ζωt} (x₀ cos `ω_d` t + ((v₀ + ζωx₀)/`ω_d`) sin `ω_d` t), `ω_d` = ω√(1 − ζ²)
/// - ζ = 1: x = e^{−ωt} (x₀ + (v₀ + ωx₀) t)
/// - ζ > 1: x = c₁ e^{r₁t} + c₂ e^{r₂t}, r₁ = −ω/(ζ + √(ζ² − 1)), r₂ = −ω(ζ + √(ζ² − 1)),
///   c₁ = (v₀ − r₂x₀)/(r₁ − r₂), c₂ = (r₁x₀ − v₀)/(r₁ − r₂)
///
/// and their derivatives. r₁ is written without the difference that would cancel at large ζ.
#[must_use]
pub fn motion(omega: f64, zeta: f64, x0: f64, v0: f64, time: f64) -> (f64, f64) {
    if zeta < 1.0 {
        let damped = omega * (1.0 - zeta * zeta).sqrt();
        let decay = (-zeta * omega * time).exp();
        let (sine, cosine) = (damped * time).sin_cos();
        let position = x0 * cosine + (v0 + zeta * omega * x0) / damped * sine;
        let velocity = v0 * cosine - omega * (omega * x0 + zeta * v0) / damped * sine;
        (decay * position, decay * velocity)
    } else if zeta == 1.0 {
        let decay = (-omega * time).exp();
        let slope = v0 + omega * x0;
        (decay * (x0 + slope * time), decay * (v0 - omega * slope * time))
    } else {
        let sum = zeta + (zeta * zeta - 1.0).sqrt();
        let (slow, fast) = (-omega / sum, -omega * sum);
        let slow_part = (v0 - fast * x0) / (slow - fast) * (slow * time).exp();
        let fast_part = (slow * x0 - v0) / (slow - fast) * (fast * time).exp();
        (slow_part + fast_part, slow * slow_part + fast * fast_part)
    }
}
