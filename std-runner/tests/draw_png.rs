//! PNG sequences: names, contents, failures.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs, dead_code)]

mod draw_scenes;

use std::fs;
use std::path::Path;

use hooke_runner::draw::{Picture, Scenery};
use hooke_runner::model::CameraChoice;
use hooke_runner::record::{Frame, PngRecorder, Recorder};

fn picture(scene: &draw_scenes::Scene) -> Picture {
    let choice = CameraChoice { size: Some([120, 90]), ..CameraChoice::default() };
    Picture::new(Scenery::new(&scene.model, scene.gravity, scene.name, &choice))
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn frames_are_numbered_and_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("new/frames/cloth.v2.png");
    let scene = draw_scenes::cloth(8);
    let position: Vec<[f32; 3]> =
        scene.model.particles.iter().map(|particle| particle.position.map(|x| x as f32)).collect();
    let mut recorder = PngRecorder::create(&path, picture(&scene)).unwrap();
    let mut twin = picture(&scene);
    for number in [0, 1, 42, 123_456] {
        let time = number as f64 * 0.1;
        recorder.record(&Frame { number, time, position: &position, velocity: &[] }).unwrap();
        let canvas = twin.draw(time, &position);
        // Each can be read at once, not only at the end.
        let file = fs::File::open(PngRecorder::numbered(&path, number)).unwrap();
        let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
        let mut rows = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut rows).unwrap();
        assert_eq!([info.width, info.height], [120, 90]);
        let wanted = canvas.pixels().iter().flat_map(|pixel| &pixel[..3]);
        assert!(rows.iter().eq(wanted), "frame {number}");
    }
    <PngRecorder as Recorder<f32>>::finish(Box::new(recorder)).unwrap();
    let expected = ["00000", "00001", "00042", "123456"].map(|number| format!("cloth.v2-{number}.png"));
    assert_eq!(names(path.parent().unwrap()), expected, "and nothing else is left there");
}

#[test]
fn pictures_of_an_earlier_run_go_and_others_stay() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cloth.png");
    let scene = draw_scenes::cloth(3);
    let position: Vec<[f64; 3]> = scene.model.particles.iter().map(|particle| particle.position).collect();
    let record = |frames: u64| {
        let mut recorder = PngRecorder::create(&path, picture(&scene)).unwrap();
        for number in 0..frames {
            recorder.record(&Frame { number, time: 0.0, position: &position, velocity: &[] }).unwrap();
        }
    };
    record(5);
    record(2);
    assert_eq!(names(folder.path()), ["cloth-00000.png", "cloth-00001.png"]);
    // One that was not recorded, and what is behind it, is somebody's.
    fs::write(PngRecorder::numbered(&path, 2), "a photograph").unwrap();
    fs::copy(PngRecorder::numbered(&path, 1), PngRecorder::numbered(&path, 3)).unwrap();
    record(1);
    assert_eq!(names(folder.path()), ["cloth-00000.png", "cloth-00002.png", "cloth-00003.png"]);
    // Begun, but not recorded to, it leaves everything.
    record(0);
    assert_eq!(names(folder.path()).len(), 3);
}

#[test]
fn names_without_an_ending_get_one() {
    assert_eq!(PngRecorder::numbered(Path::new("a/b"), 7), Path::new("a/b-00007.png"));
    assert_eq!(PngRecorder::numbered(Path::new("b.PNG"), 99_999), Path::new("b-99999.PNG"));
}

#[test]
fn failures_name_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "in the way").unwrap();
    let scene = draw_scenes::balls();
    assert!(PngRecorder::create(&file.join("x.png"), picture(&scene)).is_err());
    let path = folder.path().join("gone/x.png");
    let mut recorder = PngRecorder::create(&path, picture(&scene)).unwrap();
    fs::remove_dir(path.parent().unwrap()).unwrap();
    let frame = Frame::<f64> { number: 3, time: 0.0, position: &[], velocity: &[] };
    let error = recorder.record(&frame).unwrap_err();
    assert!(error.to_string().contains("x-00003.png"), "{error}");
}
