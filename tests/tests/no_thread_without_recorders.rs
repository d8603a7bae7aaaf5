//! A run that records nothing starts no thread.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]
#![cfg(target_os = "linux")]

use std::fs;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use hooke_runner::record::{BoxedRecorder, CsvRecorder};
use hooke_runner::scene::Scene;
use hooke_runner::simulate::{Options, Progress, run};
use hooke_tests::scene_runs::shipped;

/// Counts the threads of this process at a step.
struct Threads(AtomicUsize);

impl Progress for Threads {
    fn reached(&self, _time: f64, _duration: f64) {
        if self.0.load(Ordering::Relaxed) == 0 {
            self.0.store(fs::read_dir("/proc/self/task").unwrap().count(), Ordering::Relaxed);
        }
    }
}

fn threads(recorders: Vec<BoxedRecorder<f64>>) -> usize {
    let path = shipped().into_iter().find(|path| path.ends_with("vertical-spring.toml")).unwrap();
    let scene = Scene::load(&path).unwrap();
    let progress = Threads(AtomicUsize::new(0));
    let interrupted = AtomicBool::new(false);
    let options =
        Options { ledger: false, digest: false, threads: Some(1), interrupted: &interrupted, progress: &progress };
    run::<f64>(&scene.model().unwrap(), scene.settings(), |_| Ok(recorders), &options).unwrap();
    progress.0.into_inner()
}

#[test]
fn no_thread_without_recorders() {
    // This test is alone in its process, so nothing else starts or ends a thread meanwhile.
    let before = fs::read_dir("/proc/self/task").unwrap().count();
    assert_eq!(threads(Vec::new()), before);
    assert_eq!(threads(vec![Box::new(CsvRecorder::new(std::io::sink(), "nowhere".into()))]), before + 1);
}
