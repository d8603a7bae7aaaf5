//! Every scene that ships runs to its end, and its ledger shows the stepper's own error and nothing else.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::path::Path;

use hooke_runner::scene::{Scene, StepperName, TimeStep};
use hooke_runner::simulate::{Ending, Summary};
use hooke_tests::order::{Order, observed};
use hooke_tests::scene_runs::{run_scene, shipped};

/// The relative remainder over the first `duration` seconds, at most the scene's own.
fn remainder(path: &Path, stepper: StepperName, dt: f64, duration: f64) -> f64 {
    let (summary, _) = run_scene::<f64>(path, |settings| {
        settings.stepper = stepper;
        settings.time_step = TimeStep::Seconds(dt);
        settings.duration = duration.min(settings.duration);
        // Far below the error of the steps, so that what is measured is that of the method.
        settings.tolerance = 1e-9;
    });
    let balance = summary.balance.unwrap();
    assert_eq!(summary.ending, Ending::Finished, "{}", path.display());
    assert_eq!(summary.capped, 0, "{}", path.display());
    balance.remainder().abs() / balance.scale()
}

fn time_step(path: &Path) -> Option<f64> {
    match Scene::load(path).unwrap().settings().time_step {
        TimeStep::Seconds(seconds) => Some(seconds),
        TimeStep::Auto => None,
    }
}

fn order(path: &Path, stepper: StepperName, longest: f64, duration: f64) -> Order {
    observed(&[longest, 0.5 * longest, 0.25 * longest], |dt| remainder(path, stepper, dt, duration))
}

fn flies_only(summary: &Summary) -> bool {
    summary.time_step.is_none()
}

#[test]
fn every_scene_runs_to_its_end_as_it_is() {
    let scenes = shipped();
    assert!(scenes.len() >= 8, "{} scenes", scenes.len());
    for path in scenes {
        let (summary, frames) = run_scene::<f32>(&path, |settings| settings.duration = settings.duration.min(2.0));
        assert!(summary.succeeded(), "{}: {summary:?}", path.display());
        assert_eq!(frames.len() as u64, summary.schedule.frames(), "{}", path.display());
    }
}

#[test]
fn exact_flight_leaves_no_remainder() {
    let mut flights = 0;
    for path in shipped() {
        let (summary, _) = run_scene::<f64>(&path, |settings| settings.duration = settings.duration.min(4.0));
        if flies_only(&summary) {
            flights += 1;
            let balance = summary.balance.unwrap();
            assert!(balance.remainder().abs() < 1e-12 * balance.scale(), "{}: {balance:?}", path.display());
        }
    }
    assert!(flights >= 2, "scenes in exact flight: {flights}");
}

#[test]
fn verlets_remainder_is_of_second_order() {
    for path in shipped() {
        let Some(dt) = time_step(&path) else { continue };
        let (longest, duration) = if is_stiff(&path) { (1e-5, 0.1) } else { (dt, 1.0) };
        let order = order(&path, StepperName::VelocityVerlet, longest, duration);
        assert!((1.9..2.1).contains(&order.slope), "{}: {order:?}", path.display());
    }
}

#[test]
fn semi_implicit_eulers_remainder_is_of_first_order() {
    for path in shipped() {
        let Some(dt) = time_step(&path) else { continue };
        let (longest, duration) = if is_stiff(&path) { (1e-5, 0.1) } else { (0.25 * dt, 0.5) };
        let order = order(&path, StepperName::SemiImplicitEuler, longest, duration);
        assert!((0.8..1.3).contains(&order.slope), "{}: {order:?}", path.display());
    }
}

#[test]
fn implicit_eulers_remainder_is_of_first_order() {
    for path in shipped() {
        let Some(dt) = time_step(&path) else { continue };
        let (longest, duration) = if is_stiff(&path) { (1e-5, 2e-3) } else { (0.125 * dt, 0.02) };
        let order = order(&path, StepperName::ImplicitEuler, longest, duration);
        assert!((0.8..1.2).contains(&order.slope), "{}: {order:?}", path.display());
    }
}

/// Its fastest oscillation has a period of 0.3 ms: only below that is there an order to be seen.
fn is_stiff(path: &Path) -> bool {
    path.ends_with("stiff-rope.toml")
}
