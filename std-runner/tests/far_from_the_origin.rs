//! A scene far from the origin is stepped as if it were there.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use std::io::Write;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

use hooke::Project;
use hooke_runner::model::{Hold, Model, ModelParticle, ModelPlane, ModelSpring, Track};
use hooke_runner::record::{BoxedRecorder, Frame, RecordError, Recorder};
use hooke_runner::scene::{Scene, StepperName};
use hooke_runner::simulate::{Anchor, AnyStepper, Options, Progress, run, world};

/// m
const AWAY: [f64; 3] = [10_000.0, -20_000.0, 0.0];

const SETTINGS: &str = "duration = 5.0\ntime_step = 1e-4\nstepper = \"velocity-verlet\"\nprecision = \"f32\"\n\
    gravity = [0.0, 0.0, -9.81]\n[[particle]]\nposition = [0.0, 0.0, 0.0]\n";

/// A mass on a spring beside a ball over a floor and a particle on a track, so far from the origin.
fn model([x, y, z]: [f64; 3]) -> Model {
    let particle = |place: [f64; 3], hold| ModelParticle {
        position: [x + place[0], y + place[1], z + place[2]],
        velocity: [0.0; 3],
        mass: 1.0,
        hold,
    };
    let key = |time, height: f64| (time, [x, y + 2.0, z + height]);
    Model {
        particles: vec![
            particle([0.0, 0.0, 0.0], Hold::Pinned),
            particle([1.25, 0.0, 0.0], Hold::Free),
            particle([0.0, 1.0, 1.0], Hold::Free),
            particle([0.0, 2.0, 0.0], Hold::Track(0)),
        ],
        springs: vec![ModelSpring { between: [0, 1], stiffness: 100.0, damping: 0.0, rest_length: 1.0 }],
        planes: vec![ModelPlane { point: [x, y, z - 0.5], normal: [0.0, 0.0, 1.0], restitution: 0.5 }],
        tracks: vec![Track { keys: vec![key(0.0, 0.0), key(5.0, 0.75)] }],
    }
}

struct Last(Arc<Mutex<Vec<[f64; 3]>>>);

impl Recorder<f32> for Last {
    fn record(&mut self, frame: &Frame<'_, f32>) -> Result<(), RecordError> {
        *self.0.lock().unwrap() = frame.position.iter().map(|place| place.map(f64::from)).collect();
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Ok(())
    }
}

struct Nobody;

impl Progress for Nobody {
    fn reached(&self, _time: f64, _duration: f64) {}
}

/// Where all are after 5 s, in `f32`.
fn end(away: [f64; 3]) -> Vec<[f64; 3]> {
    let last = Arc::new(Mutex::new(Vec::new()));
    let recorder: BoxedRecorder<f32> = Box::new(Last(Arc::clone(&last)));
    let mut file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    file.write_all(SETTINGS.as_bytes()).unwrap();
    let scene = Scene::load(file.path()).unwrap();
    let options = Options {
        ledger: false,
        digest: false,
        threads: Some(1),
        interrupted: &AtomicBool::new(false),
        progress: &Nobody,
    };
    run::<f32>(&model(away), scene.settings(), |_| Ok(vec![recorder]), &options).unwrap();
    let last = last.lock().unwrap();
    last.clone()
}

/// What is recorded is rounded to the millimetre that lies between two numbers of `f32` there, and not a step before that: a
/// step moves nothing by as much.
#[test]
fn nothing_is_lost_on_the_way() {
    let (here, there) = (end([0.0; 3]), end(AWAY));
    for (number, (here, there)) in here.iter().zip(&there).enumerate() {
        for axis in 0..3 {
            let error = (there[axis] - AWAY[axis] - here[axis]).abs();
            assert!(error <= 1e-3, "particle {number}, axis {axis}: {error:e}");
        }
    }
    // They have moved.
    assert!(
        (here[1][2]).abs() > 0.01 && (here[2][2] + 0.5).abs() < 0.2 && (here[3][2] - 0.75).abs() < 1e-6,
        "{here:?}"
    );
}

/// The same model stepped where it is: of the swing nothing is left.
#[test]
fn without_an_anchor_it_would_be() {
    let mut world = world::<f32>(&model(AWAY), [0.0, 0.0, -9.81]).unwrap();
    let mut stepper = AnyStepper::<f32>::named(StepperName::VelocityVerlet, 1e-6);
    for _ in 0..50_000 {
        world.step(stepper.any(), &mut Project, 1e-4).unwrap();
    }
    let there = world.position(1).unwrap();
    let here = end([0.0; 3])[1];
    let error = (f64::from(there.x) - AWAY[0] - here[0]).abs() + (f64::from(there.z) - here[2]).abs();
    assert!(error > 0.05, "{error:e}");
}

#[test]
fn only_what_is_far_is_moved() {
    let place = [1.0, 2.0, 3.0];
    assert_eq!(Anchor::of(&model([0.0; 3])).from_there(place), place);
    assert_eq!(Anchor::of(&model([10.0, 0.0, 0.0])).from_there(place), place);
    let far = Anchor::of(&model(AWAY));
    let [x, y, z] = far.from_there(AWAY);
    assert!(x.abs() < 2.0 && y.abs() < 2.0 && z.abs() < 2.0, "{x} {y} {z}");
    let relative = far.relative(&model(AWAY)).into_owned();
    assert_eq!(relative.springs, model(AWAY).springs);
    assert!(relative.planes[0].point.iter().all(|component| component.abs() < 3.0));
    assert!(relative.tracks[0].keys.iter().all(|(_, place)| place.iter().all(|component| component.abs() < 3.0)));
}
