//! The stability limits, and the order of Verlet's variants on a damped oscillator.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_tests::order;
use hooke_tests::problems::harmonic;
use hooke_tests::stability::{self, Step};

/// The largest stable h at a damping ratio.
type Limit = fn(f64) -> f64;

const DAMPING_RATIOS: [f64; 8] = [0.05, 0.1, 0.3, 0.5, 0.7, 1.0, 1.5, 3.0];

#[test]
fn closed_forms_are_where_the_amplification_matrix_crosses_the_unit_circle() {
    let pairs: [(&str, Step, Limit); 5] = [
        ("explicit Euler", stability::explicit_euler, stability::explicit_euler_limit),
        ("semi-implicit Euler", stability::semi_implicit_euler, stability::semi_implicit_euler_limit),
        (
            "semi-implicit Euler, damping implicit",
            stability::semi_implicit_euler_damping_implicit,
            stability::semi_implicit_euler_damping_implicit_limit,
        ),
        ("Verlet, fresh acceleration", stability::verlet_fresh, stability::verlet_fresh_limit),
        ("Verlet, kept acceleration", stability::verlet_kept, stability::verlet_kept_limit),
    ];
    for (name, step, closed) in pairs {
        for zeta in DAMPING_RATIOS {
            let found = stability::limit(step, zeta, 13.0).unwrap();
            // Growth is told from rounding at 1e-9; the slope of the spectral radius at the limit is about ζ or more.
            let error = (found - closed(zeta)).abs();
            assert!(error < 1e-7, "{name}, {zeta}: {found}, not {}", closed(zeta));
        }
    }
}

#[test]
fn without_damping_the_limit_is_two_and_explicit_euler_has_none() {
    for step in [stability::semi_implicit_euler, stability::verlet_fresh, stability::verlet_kept] {
        // Two eigenvalues meet at −1, and a double eigenvalue moves by the root of a perturbation: √1e-15.
        assert!((stability::limit(step, 0.0, 3.0).unwrap() - 2.0).abs() < 1e-7);
    }
    // ρ² = 1 + h²: growth at any h, though below 1e-4 it is under the 1e-9 that counts as growth.
    assert!(stability::limit(stability::explicit_euler, 0.0, 3.0).unwrap() < 1e-4);
    assert_eq!(stability::explicit_euler_limit(0.0), 0.0);
}

#[test]
fn implicit_euler_has_no_limit() {
    for zeta in [0.0, 0.1, 1.0, 3.0] {
        assert_eq!(stability::limit(stability::implicit_euler, zeta, 13.0), None);
    }
    // The magnitude of a complex pair is 1/√(1 + 2ζh + h²).
    let radius = stability::spectral_radius(stability::implicit_euler, 0.1, 2.0);
    assert!((radius - (1.0f64 + 0.4 + 4.0).powf(-0.5)).abs() < 1e-10);
}

/// Verlet's usual limits with the damping at the predicted velocity hold where the acceleration is computed anew.
/// Where the one of the step before is kept, which saves a force evaluation, less is stable than with semi-implicit Euler.
#[test]
fn verlet_loses_stability_when_it_keeps_its_acceleration() {
    let fresh = [2.0, 1.8435, 2.0, 1.0];
    let kept = [2.0, 1.6396, 0.8284, 0.4721];
    for (number, zeta) in [0.0, 0.1, 0.5, 1.0].into_iter().enumerate() {
        assert!((stability::verlet_fresh_limit(zeta) - fresh[number]).abs() < 5e-5);
        assert!((stability::verlet_kept_limit(zeta) - kept[number]).abs() < 5e-5);
        assert!(stability::verlet_kept_limit(zeta) <= stability::semi_implicit_euler_limit(zeta));
    }
}

#[test]
fn verlet_keeps_order_two_with_a_kept_acceleration_and_loses_it_with_a_lagging_velocity() {
    let expected: [(&str, Step, f64); 3] = [
        ("fresh", stability::verlet_fresh, 2.0),
        ("kept", stability::verlet_kept, 2.0),
        ("lagged", stability::verlet_lagged, 1.0),
    ];
    for (name, step, expected) in expected {
        for zeta in [0.1, 0.5] {
            let order = damped_order(step, zeta);
            // The next term of the error is h times smaller: at h = 0.1 … 0.003 it bends the line by a few hundredths.
            assert!((order.slope - expected).abs() < 0.05, "{name}: {order:?}");
        }
    }
}

fn damped_order(step: Step, zeta: f64) -> order::Order {
    let (x0, v0, duration) = (1.0, 0.5, 4.0);
    let time_steps: Vec<f64> = (0..6).map(|halvings| 0.1 / f64::from(1 << halvings)).collect();
    let exact = harmonic::motion(1.0, zeta, x0, v0, duration);
    order::observed(&time_steps, |h| {
        let mut state = [x0, v0, -x0 - 2.0 * zeta * v0];
        for _ in 0..(duration / h).round() as usize {
            state = step(state, zeta, h);
        }
        (state[0] - exact.0).hypot(state[1] - exact.1)
    })
}
