//! Recording beside stepping: what is recorded is the same, stepping waits only for a full queue, and no error is lost.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::io::{self, ErrorKind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use hooke_runner::record::{BoxedRecorder, Frame, RecordError, Recorder, frames_held};
use hooke_runner::scene::{Scene, Settings, TimeStep};
use hooke_runner::simulate::{Ending, Options, Progress, RunError, Summary, run};
use hooke_tests::scene_runs::{Silent, shipped};

/// s
const STEP: f64 = 1.0 / 1024.0;
/// Longer than any thread is kept from running, and shorter than a person waits for a test that fails.
const LONG: Duration = Duration::from_secs(60);

/// A spring with a frame at every step.
fn frame_a_step(steps: u32) -> impl FnOnce(&mut Settings) {
    move |settings| {
        settings.time_step = TimeStep::Seconds(STEP);
        settings.duration = f64::from(steps) * STEP;
        settings.frame_rate = 1.0 / STEP;
    }
}

fn spring(
    change: impl FnOnce(&mut Settings),
    recorders: Vec<BoxedRecorder<f64>>,
    interrupted: &AtomicBool,
    progress: &dyn Progress,
) -> Result<Summary, RunError> {
    let path = shipped().into_iter().find(|path| path.ends_with("vertical-spring.toml")).unwrap();
    let scene = Scene::load(&path).unwrap();
    let mut settings = scene.settings().clone();
    change(&mut settings);
    let options = Options { ledger: false, digest: false, threads: Some(1), interrupted, progress };
    run::<f64>(&scene.model().unwrap(), &settings, |_| Ok(recorders), &options)
}

/// What a recorder was told.
#[derive(Clone, Debug, PartialEq)]
enum Told {
    Frame(u64, [f64; 3]),
    Finish,
}

/// A recorder that does something at each frame, and keeps what it is told.
struct Double<A> {
    told: Arc<Mutex<Vec<Told>>>,
    at_frame: A,
}

impl<A: FnMut(u64) -> io::Result<()> + Send + 'static> Double<A> {
    fn boxed(at_frame: A) -> (BoxedRecorder<f64>, Arc<Mutex<Vec<Told>>>) {
        let told = Arc::default();
        (Box::new(Self { told: Arc::clone(&told), at_frame }), told)
    }
}

impl<A: FnMut(u64) -> io::Result<()> + Send> Recorder<f64> for Double<A> {
    fn record(&mut self, frame: &Frame<'_, f64>) -> Result<(), RecordError> {
        (self.at_frame)(frame.number).map_err(|source| RecordError { path: "double".into(), source })?;
        self.told.lock().unwrap().push(Told::Frame(frame.number, frame.position[1]));
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        self.told.lock().unwrap().push(Told::Finish);
        Ok(())
    }
}

fn numbers(told: &Mutex<Vec<Told>>) -> Vec<u64> {
    let number = |told: &Told| if let Told::Frame(number, _) = told { Some(*number) } else { None };
    told.lock().unwrap().iter().filter_map(number).collect()
}

/// Sends on how many steps have been taken.
struct Steps(Sender<u64>);

impl Progress for Steps {
    fn reached(&self, time: f64, _duration: f64) {
        let _ = self.0.send((time / STEP).round() as u64);
    }
}

/// Waits for a step to be taken.
fn wait_for(steps: &Receiver<u64>, step: u64, patience: Duration) -> Result<(), RecvTimeoutError> {
    while steps.recv_timeout(patience)? < step {}
    Ok(())
}

/// While one frame is being written, stepping goes on until the queue is full, and then no further: the frame of step
/// 64 finds no room beside the first frame and those of 63 steps.
#[test]
fn stepping_goes_on_beside_recording_until_the_queue_is_full() {
    let held = frames_held::<f64>(2) as u64;
    let (sender, steps) = channel();
    let seen = Arc::new(Mutex::new(Vec::new()));
    let (keep, mut steps) = (Arc::clone(&seen), Some(steps));
    let (slow, told) = Double::boxed(move |_| {
        if let Some(steps) = steps.take() {
            keep.lock().unwrap().push(wait_for(&steps, held - 1, LONG));
            // A step takes about a microsecond: unbounded, it would have been taken long before.
            keep.lock().unwrap().push(wait_for(&steps, held, Duration::from_millis(300)));
        }
        Ok(())
    });
    let summary = spring(frame_a_step(1000), vec![slow], &AtomicBool::new(false), &Steps(sender)).unwrap();
    assert_eq!(*seen.lock().unwrap(), [Ok(()), Err(RecvTimeoutError::Timeout)]);
    assert!(summary.waiting >= Duration::from_millis(300) && summary.recording >= Duration::from_millis(300));
    // Nor is any frame lost to the jam.
    assert_eq!(numbers(&told), (0..=1000).collect::<Vec<_>>());
}

