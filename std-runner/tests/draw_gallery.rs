//! Pictures to look at, and how long they take: `cargo test --release --test draw_gallery -- --ignored --nocapture`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs, dead_code)]

mod draw_scenes;

use std::path::PathBuf;
use std::time::Instant;

use draw_scenes::Motion;
use hooke_runner::draw::{Canvas, Picture, Scenery};
use hooke_runner::model::CameraChoice;
use hooke_runner::record::{Frame, GifRecorder, PngRecorder, Recorder};

fn folder() -> PathBuf {
    let folder = std::env::var("HOOKE_PICTURES").unwrap_or_else(|_| env!("CARGO_TARGET_TMPDIR").to_owned());
    std::fs::create_dir_all(&folder).unwrap();
    PathBuf::from(folder)
}

fn save(canvas: &Canvas, name: &str) {
    let file = std::fs::File::create(folder().join(name)).unwrap();
    let mut encoder = png::Encoder::new(file, canvas.width(), canvas.height());
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header().unwrap().write_image_data(canvas.data()).unwrap();
}

#[test]
#[ignore = "makes pictures for eyes"]
fn gallery() {
    for scene in draw_scenes::all() {
        let scenery = Scenery::new(&scene.model, scene.gravity, scene.name, &CameraChoice::default());
        let mut picture = Picture::new(scenery);
        let mut motion = Motion::new(&scene);
        let mut wall = 0.0;
        for frame in 0..=100 {
            if frame > 0 {
                motion.run(0.02, 50);
            }
            let start = Instant::now();
            let canvas = picture.draw(motion.time, &motion.position);
            wall += start.elapsed().as_secs_f64();
            if [0, 25, 100].contains(&frame) {
                save(canvas, &format!("{}-{frame:03}.png", scene.name.replace(' ', "-")));
            }
        }
        eprintln!("{}: {:.2} ms a frame", scene.name, wall * 1e3 / 101.0);
        make_gif(&scene);
    }
}

fn make_gif(scene: &draw_scenes::Scene) {
    let scenery = Scenery::new(&scene.model, scene.gravity, scene.name, &CameraChoice::default());
    let mut bytes = Vec::new();
    let mut recorder = GifRecorder::new(&mut bytes, "gif".into(), Picture::new(scenery), 50.0);
    let mut motion = Motion::new(scene);
    let mut wall = 0.0;
    for number in 0..=100 {
        if number > 0 {
            motion.run(0.02, 50);
        }
        let frame = Frame { number, time: motion.time, position: &motion.position, velocity: &[] };
        let start = Instant::now();
        recorder.record(&frame).unwrap();
        wall += start.elapsed().as_secs_f64();
    }
    <GifRecorder<_> as Recorder<f64>>::finish(Box::new(recorder)).unwrap();
    let file = scene.name.replace(' ', "-");
    eprintln!("    gif: {:.2} ms a frame, {} kB", wall * 1e3 / 101.0, bytes.len() / 1000);
    std::fs::write(folder().join(format!("{file}.gif")), &bytes).unwrap();
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes.as_slice()).unwrap();
    let width = usize::from(decoder.width());
    let mut screen = vec![[0u8; 4]; width * usize::from(decoder.height())];
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        let pixels = frame.buffer.chunks_exact(4).enumerate();
        for (index, pixel) in pixels.filter(|(_, pixel)| pixel[3] > 0) {
            let (row, column) = (index / usize::from(frame.width), index % usize::from(frame.width));
            let place = (row + usize::from(frame.top)) * width + column + usize::from(frame.left);
            screen[place].copy_from_slice(pixel);
        }
    }
    let out = std::fs::File::create(folder().join(format!("{file}-gif.png"))).unwrap();
    let mut encoder = png::Encoder::new(out, width as u32, (screen.len() / width) as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header().unwrap().write_image_data(screen.as_flattened()).unwrap();
}

#[test]
#[ignore = "measures"]
fn cloths() {
    for side in [32, 256] {
        let scene = draw_scenes::cloth(side);
        let springs = scene.model.springs.len();
        let picture = || Picture::new(Scenery::new(&scene.model, scene.gravity, scene.name, &CameraChoice::default()));
        let start = Instant::now();
        let mut drawn = picture();
        eprintln!("{springs} springs: prepared in {:?}", start.elapsed());
        let mut bytes = Vec::new();
        let mut gif = GifRecorder::new(&mut bytes, "cloth.gif".into(), picture(), 50.0);
        let mut png = PngRecorder::create(&folder().join("timed/cloth.png"), picture()).unwrap();
        let mut wall = [0.0; 3];
        for number in 0..20 {
            let time = number as f64 * 0.02;
            let position: Vec<[f64; 3]> = scene
                .model
                .particles
                .iter()
                .map(|particle| {
                    let [x, y, _] = particle.position;
                    [x, y * 0.4, 2.0 - y * 0.9 - 0.1 * (x * 7.0 + time * 5.0).sin()]
                })
                .collect();
            let frame = Frame { number, time, position: &position, velocity: &[] };
            let mut clock = Instant::now();
            let mut lap = || std::mem::replace(&mut clock, Instant::now()).elapsed().as_secs_f64() * 1e3 / 20.0;
            drawn.draw(time, &position);
            wall[0] += lap();
            gif.record(&frame).unwrap();
            wall[1] += lap();
            png.record(&frame).unwrap();
            wall[2] += lap();
        }
        save(drawn.canvas(), &format!("cloth-of-{springs}.png"));
        eprintln!("    ms a frame: draw {:.1}, with gif {:.1}, with png {:.1}", wall[0], wall[1], wall[2]);
    }
}
