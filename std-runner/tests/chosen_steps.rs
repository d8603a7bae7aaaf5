//! Steps that a stepper chooses itself, as the command line asks for them and tells of them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod cli_support;

use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

use cli_support::{Folder, ROPE};
use hooke_runner::model::Model;
use hooke_runner::record::{BoxedRecorder, Frame, RecordError, Recorder};
use hooke_runner::scene::{CollisionForm, Overrides, Precision, Scene, Settings, StepperName, TimeStep};
use hooke_runner::simulate::{AnyStepper, Options, Progress, Summary, chooses_steps, run};

/// x = 1 + 0.1 cos 20 t
const OSCILLATOR: &str = "duration = 1.0\n\
    [[particle]]\nposition = [0.0, 0.0, 0.0]\npinned = true\n\
    [[particle]]\nposition = [1.1, 0.0, 0.0]\nmass = 1.0\n\
    [[spring]]\nbetween = [0, 1]\nstiffness = 400.0\nrest_length = 1.0\n";

const CHOOSE: [&str; 6] = ["--stepper", "dop853", "--time-step", "auto", "--precision", "f64"];

/// Where and how fast the last particle of each frame is, and when.
type Seen = Vec<(f64, [f64; 3], [f64; 3])>;

struct Keep(Arc<Mutex<Seen>>);

impl Recorder<f64> for Keep {
    fn record(&mut self, frame: &Frame<'_, f64>) -> Result<(), RecordError> {
        let (position, velocity) = (frame.position.last().unwrap(), frame.velocity.last().unwrap());
        self.0.lock().unwrap().push((frame.time, *position, *velocity));
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Ok(())
    }
}

struct Silent;

impl Progress for Silent {
    fn reached(&self, _time: f64, _duration: f64) {}
}

fn load(stepper: StepperName, tolerance: f64) -> (Model, Settings) {
    read(OSCILLATOR, stepper, tolerance)
}

fn read(scene: &str, stepper: StepperName, tolerance: f64) -> (Model, Settings) {
    let folder = Folder::with(scene);
    let mut scene = Scene::load(&folder.file("scene.toml")).unwrap();
    let (stepper, precision) = (Some(stepper), Some(Precision::F64));
    scene.apply(&Overrides { stepper, precision, tolerance: Some(tolerance), ..Overrides::default() }).unwrap();
    (scene.model().unwrap(), scene.settings().clone())
}

fn seen(model: &Model, settings: &Settings) -> (Seen, Summary) {
    let kept = Arc::new(Mutex::new(Seen::new()));
    let begin = |_: &_| Ok(vec![Box::new(Keep(Arc::clone(&kept))) as BoxedRecorder<f64>]);
    let interrupted = AtomicBool::new(false);
    let options =
        Options { ledger: true, digest: false, threads: Some(1), interrupted: &interrupted, progress: &Silent };
    let summary = run::<f64>(model, settings, begin, &options).unwrap();
    let seen = std::mem::take(&mut *kept.lock().unwrap());
    (seen, summary)
}

/// Where the particle is at the end, m, and the summary.
fn end(model: &Model, settings: &Settings) -> (f64, Summary) {
    let (seen, summary) = seen(model, settings);
    (seen.last().unwrap().1[0], summary)
}

/// Twenty radians are a few tens of steps, whose errors add up. A step of given length does not care for the tolerance.
#[test]
fn errors_follow_the_tolerance_and_not_the_frames() {
    let exact = 1.0 + 0.1 * 20.0_f64.cos();
    for stepper in StepperName::ALL.iter().copied().filter(|stepper| stepper.estimates_errors()) {
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
            for frame_rate in [1.0, 7.0, 300.0] {
                let (model, settings) = load(stepper, tolerance);
                let settings = Settings { frame_rate, ..settings };
                assert!(chooses_steps(&settings));
                let (place, summary) = end(&model, &settings);
                // The scene is half as large as its spring is long at the start.
                let allowed = 100.0 * tolerance * 0.55;
                assert!((place - exact).abs() < allowed, "{stepper}, {tolerance:e}, {frame_rate}: {place}");
                assert!(summary.parts > 0 && summary.succeeded(), "{summary:?}");
            }
        }
        let (model, settings) = load(stepper, 1e-10);
        let coarse = Settings { time_step: TimeStep::Seconds(0.1), ..settings };
        let (place, summary) = end(&model, &coarse);
        assert!((place - exact).abs() > 1e-6 && summary.parts == 0, "{stepper}: {place}");
    }
}

