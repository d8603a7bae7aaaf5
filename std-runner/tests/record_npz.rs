//! NPZ recordings: what went in comes out, also while a recording is being made, after any write of it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::cell::RefCell;
use std::fs::{self, File};
use std::io::{self, Cursor, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::rc::Rc;

use hooke_runner::record::{Frame, NpzRecorder, Recorder, Sample};
use npyz::npz::NpzArchive;

const SPRINGS: [[u32; 2]; 3] = [[0, 1], [1, 2], [u32::MAX, 7]];

/// Frame `number` of a made-up run, in which every number is another.
fn numbers<R: Sample>(number: u64, particles: usize, offset: f64) -> Vec<[R; 3]> {
    (0..particles)
        .map(|particle| {
            let base = offset + number as f64 * 1000.0 + particle as f64;
            [0.1, 0.2, 0.3].map(|part| R::from_f64(base + part))
        })
        .collect()
}

fn record<R: Sample>(recorder: &mut impl Recorder<R>, number: u64, particles: usize) {
    let frame = Frame {
        number,
        time: number as f64 / 60.0,
        position: &numbers(number, particles, 0.0),
        velocity: &numbers(number, particles, -0.5),
    };
    recorder.record(&frame).unwrap();
}

/// Reads an array to its end and on to the end of its entry, where the checksum is compared.
fn array<T: npyz::Deserialize>(archive: &mut NpzArchive<impl Read + Seek>, name: &str) -> (Vec<u64>, Vec<T>) {
    let array = archive.by_name(name).unwrap().unwrap();
    let shape = array.shape().to_vec();
    let values = array.into_vec().unwrap();
    let entry = archive.zip_archive();
    let mut whole = entry.by_name(&format!("{name}.npy")).unwrap();
    io::copy(&mut whole, &mut io::sink()).unwrap();
    (shape, values)
}

/// Checks everything in a recording, and returns how many frames `time`, `position` and `velocity` have.
fn check<R: Sample + npyz::Deserialize>(file: impl Read + Seek, particles: usize) -> [u64; 3] {
    let mut archive = NpzArchive::new(file).unwrap();
    let (shape, springs) = array::<u32>(&mut archive, "springs");
    assert_eq!(shape, [SPRINGS.len() as u64, 2]);
    assert_eq!(springs, SPRINGS.as_flattened());
    let (shape, times) = array::<f64>(&mut archive, "time");
    let expected: Vec<f64> = (0..shape[0]).map(|frame| frame as f64 / 60.0).collect();
    assert_eq!(times, expected);
    let counts = [("position", 0.0), ("velocity", -0.5)].map(|(name, offset)| {
        let (shape, values) = array::<R>(&mut archive, name);
        assert_eq!(shape[1..], [particles as u64, 3]);
        let expected: Vec<[R; 3]> = (0..shape[0]).flat_map(|frame| numbers(frame, particles, offset)).collect();
        assert_eq!(values, expected.as_flattened());
        shape[0]
    });
    [shape[0], counts[0], counts[1]]
}

fn round_trip<R: Sample + npyz::Deserialize>(particles: usize, frames: u64) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("frames.npz");
    let copy = folder.path().join("copy.npz");
    let mut recorder = NpzRecorder::<R>::create(&path, particles, &SPRINGS, frames).unwrap();
    assert_eq!(check::<R>(File::open(&path).unwrap(), particles), [0; 3]);
    for number in 0..frames {
        record(&mut recorder, number, particles);
        // What a killed process leaves is what is there now.
        fs::copy(&path, &copy).unwrap();
        assert_eq!(check::<R>(File::open(&copy).unwrap(), particles), [number + 1; 3]);
    }
    Recorder::<R>::finish(Box::new(recorder)).unwrap();
    assert_eq!(check::<R>(File::open(&path).unwrap(), particles), [frames; 3]);
}

#[test]
fn singles_come_back() {
    round_trip::<f32>(5, 12);
}

