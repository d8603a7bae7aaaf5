//! Runs of scene files, with their frames kept.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

use hooke_runner::record::{BoxedRecorder, Frame, RecordError, Recorder, Sample};
use hooke_runner::scene::{Scene, Settings};
use hooke_runner::simulate::{Options, Progress, Summary, run};

use crate::moment::Moment;

/// The scenes that ship.
///
/// # Panics
/// If they are not where they should be.
#[must_use]
pub fn shipped() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let files = folder.read_dir().expect("the folder of scenes").map(|entry| entry.expect("a file").path());
    let mut scenes: Vec<PathBuf> =
        files.filter(|path| path.extension().is_some_and(|ending| ending == "toml")).collect();
    scenes.sort();
    scenes
}

/// A frame as it was recorded: its time (s) and the state, in `f64`.
pub type Recorded = (f64, Moment);

struct Keep(Arc<Mutex<Vec<Recorded>>>);

impl<R: Sample> Recorder<R> for Keep {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        let vectors = |vectors: &[[R; 3]]| vectors.iter().map(|vector| vector.map(R::to_f64)).collect();
        let moment = Moment { position: vectors(frame.position), velocity: vectors(frame.velocity) };
        self.0.lock().expect("nobody panics with it").push((frame.time, moment));
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Ok(())
    }
}

/// Nobody who is told how far a run is.
pub struct Silent;

impl Progress for Silent {
    fn reached(&self, _time: f64, _duration: f64) {}
}

/// Runs a scene in the precision `R`, with its settings changed as told, and keeps its frames.
///
/// # Panics
/// If the scene is not sound.
#[must_use]
pub fn run_scene<R: Sample>(path: &Path, change: impl FnOnce(&mut Settings)) -> (Summary, Vec<Recorded>) {
    let scene = Scene::load(path).expect("a sound scene");
    let mut settings = scene.settings().clone();
    change(&mut settings);
    let frames = Arc::new(Mutex::new(Vec::new()));
    let interrupted = AtomicBool::new(false);
    let options =
        Options { ledger: true, digest: false, threads: Some(1), interrupted: &interrupted, progress: &Silent };
    let recorders = |_: &_| Ok(vec![Box::new(Keep(Arc::clone(&frames))) as BoxedRecorder<R>]);
    let model = scene.model().expect("a scene that fits");
    let summary = run::<R>(&model, &settings, recorders, &options).expect("a run");
    let frames = std::mem::take(&mut *frames.lock().expect("nobody panics with it"));
    (summary, frames)
}
