//! GIFs: the timing, the frames, the colours, and what is left after an interruption.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs, dead_code)]

mod draw_scenes;

use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;

use draw_scenes::Motion;
use hooke_runner::draw::{Canvas, Picture, Scenery};
use hooke_runner::model::CameraChoice;
use hooke_runner::record::{Frame, GifRecorder, Recorder};

const SIZE: [u32; 2] = [240, 180];

/// A writer whose bytes can be looked at while they are written.
#[derive(Clone, Default)]
struct Shared(Rc<RefCell<Vec<u8>>>);

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

struct Full;

impl Write for Full {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(io::Error::other("the disk is full"))
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn picture(scene: &draw_scenes::Scene) -> Picture {
    let choice = CameraChoice { size: Some(SIZE), ..CameraChoice::default() };
    Picture::new(Scenery::new(&scene.model, scene.gravity, scene.name, &choice))
}

fn still(number: u64, time: f64, position: &[[f64; 3]]) -> Frame<'_, f64> {
    Frame { number, time, position, velocity: &[] }
}

fn finish<W: Write>(recorder: GifRecorder<W>) {
    <GifRecorder<W> as Recorder<f64>>::finish(Box::new(recorder)).unwrap();
}

/// A GIF of moving balls with frames at these times.
fn recorded(rate: f64, times: impl Iterator<Item = f64>) -> Vec<u8> {
    let scene = draw_scenes::balls();
    let mut bytes = Vec::new();
    let mut recorder = GifRecorder::new(&mut bytes, "balls.gif".into(), picture(&scene), rate);
    for (number, time) in times.enumerate() {
        let mut position: Vec<[f64; 3]> = scene.model.particles.iter().map(|particle| particle.position).collect();
        position[2][2] -= 0.2 * time;
        recorder.record(&still(number as u64, time, &position)).unwrap();
    }
    finish(recorder);
    bytes
}

struct Played {
    delays: Vec<u16>,
    screen: Vec<[u8; 4]>,
    whole: bool,
}

/// Plays as far as it can.
fn play(bytes: &[u8]) -> Played {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).unwrap();
    let width = usize::from(decoder.width());
    let mut played =
        Played { delays: Vec::new(), screen: vec![[0; 4]; width * usize::from(decoder.height())], whole: false };
    loop {
        match decoder.read_next_frame() {
            Ok(Some(frame)) => {
                played.delays.push(frame.delay);
                for (index, pixel) in frame.buffer.chunks_exact(4).enumerate().filter(|(_, pixel)| pixel[3] > 0) {
                    let (row, column) = (index / usize::from(frame.width), index % usize::from(frame.width));
                    let place = (row + usize::from(frame.top)) * width + column + usize::from(frame.left);
                    played.screen[place].copy_from_slice(pixel);
                }
            }
            Ok(None) => {
                played.whole = true;
                return played;
            }
            Err(_) => return played,
        }
    }
}

fn worst_and_mean(screen: &[[u8; 4]], canvas: &Canvas) -> (u8, f64) {
    let apart = screen.as_flattened().iter().zip(canvas.data()).map(|(a, b)| a.abs_diff(*b));
    let sum: f64 = apart.clone().map(f64::from).sum();
    (apart.max().unwrap(), sum / (screen.len() * 3) as f64)
}

#[test]
fn delays_sum_to_the_duration() {
    for rate in [1.0, 10.0, 24.0, 25.0, 29.97, 30.0, 40.0, 50.0, 60.0, 120.0, 144.0, 1000.0] {
        let count = (2.0 * rate) as u64;
        let bytes = recorded(rate, (0..=count).map(|frame| frame as f64 / rate));
        let played = play(&bytes);
        assert!(played.whole);
        let (last, others) = played.delays.split_last().unwrap();
        assert_eq!(*last, 100, "the last is shown for a second");
        let sum: u32 = others.iter().copied().map(u32::from).sum();
        let duration = count as f64 / rate * 100.0;
        assert!((f64::from(sum) - duration).abs() <= 2.0, "{rate}: {sum}, not {duration}");
        assert!(others.iter().all(|delay| *delay >= 2), "{rate}: {others:?}");
        let (low, high) = (others.iter().min().unwrap(), others.iter().max().unwrap());
        assert!(high - low <= 1 || rate > 50.0 && *high <= 4, "{rate}: even: {others:?}");
        let expected = if rate > 50.0 { 101 } else { count as usize + 1 };
        assert!(played.delays.len().abs_diff(expected) <= 1, "{rate}: {} frames", played.delays.len());
    }
}

#[test]
fn time_is_the_frames_own() {
    // The last frame comes sooner than the rate says, as where the duration is no whole number of frames.
    let played = play(&recorded(10.0, [0.0, 0.1, 0.2, 0.25].into_iter()));
    assert_eq!(played.delays, [10, 10, 5, 100]);
    // Faster than slots: the last one is kept all the same.
    let played = play(&recorded(1000.0, [0.0, 0.02, 0.021, 0.022].into_iter()));
    assert_eq!(played.delays, [2, 2, 100]);
}

