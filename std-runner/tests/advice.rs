//! What is said of a scene before it is run.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::fs;

use hooke_runner::advice::{Advice, Subject, Topic, advise, skipped};
use hooke_runner::scene::{Overrides, Precision, Scene, StepperName, TimeStep};
use hooke_runner::simulate::Start;

const SPRING: &str = "duration = 1.0\ntime_step = 1e-3\n\
    [[particle]]\nposition = [0.0, 0.0, 1.0]\npinned = true\n\
    [[particle]]\nposition = [1.0, 0.0, 1.0]\n\
    [[spring]]\nbetween = [0, 1]\nstiffness = 100.0\n";

const BALL: &str = "gravity = [0.0, 0.0, -10.0]\n[[particle]]\nposition = [0.0, 0.0, 1.0]\n";

fn start(scene: &str, overrides: &Overrides) -> (Scene, Start) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, scene).unwrap();
    let mut scene = Scene::load(&path).unwrap();
    scene.apply(overrides).unwrap();
    let start = Start::of::<f64>(&scene.model().unwrap(), scene.settings()).unwrap();
    (scene, start)
}

fn advice(scene: &str, overrides: &Overrides) -> Vec<Advice> {
    let (scene, start) = start(scene, overrides);
    let model = scene.model().unwrap();
    advise(&Subject { model: &model, settings: scene.settings(), start: &start, recorded_bytes: 0 })
}