#[test]
fn the_queue_is_bounded_by_bytes_too() {
    // Six numbers a particle, in 64 MiB.
    assert_eq!(frames_held::<f32>(1_000_000), 2);
    assert_eq!(frames_held::<f64>(1_000_000), 1);
    assert_eq!(frames_held::<f32>(100_000), 27);
    assert_eq!(frames_held::<f32>(usize::MAX), 1);
    assert_eq!((frames_held::<f32>(0), frames_held::<f64>(1)), (64, 64));
}

/// Of a slow recorder and a quick one, each gets every frame once, in order, with the same numbers, then the end.
#[test]
fn slow_recorders_get_every_frame_in_order() {
    let (quick, expected) = Double::boxed(|_| Ok(()));
    spring(frame_a_step(300), vec![quick], &AtomicBool::new(false), &Silent).unwrap();
    let (slow, slow_told) = Double::boxed(|number| {
        std::thread::sleep(Duration::from_micros(if number % 7 == 0 { 3000 } else { 0 }));
        Ok(())
    });
    let (quick, quick_told) = Double::boxed(|_| Ok(()));
    let summary = spring(frame_a_step(300), vec![slow, quick], &AtomicBool::new(false), &Silent).unwrap();
    let expected = expected.lock().unwrap();
    assert_eq!(summary.frames, 301);
    assert_eq!(expected.last(), Some(&Told::Finish));
    assert_ne!(expected[0], expected[300]);
    assert_eq!(*slow_told.lock().unwrap(), *expected);
    assert_eq!(*quick_told.lock().unwrap(), *expected);
}

/// The run would take years, and ends as soon as its recorder has failed, although it is far from the next frame.
#[test]
fn a_failing_recorder_ends_the_run_with_its_error() {
    let years = |settings: &mut Settings| {
        frame_a_step(1)(settings);
        (settings.duration, settings.frame_rate) = (STEP * 1e12, 0.01 / STEP);
    };
    let (sound, sound_told) = Double::boxed(|_| Ok(()));
    let (failing, failing_told) = Double::boxed(|number| match number {
        7 => Err(io::Error::new(ErrorKind::StorageFull, "no room")),
        _ => Ok(()),
    });
    let error = spring(years, vec![sound, failing], &AtomicBool::new(false), &Silent).unwrap_err();
    assert_eq!(error.to_string(), "cannot write double: no room");
    let RunError::Record { error, frames } = error else { panic!("{error}") };
    assert_eq!((error.source.kind(), frames), (ErrorKind::StorageFull, 7));
    // The first recorder had frame 7 already, none has a later one, and both are finished.
    assert_eq!(numbers(&sound_told), (0..=7).collect::<Vec<_>>());
    assert_eq!(numbers(&failing_told), (0..7).collect::<Vec<_>>());
    for told in [sound_told, failing_told] {
        assert_eq!(told.lock().unwrap().last(), Some(&Told::Finish));
    }
}

/// Also one that fails while stepping waits for it.
#[test]
fn a_recorder_that_fails_behind_a_full_queue_ends_the_run() {
    let (sender, steps) = channel();
    let held = frames_held::<f64>(2) as u64;
    let (failing, _) = Double::boxed(move |_| {
        wait_for(&steps, held - 1, LONG).unwrap();
        let _ = wait_for(&steps, held, Duration::from_millis(50));
        Err(io::Error::new(ErrorKind::BrokenPipe, "nobody reads"))
    });
    let error = spring(frame_a_step(1000), vec![failing], &AtomicBool::new(false), &Steps(sender)).unwrap_err();
    assert!(matches!(error, RunError::Record { frames: 0, .. }), "{error}");
}

#[test]
fn an_interrupted_run_has_every_frame_that_it_made() {
    let interrupted = Arc::new(AtomicBool::new(false));
    let interrupt = Arc::clone(&interrupted);
    let (slow, told) = Double::boxed(move |number| {
        interrupt.store(number >= 20, Ordering::Relaxed);
        std::thread::sleep(Duration::from_millis(1));
        Ok(())
    });
    let summary = spring(frame_a_step(1_000_000), vec![slow], &interrupted, &Silent).unwrap();
    assert_eq!(summary.ending, Ending::Interrupted);
    // Frame 0 is the start: those that were waiting when it was interrupted are there too.
    assert_eq!(summary.frames, summary.steps + 1);
    assert_eq!(numbers(&told), (0..=summary.steps).collect::<Vec<_>>());
    assert_eq!(told.lock().unwrap().last(), Some(&Told::Finish));
}

#[test]
#[should_panic(expected = "the double panics at frame 3")]
fn a_recorder_that_panics_is_not_waited_for() {
    let (panicking, _) = Double::boxed(|number| {
        assert!(number < 3, "the double panics at frame {number}");
        Ok(())
    });
    let _ = spring(frame_a_step(1_000_000), vec![panicking], &AtomicBool::new(false), &Silent);
}