#[test]
fn one_frame_and_none() {
    assert_eq!(play(&recorded(60.0, [0.0].into_iter())).delays, [100]);
    assert!(recorded(60.0, std::iter::empty()).is_empty());
}

#[test]
fn odd_rates_and_times_are_survived() {
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9] {
        let bytes = recorded(rate, [0.0, 1e9, 1e300, f64::NAN, f64::INFINITY].into_iter());
        assert!(play(&bytes).whole);
    }
}

#[test]
fn plays_forever() {
    let bytes = recorded(10.0, [0.0, 0.1].into_iter());
    let mut decoder = gif::DecodeOptions::new().read_info(bytes.as_slice()).unwrap();
    while decoder.read_next_frame().unwrap().is_some() {}
    assert_eq!(decoder.repeat(), gif::Repeat::Infinite);
}

#[test]
fn looks_like_the_picture() {
    for scene in draw_scenes::all() {
        let mut bytes = Vec::new();
        let mut recorder = GifRecorder::new(&mut bytes, "x.gif".into(), picture(&scene), 25.0);
        let mut twin = picture(&scene);
        let mut motion = Motion::new(&scene);
        for number in 0..12 {
            recorder.record(&still(number, motion.time, &motion.position)).unwrap();
            twin.draw(motion.time, &motion.position);
            motion.run(0.04, 60);
        }
        finish(recorder);
        let played = play(&bytes);
        assert_eq!(played.delays.len(), 12);
        let (worst, mean) = worst_and_mean(&played.screen, twin.canvas());
        assert!(mean < 2.0 && worst < 60, "{}: {worst} {mean}", scene.name);
    }
}

/// The check itself: it can tell one frame from another.
#[test]
fn does_not_look_like_another_picture() {
    let bytes = recorded(10.0, [0.0].into_iter());
    let scene = draw_scenes::balls();
    let mut other = picture(&scene);
    other.draw(0.0, &[[0.0, 0.0, 0.5]; 7]);
    let (worst, mean) = worst_and_mean(&play(&bytes).screen, other.canvas());
    assert!(worst > 60 && mean > 2.0, "{worst} {mean}");
}

#[test]
fn an_interrupted_file_plays_to_its_last_whole_frame() {
    let scene = draw_scenes::balls();
    let shared = Shared::default();
    let mut recorder = GifRecorder::new(shared.clone(), "x.gif".into(), picture(&scene), 10.0);
    let mut position: Vec<[f64; 3]> = scene.model.particles.iter().map(|particle| particle.position).collect();
    let mut sizes = Vec::new();
    for number in 0..10 {
        position[1][2] -= 0.03;
        recorder.record(&still(number, number as f64 * 0.1, &position)).unwrap();
        sizes.push(shared.0.borrow().len());
    }
    // As if the machine had stopped here: no trailer.
    let bytes = shared.0.borrow().clone();
    std::mem::forget(recorder);
    let played = play(&bytes);
    assert_eq!(played.delays, [10; 9], "all but the one whose end is not known yet");
    assert!(!played.whole);
    // And in the middle of a frame.
    let played = play(&bytes[..(sizes[5] + sizes[6]) / 2]);
    assert_eq!(played.delays.len(), 5);
}

#[test]
fn memory_and_files_do_not_grow_with_what_does_not_change() {
    let scene = draw_scenes::cloth(16);
    let position: Vec<[f64; 3]> = scene.model.particles.iter().map(|particle| particle.position).collect();
    let mut bytes = Vec::new();
    let mut recorder = GifRecorder::new(&mut bytes, "x.gif".into(), picture(&scene), 10.0);
    for number in 0..20 {
        recorder.record(&still(number, number as f64 * 0.1, &position)).unwrap();
    }
    finish(recorder);
    let first = recorded_size(&scene, &position);
    assert!(bytes.len() < first + 20 * 1000, "only the time changes: {} after {first}", bytes.len());
}

fn recorded_size(scene: &draw_scenes::Scene, position: &[[f64; 3]]) -> usize {
    let mut bytes = Vec::new();
    let mut recorder = GifRecorder::new(&mut bytes, "x.gif".into(), picture(scene), 10.0);
    recorder.record(&still(0, 0.0, position)).unwrap();
    finish(recorder);
    bytes.len()
}

#[test]
fn a_full_disk_is_an_error_that_names_the_file() {
    let scene = draw_scenes::balls();
    let mut recorder = GifRecorder::new(Full, "some/balls.gif".into(), picture(&scene), 10.0);
    let mut message = String::new();
    for number in 0..3 {
        if let Err(error) = recorder.record(&still(number, number as f64, &[])) {
            message = error.to_string();
            break;
        }
    }
    assert!(message.contains("some/balls.gif") && message.contains("full"), "{message:?}");
}