#[track_caller]
fn one(scene: &str, overrides: &Overrides, topic: Topic, parts: &[&str]) {
    let advice = advice(scene, overrides);
    let [only] = advice.as_slice() else { panic!("{advice:?}") };
    assert_eq!(only.topic, topic);
    let text = format!("{}\n{}", only.message, only.remedy);
    for part in parts {
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
}

fn with(stepper: StepperName, time_step: f64) -> Overrides {
    let (stepper, time_step) = (Some(stepper), Some(TimeStep::Seconds(time_step)));
    Overrides { stepper, time_step, frame_rate: Some(1.0), precision: Some(Precision::F64), ..Overrides::default() }
}

fn nothing() -> Overrides {
    Overrides::default()
}

#[test]
fn a_sound_scene_has_none() {
    assert_eq!(advice(SPRING, &nothing()), []);
    assert_eq!(advice(BALL, &nothing()), []);
}

#[test]
fn unstable_time_steps_name_the_bound_and_what_sets_it() {
    // ω = 10 rad/s: the bound is 0.2 s.
    let parts = ["250 ms is 1.25 times", "200 ms", "spring 0 (between particles 0 and 1, 100 N/m)", "--time-step 0.01"];
    for stepper in [StepperName::VelocityVerlet, StepperName::SemiImplicitEuler] {
        one(SPRING, &with(stepper, 0.25), Topic::UnstableTimeStep, &parts);
        assert_eq!(advice(SPRING, &with(stepper, 0.19)), []);
    }
    for stepper in [StepperName::ImplicitEuler, StepperName::ImplicitEulerLinearised] {
        assert_eq!(advice(SPRING, &with(stepper, 0.25)), []);
    }
    one(SPRING, &with(StepperName::Auto, 0.25), Topic::ImplicitFallback, &["implicit-euler", "--time-step 0.01"]);
}

#[test]
fn explicit_euler_without_damping_grows() {
    // √(1 + ω²dt²) a step: tenfold in 2 ln 10 / (ω² dt).
    let parts = ["46.05 s", "--stepper semi-implicit-euler --time-step 0.01"];
    one(SPRING, &with(StepperName::ExplicitEuler, 1e-3), Topic::GrowingEnergy, &parts);
    let damped = format!("{SPRING}damping = 0.2\n");
    assert_eq!(advice(&damped, &with(StepperName::ExplicitEuler, 1e-3)), []);
    one(&damped, &with(StepperName::ExplicitEuler, 0.05), Topic::GrowingEnergy, &["50 ms", "2 ms"]);
}

#[test]
fn f32_far_from_the_origin_is_coarse() {
    let far = SPRING.replace("[0.0, 0.0, 1.0]", "[1e4, 0.0, 1.0]").replace("[1.0, 0.0, 1.0]", "[10001.0, 0.0, 1.0]");
    // Seen from its own middle it is not far.
    assert_eq!(advice(&far, &nothing()), []);
    // And with somebody on the other side of the origin that is.
    let wide = format!("{far}[[particle]]\nposition = [-1e4, 0.0, 1.0]\n");
    one(&wide, &nothing(), Topic::CoarsePositions, &["10 km", "976.6 µm", "spring 0", "--precision f64"]);
    assert_eq!(advice(&wide, &Overrides { precision: Some(Precision::F64), ..nothing() }), []);
}

#[test]
fn f32_steps_that_round_away() {
    let scene = "time_step = 1e-4\nstepper = \"velocity-verlet\"\n\
                 [[particle]]\nposition = [1e5, 0.0, 0.0]\nvelocity = [1.0, 0.0, 0.0]\n\
                 [[particle]]\nposition = [-1e5, 0.0, 0.0]";
    one(scene, &nothing(), Topic::LostMotion, &["100 µs", "7.812 mm", "--precision f64"]);
}

/// ω = 10 rad/s over 1 s, a metre wide: 6e-8 m √(1 s/dt) of roundings are 10 (10 dt)²/24 m at dt = (24 × 5.96e-8/1000)^0.4 s.
#[test]
fn f32_steps_below_rounding() {
    let steps =
        |time_step| Overrides { precision: Some(Precision::F32), ..with(StepperName::VelocityVerlet, time_step) };
    let parts =
        ["100 µs", "velocity-verlet gains nothing below about 289.9 µs", "--precision f32-compensated", "2.9e-4"];
    one(SPRING, &steps(1e-4), Topic::BelowRounding, &parts);
    assert_eq!(advice(SPRING, &steps(2e-4)), []);
    let compensated = Overrides { precision: Some(Precision::F32Compensated), ..steps(1e-4) };
    assert_eq!(advice(SPRING, &compensated), []);
}

#[test]
fn particles_beyond_planes() {
    let below = format!("{BALL}[[plane]]\npoint = [0.0, 0.0, 1.5]\nnormal = [0.0, 0.0, 2.0]\n");
    one(&below, &nothing(), Topic::BeyondPlane, &["every free particle starts beyond plane 0", "500 mm", "normal"]);
    let some = format!("{below}[[particle]]\nposition = [0.0, 0.0, 2.0]");
    one(&some, &nothing(), Topic::BeyondPlane, &["1 free particle, the first is number 0, starts beyond plane 0"]);
    let on_it = format!("{BALL}[[plane]]\npoint = [0.0, 0.0, 1.0]\nnormal = [0.0, 0.0, 1.0]\n");
    assert_eq!(advice(&on_it, &nothing()), []);
}

#[test]
fn reflect_lets_things_sink() {
    let floor =
        format!("collision = \"reflect\"\n{BALL}[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n");
    assert_eq!(advice(&floor, &nothing()), []);
    let soft = format!("{floor}restitution = 0.5");
    one(&soft, &nothing(), Topic::SinkingAtRest, &["plane 0", "--collision project"]);
}

#[test]
fn more_frames_than_steps() {
    let parts = ["5000 frames", "1000 steps", "--frame-rate 1000"];
    one(SPRING, &Overrides { frame_rate: Some(5000.0), ..nothing() }, Topic::FramesBetweenSteps, &parts);
}

#[test]
fn large_recordings() {
    let (scene, start) = start(BALL, &nothing());
    let model = scene.model().unwrap();
    let about =
        |recorded_bytes| advise(&Subject { model: &model, settings: scene.settings(), start: &start, recorded_bytes });
    assert_eq!(about(900_000_000), []);
    assert!(about(2_500_000_000)[0].message.ends_with("take about 2.5 GB of disk"));
}

#[test]
fn what_is_left_out_is_told_in_words() {
    let words = |scene| skipped(&start(scene, &nothing()).1.plan).join("\n");
    let spring = words(SPRING);
    for part in ["gravity: it is 0", "spring damping: no spring is damped", "hits: there are no planes"] {
        assert!(spring.contains(part), "{spring}");
    }
    assert_eq!(words(BALL), "spring forces: there are no springs\nhits: there are no planes");
}