#[test]
fn doubles_come_back() {
    round_trip::<f64>(5, 12);
}

#[test]
fn frames_longer_than_one_write_come_back() {
    round_trip::<f32>(30_001, 3);
}

#[test]
fn a_recording_without_particles_comes_back() {
    round_trip::<f64>(0, 2);
}

#[test]
fn a_recording_that_ends_early_has_the_frames_it_has() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("frames.npz");
    let mut recorder = NpzRecorder::<f32>::create(&path, 4, &SPRINGS, 1_000_000).unwrap();
    for number in 0..11 {
        record(&mut recorder, number, 4);
    }
    Recorder::<f32>::finish(Box::new(recorder)).unwrap();
    assert_eq!(check::<f32>(File::open(&path).unwrap(), 4), [11; 3]);
}

/// Where something was written, and what.
type Written = (u64, Vec<u8>);

/// A file that remembers each write.
#[derive(Clone, Default)]
struct Remembering {
    at: u64,
    writes: Rc<RefCell<Vec<Written>>>,
}

impl Write for Remembering {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writes.borrow_mut().push((self.at, bytes.to_vec()));
        self.at += bytes.len() as u64;
        Ok(bytes.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Remembering {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let SeekFrom::Start(at) = to else {
            panic!("{to:?}");
        };
        self.at = at;
        Ok(at)
    }
}

/// A run that is killed between any two writes leaves a valid archive of the frames it had finished.
#[test]
fn a_recording_is_readable_after_every_write() {
    let particles = 3;
    let frames = 12;
    let file = Remembering::default();
    let writes = Rc::clone(&file.writes);
    let mut recorder = NpzRecorder::<f32, _>::begin(file, "frames.npz".into(), particles, &SPRINGS, frames).unwrap();
    let mut finished_after = vec![writes.borrow().len()];
    for number in 0..frames {
        record(&mut recorder, number, particles);
        finished_after.push(writes.borrow().len());
    }
    let mut image = Cursor::new(Vec::new());
    for (index, (at, bytes)) in writes.borrow().iter().enumerate() {
        image.seek(SeekFrom::Start(*at)).unwrap();
        image.write_all(bytes).unwrap();
        if index + 1 < finished_after[0] {
            continue;
        }
        let finished = finished_after.partition_point(|&count| count <= index + 1) as u64 - 1;
        let [time, position, velocity] = check::<f32>(Cursor::new(image.get_ref().as_slice()), particles);
        let message = format!("{finished} frames, {index} writes: {time} {position} {velocity}");
        assert!(finished <= time && time <= finished + 1, "{message}");
        assert!(time <= position && position <= finished + 1, "{message}");
        assert!(time <= velocity && velocity <= finished + 1, "{message}");
    }
    assert_eq!(finished_after.len() as u64, frames + 1);
}

/// The writes that replace what readers look at lie within one page each, so that a kill can't halve them.
#[test]
fn what_is_replaced_is_replaced_within_a_page() {
    let file = Remembering::default();
    let writes = Rc::clone(&file.writes);
    let mut recorder = NpzRecorder::<f64, _>::begin(file, "frames.npz".into(), 700, &SPRINGS, 1 << 40).unwrap();
    let begun = writes.borrow().len();
    for number in 0..3 {
        record(&mut recorder, number, 700);
    }
    let writes = writes.borrow();
    let replaced: Vec<_> =
        writes[begun..].iter().filter(|(at, _)| writes[..begun].iter().any(|(before, _)| at == before)).collect();
    assert_eq!(replaced.len(), 3 * 4);
    for (at, bytes) in replaced {
        assert_eq!(at / 4096, (at + bytes.len() as u64 - 1) / 4096);
        assert_eq!(at / 512, (at + bytes.len() as u64 - 1) / 512);
    }
}

#[test]
fn the_same_frames_make_the_same_file() {
    let files = [0, 1].map(|_| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frames.npz");
        let mut recorder = NpzRecorder::<f32>::create(&path, 4, &SPRINGS, 2).unwrap();
        record(&mut recorder, 0, 4);
        fs::read(path).unwrap()
    });
    assert!(files[0] == files[1]);
}