/// Errors are relative: of a scene a thousand times as large they may be a thousand times as large, and the steps are the
/// same.
#[test]
fn a_larger_scene_takes_the_same_steps() {
    let (model, settings) = load(StepperName::Dop853, 1e-6);
    let settings = Settings { frame_rate: 1.0, ..settings };
    let mut large = model.clone();
    large.particles.iter_mut().for_each(|particle| particle.position = particle.position.map(|x| 1000.0 * x));
    large.springs.iter_mut().for_each(|spring| spring.rest_length *= 1000.0);
    let count = |model: &Model| {
        let (_, summary) = end(model, &settings);
        (summary.parts, summary.rejected, summary.force_evaluations)
    };
    assert_eq!(count(&model), count(&large));
    let absolute = Settings { tolerance: 1e-9, ..settings.clone() };
    let (_, finer) = end(&large, &absolute);
    assert!(finer.parts > count(&large).0);
}

#[test]
fn the_summary_counts_the_steps_that_were_chosen() {
    let folder = Folder::with(ROPE);
    let answer = folder.hooke(&[&["run", "scene.toml"], &CHOOSE[..]].concat()).exits(0);
    answer.tells(&[" chosen by dop853 to a tolerance of 1e-6", "f64", "ns per spring and step"]);
    let tight = folder.hooke(&[&["run", "scene.toml", "--tolerance", "1e-9"], &CHOOSE[..]].concat()).exits(0);
    tight.tells(&["to a tolerance of 1e-9"]);
    // A time step that is given is taken.
    let given = folder.hooke(&["run", "scene.toml", "--stepper", "dop853"]).exits(0);
    let given = given.tells(&["100 of 1 ms, dop853, f32"]);
    assert!(!given.error().contains("chosen by"), "{}", given.error());
}

#[test]
fn check_says_who_chooses_the_steps() {
    let folder = Folder::with(ROPE);
    let checked = folder.hooke(&[&["check", "scene.toml"], &CHOOSE[..]].concat()).exits(0).output();
    // The first and the last particle are half a metre from the middle.
    assert!(checked.contains("chosen by dop853 to a tolerance of 1e-6: errors of 500 nm in each at most"), "{checked}");
    assert!(checked.contains("nothing to warn of"), "{checked}");
    let auto = folder.hooke(&["check", "scene.toml", "--time-step", "auto"]).exits(0).output();
    assert!(auto.contains("found by pilot runs that aim at errors of 500 µm") && !auto.contains("chosen by"), "{auto}");
    let verlet = folder.hooke(&["check", "scene.toml", "--time-step", "auto", "--stepper", "velocity-verlet"]);
    let verlet = verlet.exits(0).output();
    assert!(verlet.contains("(chosen)") && !verlet.contains("chosen by"), "{verlet}");
}

#[test]
fn what_is_left_open_is_found_and_told() {
    let folder = Folder::with(ROPE);
    let open = folder.hooke(&["run", "scene.toml", "--time-step", "auto"]).exits(0);
    open.tells(&["found", "below 500 µm", "without pilot runs"]);
    let longer = folder.hooke(&["run", "scene.toml", "--time-step", "auto", "--duration", "3"]).exits(0);
    longer.tells(&["found", "below 500 µm", "in pilot runs of", "--max-error follows them"]);
    // Where either is given nothing is looked for.
    for given in [["--time-step", "1e-3"], ["--stepper", "velocity-verlet"]] {
        let answer = folder.hooke(&["run", "scene.toml", given[0], given[1]]).exits(0);
        assert!(!answer.error().contains("found"), "{}", answer.error());
    }
}

#[test]
fn an_unstable_step_may_be_left_to_the_stepper() {
    let folder = Folder::with(ROPE);
    let long = ["run", "scene.toml", "--stepper", "dop853", "--time-step", "0.1"];
    folder.hooke(&long).tells(&["likely to blow up", "use --time-step auto, or --stepper implicit-euler"]);
    let verlet = ["run", "scene.toml", "--stepper", "velocity-verlet", "--time-step", "0.1"];
    let answer = folder.hooke(&verlet);
    assert!(!answer.error().contains("--time-step auto"), "{}", answer.error());
}

