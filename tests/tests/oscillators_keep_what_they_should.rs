//! Over 100,000 steps an oscillator's energy does what theory says of each stepper.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use glam::DVec3;
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::problems::oscillator::Oscillator;
use hooke_tests::problems::skew;
use hooke_tests::runs::Run;

const STEPS: usize = 100_000;

/// Extension over the swing's size (m), and velocity over ω times that, after each of so many steps.
fn swing(stepper: StepperName, h: f64, count: usize, mut look: impl FnMut([f64; 2])) {
    let oscillator = Oscillator::default();
    let problem = oscillator.problem();
    let mut run =
        Run::<f64>::new(&problem.model, [0.0; 3], stepper, CollisionForm::Reflect).with_tolerance(stepper, 1e-14);
    let along = skew() * DVec3::X;
    for _ in 0..count {
        run.steps(1, h / oscillator.frequency());
        let [x, v] = [run.world.position(1), run.world.velocity(1)].map(|vector| along.dot(vector.unwrap()));
        look([x - oscillator.rest_length, v / oscillator.frequency()]);
    }
}

fn start() -> [f64; 2] {
    let oscillator = Oscillator::default();
    [oscillator.displacement, oscillator.velocity / oscillator.frequency()]
}

/// x² + v²/ω² − h·x·v/ω is kept by semi-implicit Euler, and x² (1 − h²/4) + v²/ω² by Verlet.
#[test]
fn symplectic_steppers_keep_their_own_energy() {
    type Invariant = fn([f64; 2], f64) -> f64;
    let steppers: [(StepperName, Invariant); 3] = [
        (StepperName::SemiImplicitEuler, |[x, v], h| x * x + v * v - h * x * v),
        (StepperName::VelocityVerlet, |[x, v], h| x * x * (1.0 - 0.25 * h * h) + v * v),
        (StepperName::Auto, |[x, v], h| x * x * (1.0 - 0.25 * h * h) + v * v),
    ];
    for (stepper, invariant) in steppers {
        for h in [0.02, 0.7, 1.8] {
            let kept = invariant(start(), h);
            let (mut drift, mut spread) = (0.0_f64, 0.0_f64);
            swing(stepper, h, STEPS, |state| {
                drift = drift.max((invariant(state, h) / kept - 1.0).abs());
                spread = spread.max((state[0].powi(2) + state[1].powi(2)) / kept);
            });
            // Each step rounds a length of 0.7 m by 1e-16, 1e-15 of the swing; they add up at random, or all one way
            // at worst: 1e5 × 1e-15.
            assert!(drift < 1e-10, "{stepper}, {h}: {drift:e}");
            // The energy itself swings, but by no more than the ellipse is long.
            assert!(spread < 2.0 / (1.0 - 0.5 * h).min(1.0 - 0.25 * h * h), "{stepper}, {h}: {spread}");
        }
    }
}

/// Another stepper's invariant is not kept: the test above can tell.
#[test]
fn explicit_euler_gains_what_it_must() {
    let (h, count) = (0.01, 10_000);
    let mut last = start();
    swing(StepperName::ExplicitEuler, h, count, |state| last = state);
    let energy = |[x, v]: [f64; 2]| x * x + v * v;
    // By 1 + h² a step, exactly, since its matrix is a rotation but for that factor.
    let expected = (1.0 + h * h).powi(count as i32);
    // 1e4 roundings of 1e-15.
    assert!((energy(last) / energy(start()) / expected - 1.0).abs() < 1e-11);
}

#[test]
fn implicit_euler_loses_what_it_must() {
    for stepper in [StepperName::ImplicitEuler, StepperName::ImplicitEulerLinearised] {
        for (h, count) in [(0.01_f64, 10_000), (0.3, 40), (3.0, 4)] {
            let mut last = start();
            swing(stepper, h, count, |state| last = state);
            let energy = |[x, v]: [f64; 2]| x * x + v * v;
            let expected = (1.0 + h * h).powi(-(count as i32));
            let found = energy(last) / energy(start());
            // Rounding of the length, 1e-16 m, beside what is left of the swing: 0.03 of it in the middle case.
            assert!((found / expected - 1.0).abs() < 1e-9, "{stepper}, {h}: {found:e}, not {expected:e}");
        }
    }
}
