//! The steppers on the trusted trajectories: how fast their error falls, and how large it is where others agree on it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::measure;
use hooke_tests::runs::Run;
use hooke_tests::scenes;
use hooke_tests::trusted::Trusted;

const SCENES: [&str; 2] = ["cloth-32", "rope-100"];

/// Three programs agree on these to the seven digits given (tests/reference/README.md).
#[test]
fn semi_implicit_euler_misses_by_what_three_programs_agree_on() {
    for (name, expected) in SCENES.into_iter().zip([5.163_268e-3, 7.012_999e-3]) {
        let error = error(name, StepperName::SemiImplicitEuler, 1.0, 1000);
        // Half of the last digit given.
        assert!((error - expected).abs() < 0.5e-9, "{name}: {error:e}");
    }
}

#[test]
fn errors_fall_at_the_order_of_the_stepper() {
    use StepperName::{Auto, ExplicitEuler, ImplicitEuler, ImplicitEulerLinearised, SemiImplicitEuler, VelocityVerlet};
    // Steps per quarter of a second: few enough that explicit Euler, unstable at the fastest modes, stays in range.
    for (stepper, counts, order) in [
        (ExplicitEuler, [2000, 4000], 1.0),
        (SemiImplicitEuler, [500, 1000], 1.0),
        (ImplicitEuler, [1000, 2000], 1.0),
        (ImplicitEulerLinearised, [1000, 2000], 1.0),
        (VelocityVerlet, [500, 1000], 2.0),
        (Auto, [500, 1000], 2.0),
    ] {
        for name in SCENES {
            let [coarse, fine] = counts.map(|count| error(name, stepper, 0.25, count));
            let found = (coarse / fine).log2();
            // The next term is h/2 times the leading one or so, and h = ω dt is 0.1 … 0.6 at the fastest modes.
            assert!((found - order).abs() < 0.2, "{name}, {stepper}: {found}, {coarse:e}, {fine:e}");
        }
    }
}

/// Verlet's error goes down, as its square, to where the references themselves end.
#[test]
fn verlet_reaches_what_the_references_can_tell() {
    for name in SCENES {
        let [coarse, fine] = [4000, 32000].map(|count| error(name, StepperName::VelocityVerlet, 0.25, count));
        // The references can be trusted to 1e-9 or so at 1 s, and to less than 1e-10 at a quarter of it.
        assert!((coarse / fine / 64.0 - 1.0).abs() < 0.1, "{name}: {coarse:e}, {fine:e}");
        assert!(fine < 1e-7, "{name}: {fine:e}");
    }
}

/// The largest distance of any particle, m, from the trusted state at a time (s) that `count` steps lead to.
fn error(name: &str, stepper: StepperName, time: f64, count: usize) -> f64 {
    let (model, settings) = scenes::load(name);
    let trusted = Trusted::read(name).unwrap();
    let number = trusted.time.iter().position(|other| *other == time).unwrap();
    let mut run =
        Run::<f64>::new(&model, settings.gravity, stepper, CollisionForm::Reflect).with_tolerance(stepper, 1e-8);
    run.steps(count, time / count as f64);
    measure::position_error(&run.moment(), &trusted.moments[number])
}