#[test]
fn one_frame_too_many_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("frames.npz");
    let mut recorder = NpzRecorder::<f32>::create(&path, 1, &SPRINGS, 1).unwrap();
    record(&mut recorder, 0, 1);
    let frame = Frame { number: 1, time: 1.0, position: &[[0.0; 3]], velocity: &[[0.0; 3]] };
    let error = recorder.record(&frame).unwrap_err();
    assert_eq!(error.source.kind(), ErrorKind::InvalidInput);
    assert!(error.to_string().contains("room for 1 frames"), "{error}");
    assert_eq!(check::<f32>(File::open(&path).unwrap(), 1), [1; 3]);
}

#[test]
fn a_frame_of_other_particles_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("frames.npz");
    let mut recorder = NpzRecorder::<f32>::create(&path, 2, &SPRINGS, 1).unwrap();
    let frame = Frame { number: 0, time: 0.0, position: &[[0.0; 3]], velocity: &[[0.0; 3]] };
    let error = recorder.record(&frame).unwrap_err();
    assert_eq!(error.source.kind(), ErrorKind::InvalidInput);
    record(&mut recorder, 0, 2);
}

#[test]
fn what_no_file_can_hold_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for frames in [1 << 60, u64::MAX] {
        let path = folder.path().join("frames.npz");
        let error = NpzRecorder::<f32>::create(&path, 2, &SPRINGS, frames).err().unwrap();
        assert_eq!(error.source.kind(), ErrorKind::FileTooLarge);
        assert!(error.to_string().contains("frames.npz"), "{error}");
    }
}

#[test]
fn a_place_that_is_not_there_is_told() {
    let error = NpzRecorder::<f32>::create(Path::new("/no/such/frames.npz"), 1, &SPRINGS, 1).err().unwrap();
    assert_eq!(error.source.kind(), ErrorKind::NotFound);
    assert!(error.to_string().contains("/no/such/frames.npz"));
}

/// Offsets beyond 4 GiB, in a file that is nearly all hole.
#[test]
fn a_file_longer_than_4_gib_comes_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("frames.npz");
    let mut recorder = NpzRecorder::<f64>::create(&path, 1000, &SPRINGS, 400_000).unwrap();
    assert!(fs::metadata(&path).unwrap().len() > 1 << 34);
    for number in 0..3 {
        record(&mut recorder, number, 1000);
    }
    assert_eq!(check::<f64>(File::open(&path).unwrap(), 1000), [3; 3]);
}

/// Arrays of more than 4 GiB each.
#[test]
#[ignore = "takes 9 GB of disk"]
fn an_array_longer_than_4_gib_comes_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("frames.npz");
    let particles = 20_000_000;
    let mut recorder = NpzRecorder::<f64>::create(&path, particles, &SPRINGS, 10).unwrap();
    let mut values = vec![[1.5, -2.5, 0.0]; particles];
    for number in 0..10 {
        values[0] = [number as f64; 3];
        let frame = Frame { number, time: number as f64, position: &values, velocity: &values };
        recorder.record(&frame).unwrap();
    }
    let mut archive = NpzArchive::open(&path).unwrap();
    for name in ["position", "velocity"] {
        let array = archive.by_name(name).unwrap().unwrap();
        assert_eq!(array.shape(), [10, particles as u64, 3]);
        let mut rows = array.data::<f64>().unwrap().map(Result::unwrap);
        for number in 0..10 {
            values[0] = [f64::from(number); 3];
            assert!(values.as_flattened().iter().all(|&value| rows.next() == Some(value)));
        }
        assert_eq!(rows.next(), None);
    }
}
