//! A cloth run with recording, beside the same run without: compare within the group, not between runs.
#![allow(missing_docs, clippy::expect_used)]

use std::fs::File;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use criterion::{Criterion, criterion_group, criterion_main};
use hooke_runner::model::Model;
use hooke_runner::record::{BoxedRecorder, CsvRecorder, NpzRecorder, RecordError};
use hooke_runner::scene::{Scene, Settings, StepperName, TimeStep};
use hooke_runner::simulate::{Options, Progress, Start, run};

struct Silent;

impl Progress for Silent {
    fn reached(&self, _time: f64, _duration: f64) {}
}

/// What a run is recorded to, in a folder.
type Open = fn(&Path, &Model, &Start) -> Result<Vec<BoxedRecorder<f32>>, RecordError>;

fn nothing(_: &Path, _: &Model, _: &Start) -> Result<Vec<BoxedRecorder<f32>>, RecordError> {
    Ok(Vec::new())
}

fn npz(folder: &Path, model: &Model, start: &Start) -> Result<Vec<BoxedRecorder<f32>>, RecordError> {
    let springs: Vec<[u32; 2]> = model.springs.iter().map(|spring| spring.between).collect();
    let path = folder.join("frames.npz");
    Ok(vec![Box::new(NpzRecorder::<f32>::create(&path, model.particles.len(), &springs, start.schedule.frames())?)])
}

fn csv(folder: &Path, _: &Model, _: &Start) -> Result<Vec<BoxedRecorder<f32>>, RecordError> {
    let file = File::create(folder.join("frames.csv")).expect("a folder that can be written to");
    Ok(vec![Box::new(CsvRecorder::new(file, "frames.csv".into()))])
}

/// 200 steps of 1 ms of a cloth of 32 x 32, with a frame after every so many steps.
fn settings(scene: &Scene, steps_a_frame: f64) -> Settings {
    let mut settings = scene.settings().clone();
    settings.stepper = StepperName::SemiImplicitEuler;
    settings.time_step = TimeStep::Seconds(1e-3);
    (settings.duration, settings.frame_rate) = (0.2, 1e3 / steps_a_frame);
    settings
}

fn record(criterion: &mut Criterion) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/cloth-32.toml");
    let scene = Scene::load(&path).expect("a sound scene");
    let model = scene.model().expect("a scene that fits");
    let folder = tempfile::tempdir().expect("a place for recordings");
    let interrupted = AtomicBool::new(false);
    let options =
        Options { ledger: false, digest: false, threads: Some(1), interrupted: &interrupted, progress: &Silent };
    let mut group = criterion.benchmark_group("record");
    for steps_a_frame in [1, 10] {
        let settings = settings(&scene, f64::from(steps_a_frame));
        for (name, open) in [("nothing", nothing as Open), ("npz", npz), ("csv", csv)] {
            group.bench_function(format!("{name}, a frame every {steps_a_frame} steps"), |bencher| {
                let begin = |start: &Start| open(folder.path(), &model, start);
                bencher.iter(|| run::<f32>(&model, &settings, begin, &options).expect("a run"));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, record);
criterion_main!(benches);
