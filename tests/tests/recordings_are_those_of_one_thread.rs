//! Files recorded beside stepping have the bytes of those recorded frame by frame from the same states, on one thread.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::fs::{self, File};
use std::path::Path;
use std::sync::atomic::AtomicBool;

use hooke_runner::draw::{Picture, Scenery};
use hooke_runner::model::Model;
use hooke_runner::record::{BoxedRecorder, CsvRecorder, Frame, GifRecorder, NpzRecorder, Sample};
use hooke_runner::scene::{Scene, Settings, TimeStep};
use hooke_runner::simulate::{AnyResponse, AnyStepper, Options, run, world};
use hooke_tests::scene_runs::{Silent, shipped};

const NAMES: [&str; 3] = ["frames.csv", "frames.npz", "frames.gif"];
const FRAMES: u64 = 31;
/// s, without rounding: a step is as long as a frame.
const STEP: f64 = 1.0 / 1024.0;

fn open<R: Sample>(folder: &Path, model: &Model, settings: &Settings) -> Vec<BoxedRecorder<R>> {
    let [csv, npz, gif] = NAMES.map(|name| folder.join(name));
    let springs: Vec<[u32; 2]> = model.springs.iter().map(|spring| spring.between).collect();
    let picture = Picture::new(Scenery::new(model, settings.gravity, &settings.name, &settings.camera));
    vec![
        Box::new(CsvRecorder::new(File::create(csv).unwrap(), "csv".into())),
        Box::new(NpzRecorder::<R>::create(&npz, model.particles.len(), &springs, FRAMES).unwrap()),
        Box::new(GifRecorder::new(File::create(gif).unwrap(), "gif".into(), picture, settings.frame_rate)),
    ]
}

/// One thread: step, then record, with nothing of the runner's own loop.
fn by_hand<R: Sample>(folder: &Path, model: &Model, settings: &Settings) {
    let mut recorders = open::<R>(folder, model, settings);
    let mut world = world::<R>(model, settings.gravity).unwrap();
    let mut stepper = AnyStepper::named(settings.stepper, settings.tolerance);
    let mut response = AnyResponse::named(settings.collision);
    for number in 0..FRAMES {
        let time = number as f64 * STEP;
        if number > 0 {
            world.view().step_to(stepper.any(), &mut response, R::from_f64(STEP), time, &mut ()).unwrap();
        }
        let (position, velocity): (Vec<[R; 3]>, Vec<[R; 3]>) =
            world.view().states().map(|(x, v)| (x.into(), v.into())).unzip();
        let frame = Frame { number, time, position: &position, velocity: &velocity };
        recorders.iter_mut().for_each(|recorder| recorder.record(&frame).unwrap());
    }
    recorders.into_iter().for_each(|recorder| recorder.finish().unwrap());
}

fn beside_stepping<R: Sample>(folder: &Path, model: &Model, settings: &Settings) {
    let interrupted = AtomicBool::new(false);
    let options =
        Options { ledger: false, digest: false, threads: Some(1), interrupted: &interrupted, progress: &Silent };
    run::<R>(model, settings, |_| Ok(open::<R>(folder, model, settings)), &options).unwrap();
}

fn compare<R: Sample>(name: &str) {
    let path = shipped().into_iter().find(|path| path.ends_with(name)).unwrap();
    let scene = Scene::load(&path).unwrap();
    let model = scene.model().unwrap();
    let mut settings = scene.settings().clone();
    settings.time_step = TimeStep::Seconds(STEP);
    (settings.duration, settings.frame_rate) = ((FRAMES - 1) as f64 * STEP, 1.0 / STEP);
    let [beside, by_itself] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    beside_stepping::<R>(beside.path(), &model, &settings);
    by_hand::<R>(by_itself.path(), &model, &settings);
    let read = |folder: &Path, name: &str| fs::read(folder.join(name)).unwrap();
    for file in NAMES {
        let expected = read(by_itself.path(), file);
        // A recording of nothing would be shorter.
        assert!(expected.len() > 2000, "{name}: {file} has {} bytes", expected.len());
        assert!(read(beside.path(), file) == expected, "{name}: {file} differs");
    }
    // Of another run, they would differ.
    settings.gravity[0] += 1.0;
    beside_stepping::<R>(beside.path(), &model, &settings);
    for file in NAMES {
        assert!(read(beside.path(), file) != read(by_itself.path(), file), "{name}: {file} is blind");
    }
}

#[test]
fn recordings_are_those_of_one_thread() {
    compare::<f32>("hanging-cloth.toml");
    compare::<f64>("jelly-on-a-slope.toml");
}