#[test]
fn what_single_precision_and_end_of_step_hits_cannot_hold_is_said_before() {
    let plane = "[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n";
    let folder = Folder::with(&format!("{ROPE}{plane}"));
    let chosen = ["check", "scene.toml", "--stepper", "dop853", "--time-step", "auto"];
    let say = |more: &[&str]| folder.hooke(&[&chosen[..], more].concat()).exits(0).output();
    assert!(say(&["--tolerance", "1e-9"]).contains("f32 rounds places by 1e-7"));
    assert!(say(&["--collision", "project"]).contains("that is the next frame"));
    for fine in [&["--tolerance", "1e-9", "--precision", "f64"][..], &["--tolerance", "1e-5"]] {
        assert!(say(fine).contains("nothing to warn of"), "{}", say(fine));
    }
}

/// The names mean what they did wherever a step is given.
#[test]
fn only_two_steppers_choose() {
    for stepper in StepperName::ALL {
        let (_, settings) = load(*stepper, 1e-6);
        let mut stepper = AnyStepper::<f64>::of(&settings, 1.0);
        assert_eq!(stepper.any().chooses_parts(), chooses_steps(&settings), "{settings:?}");
        let given = Settings { time_step: TimeStep::Seconds(1e-3), ..settings };
        assert!(!AnyStepper::<f64>::of(&given, 1.0).any().chooses_parts(), "{given:?}");
    }
}

/// With DOP853 no frame ends a step: the same steps, to the bit, at any frame rate, and frames between their ends that are as
/// exact as they are. The Nyström method has no dense output: its steps end at frames.
#[test]
fn frames_are_between_the_steps_of_dop853_and_at_the_ends_of_others() {
    let at = |stepper, frame_rate| {
        let (model, settings) = load(stepper, 1e-7);
        seen(&model, &Settings { frame_rate, ..settings })
    };
    let (few, first) = at(StepperName::Dop853, 1.0);
    let (many, second) = at(StepperName::Dop853, 2000.0);
    assert_eq!((few.len(), many.len()), (2, 2001));
    assert_eq!((first.parts, few.last()), (second.parts, many.last()));
    assert!(second.parts < 100, "{second:?}");
    for (time, place, velocity) in &many {
        let (sine, cosine) = (20.0 * time).sin_cos();
        // Errors add up to some times the tolerance; speeds are 20/s of places.
        assert!((place[0] - 1.0 - 0.1 * cosine).abs() < 1e-6, "{time}: {place:?}");
        assert!((velocity[0] + 2.0 * sine).abs() < 2e-5, "{time}: {velocity:?}");
    }
    assert!(at(StepperName::DormandPrinceRkn8, 2000.0).1.parts >= 2000);
}

/// Hits and keys of tracks cut steps, and frames lie between the cuts all the same.
#[test]
fn frames_lie_between_bounces_and_keys() {
    let bouncing = "duration = 2.0\ngravity = [0.0, 0.0, -9.81]\n\
        [[particle]]\nposition = [0.0, 0.0, 2.0]\n\
        keyframes = [[0.0, 0.0, 0.0, 2.0], [0.7, 0.3, 0.0, 2.0], [1.1, 0.0, 0.0, 2.2]]\n\
        [[particle]]\nposition = [0.0, 0.0, 0.5]\n\
        [[spring]]\nbetween = [0, 1]\nstiffness = 30.0\ndamping = 0.1\nrest_length = 1.7\n\
        [[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\nrestitution = 1.0\n";
    let (model, settings) = read(bouncing, StepperName::Dop853, 1e-9);
    let settings = Settings { frame_rate: 100.0, ..settings };
    let (chosen, summary) = seen(&model, &settings);
    let fine = Settings { time_step: TimeStep::Seconds(1e-3), ..settings.clone() };
    let (given, _) = seen(&model, &fine);
    assert!(summary.hits >= 2 && summary.parts < 190, "{summary:?}");
    assert_eq!(chosen.len(), given.len());
    for ((time, place, _), (_, trusted, _)) in chosen.iter().zip(&given) {
        let distance = place.iter().zip(trusted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(distance < 1e-6, "{time}: {distance:e}");
    }
    // Where hits are looked for at the ends of steps only, those are frames.
    let ends = Settings { collision: CollisionForm::Project, ..settings };
    assert!(seen(&model, &ends).1.steps == 200);
}
