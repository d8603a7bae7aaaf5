//! `hooke bench` before planes: the forms of collision, when things bounce, how deep they get.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use std::io::Write;
use std::sync::atomic::AtomicBool;

use hooke_runner::bench::{Asked, Compared, Point, Reference, measure};
use hooke_runner::model::Model;
use hooke_runner::scene::{CollisionForm, Precision, Scene, Settings, StepperName};

/// It hits at √0.2 s, twice as late again, and the last time before the end at five times that.
const BALL: &str = "gravity = [0.0, 0.0, -10.0]\nduration = 2.0\n\
    [[particle]]\nposition = [0.0, 0.0, 1.0]\n\
    [[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n";

/// At rest 0.2 m above the plane, ω = 10/s, let go 0.3 m higher: it hits at 5 m/s times √(0.3² − 0.2²) / 0.5.
const SPRUNG: &str = "duration = 1.0\n\
    [[particle]]\nposition = [0.0, 0.0, 2.0]\npinned = true\n\
    [[particle]]\nposition = [0.0, 0.0, 0.5]\n\
    [[spring]]\nbetween = [0, 1]\nstiffness = 100.0\nrest_length = 1.8\n\
    [[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n";

fn load(toml: &str) -> (Model, Settings) {
    let mut file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    file.write_all(toml.as_bytes()).unwrap();
    let scene = Scene::load(file.path()).expect("a sound scene");
    (scene.model().unwrap(), scene.settings().clone())
}

/// One run of a scene.
fn run(toml: &str, stepper: StepperName, collision: CollisionForm, asked: impl Into<Asked>) -> (Reference, Point) {
    let (model, settings) = load(toml);
    let settings = Settings { stepper, collision, precision: Precision::F64, ..settings };
    let never = AtomicBool::new(false);
    let reference = Reference::of(&model, &settings, &never).unwrap().unwrap();
    let point = measure(&model, &settings, asked, &reference, Compared::Throughout, &never).unwrap().unwrap();
    (reference, point)
}

#[test]
fn time_of_impact_is_exact_and_ends_of_steps_are_late_and_deep() {
    // 7.35 ms: no hit falls on the end of a step, nor near one.
    let steps = 272_u64;
    let step = 2.0 / steps as f64;
    let verlet = |collision| run(BALL, StepperName::VelocityVerlet, collision, steps);
    let (reference, exact) = verlet(CollisionForm::TimeOfImpact);
    let times = &reference.bounces.as_ref().unwrap().times[0];
    let fall = 0.2_f64.sqrt();
    assert_eq!(times.len(), 2, "{times:?}");
    assert!((times[0] - fall).abs() < 1e-12 && (times[1] - 3.0 * fall).abs() < 1e-12, "{times:?}");
    // Arcs are exact with Verlet: what is left is rounding of some hundred steps.
    assert!(exact.bounce_time_error.unwrap() < 1e-12 && exact.penetration.unwrap() < 1e-12, "{exact:?}");
    assert!(exact.error.unwrap() < 1e-11, "{exact:?}");

    let (_, reflected) = verlet(CollisionForm::Reflect);
    // Late by part of a step at each hit, and as deep as it falls in so long, at √20 m/s.
    let late = reflected.bounce_time_error.unwrap();
    assert!((0.01 * step..3.0 * step).contains(&late), "{late:e}");
    let deep = reflected.penetration.unwrap();
    assert!((1e-3 * step..step * 20.0_f64.sqrt()).contains(&deep), "{deep:e}");

    let (_, projected) = verlet(CollisionForm::Project);
    assert!((0.01 * step..3.0 * step).contains(&projected.bounce_time_error.unwrap()), "{projected:?}");
    // It has been put back by the end of the step.
    assert!(projected.penetration.unwrap() < 1e-12, "{projected:?}");
}

/// x = 0.2 + 0.3 cos 10 t reaches 0 at t1 = acos(−2/3) / 10; all is elastic, so it is back at the plane after the same time
/// twice. Hits inside of steps are as exact as the stepper, the others as late as the end of the step.
#[test]
fn hits_under_a_spring_are_timed_to_the_order_of_the_stepper() {
    let (reference, _) = run(SPRUNG, StepperName::Dop853, CollisionForm::TimeOfImpact, 64_u64);
    let first = (-2.0_f64 / 3.0).acos() / 10.0;
    let times = &reference.bounces.as_ref().unwrap().times[1];
    assert!(times.len() >= 2, "{times:?}");
    for (number, time) in times.iter().enumerate() {
        let expected = first * (2 * number + 1) as f64;
        // Rounding of some hundred steps, and of the hit at 2 m/s.
        assert!((time - expected).abs() < 1e-12, "{time} for {expected}");
    }
    for (tolerance, most) in [(6, 1e-5), (10, 1e-9)] {
        let (_, chosen) = run(SPRUNG, StepperName::Dop853, CollisionForm::TimeOfImpact, Asked::Tolerance(tolerance));
        // Errors of some tens of steps, at more than 1 m/s.
        assert!(chosen.bounce_time_error.unwrap() < most && chosen.penetration.unwrap() < most, "{chosen:?}");
    }
    let late = |stepper, collision, steps: u64| run(SPRUNG, stepper, collision, steps).1.bounce_time_error.unwrap();
    let verlet = |steps| late(StepperName::VelocityVerlet, CollisionForm::TimeOfImpact, steps);
    let order = (verlet(256) / verlet(1024)).log2() / 2.0;
    // Where a hit falls in its step makes some difference.
    assert!((order - 2.0).abs() < 0.2, "{order}");
    let rk4 = late(StepperName::Rk4, CollisionForm::TimeOfImpact, 256);
    assert!(rk4 < 1e-3 * verlet(256), "{rk4:e}");
    let reflected = late(StepperName::Dop853, CollisionForm::Reflect, 512);
    // At the end of its step, and later ones late by what came before.
    assert!((0.01 / 512.0..4.0 / 512.0).contains(&reflected), "{reflected:e}");
}
