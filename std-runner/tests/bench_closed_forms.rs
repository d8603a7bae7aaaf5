//! Scenes that are solved by formulas: they are recognised, and the formulas solve their equations.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use std::io::Write;
use std::sync::atomic::AtomicBool;

use hooke_runner::bench::{ClosedForm, MOMENTS, Reference, position_error, velocity_error};
use hooke_runner::model::Model;
use hooke_runner::scene::{Scene, Settings};

fn load(toml: &str) -> (Model, Settings) {
    let mut file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    file.write_all(toml.as_bytes()).unwrap();
    let scene = Scene::load(file.path()).expect("a sound scene");
    (scene.model().expect("a scene that fits"), scene.settings().clone())
}

fn known(toml: &str) -> Option<ClosedForm> {
    let (model, settings) = load(toml);
    ClosedForm::of(&model, &settings)
}

/// A particle on a spring below a pin, pulled along it.
fn spring(damping: f64, velocity: &str) -> String {
    format!(
        "gravity = [0.0, 0.0, -9.81]\nduration = 2.0\n\
         [[particle]]\nposition = [0.3, 0.2, 2.0]\npinned = true\n\
         [[particle]]\nposition = [0.3, 0.2, 0.9]\nvelocity = {velocity}\nmass = 1.0\n\
         [[spring]]\nbetween = [1, 0]\nstiffness = 100.0\ndamping = {damping:?}\nrest_length = 1.0\n"
    )
}

const BALL: &str = "gravity = [0.0, 0.0, -10.0]\nduration = 2.0\n\
    [[particle]]\nposition = [0.0, 0.0, 0.8]\nvelocity = [1.0, 0.0, 0.0]\n\
    [[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\nrestitution = 0.5\n";

/// A thrown particle, a held one, and oscillators that are damped less than, as much as and more than critically (2√(km) is
/// 20 N s/m): DOP853 with ever more steps gets to each formula, though it knows nothing of it.
#[test]
fn references_get_to_the_formulas() {
    let thrown = "gravity = [0.0, 1.0, -9.81]\n[[particle]]\nposition = [1.0, 2.0, 3.0]\nvelocity = [4.0, -5.0, 6.0]\n\
                  [[particle]]\nposition = [0.0, 0.0, 0.0]\npinned = true\n";
    let springs = [0.0, 2.0, 20.0, 50.0].map(|damping| spring(damping, "[0.0, 0.0, 0.5]"));
    // No bounce falls on a moment, when its velocity would be that before it or that after it.
    let ball = BALL.replace("duration = 2.0", "duration = 1.87");
    for toml in springs.iter().map(String::as_str).chain([thrown, &ball]) {
        let (model, settings) = load(toml);
        let states = ClosedForm::of(&model, &settings).expect(toml).states(MOMENTS);
        let reference = Reference::of(&model, &settings, &AtomicBool::new(false)).unwrap().unwrap();
        // Rounding of some hundred to some thousand steps; the ball's steps have their bounces in exact arcs.
        let error = position_error(&reference.states, &states);
        assert!(error < 1e-12, "{error:e}: {toml}");
        assert_eq!(reference.closed_form, Some(error));
        let error = velocity_error(&reference.states, &states);
        assert!(error < 2e-11, "{error:e}: {toml}");
    }
}

/// The ball falls for 0.4 s to 4 m/s, flies 0.4, 0.2, 0.1 … s between bounces, and rests from 1.2 s on.
#[test]
fn a_ball_is_where_arithmetic_by_hand_puts_it() {
    // Every 0.1 s.
    let states = known(BALL).unwrap().states(20);
    let height = |tenth: usize| states[tenth - 1].positions[0][2];
    for (tenth, expected) in [(2, 0.6), (4, 0.0), (6, 0.2), (8, 0.0), (9, 0.05), (10, 0.0), (13, 0.0), (20, 0.0)] {
        assert!((height(tenth) - expected).abs() < 1e-14, "{tenth}: {}", height(tenth));
    }
    assert_eq!(states[19].velocities[0], [1.0, 0.0, 0.0]);
    // A reference notes when.
    let (model, settings) = load(BALL);
    let reference = Reference::of(&model, &settings, &AtomicBool::new(false)).unwrap().unwrap();
    let times = &reference.bounces.as_ref().unwrap().times[0];
    for (time, expected) in times.iter().zip([0.4, 0.8, 1.0, 1.1]) {
        assert!((time - expected).abs() < 1e-12, "{times:?}");
    }
}

/// What no formula here solves is not taken for what one does.
#[test]
fn other_scenes_are_left_alone() {
    assert!(known(&spring(0.0, "[0.0, 0.0, 0.0]")).is_some());
    // Across the spring.
    assert!(known(&spring(0.0, "[0.1, 0.0, 0.0]")).is_none());
    // Through the pin and out at its other side.
    assert!(known(&spring(0.0, "[0.0, 0.0, 20.0]")).is_none());
    // A pendulum: gravity across the spring.
    assert!(known(&spring(0.0, "[0.0, 0.0, 0.0]").replace("[0.0, 0.0, -9.81]", "[9.81, 0.0, 0.0]")).is_none());
    // On a spring and before a plane.
    let plane = "[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n";
    assert!(known(&(spring(0.0, "[0.0, 0.0, 0.0]") + plane)).is_none());
    // Between two planes.
    assert!(known(&format!("{BALL}{plane}")).is_none());
}
