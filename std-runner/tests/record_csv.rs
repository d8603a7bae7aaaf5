//! CSV recordings: the same bits come back, frames are whole, and a full disk is told.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::cell::RefCell;
use std::fs::File;
use std::io::{self, Write};
use std::rc::Rc;

use hooke_runner::record::{CsvRecorder, Frame, Recorder, Sample};

/// What was written, kept outside of the recorder.
#[derive(Clone, Default)]
struct Shared(Rc<RefCell<Vec<Vec<u8>>>>);

impl Shared {
    fn text(&self) -> String {
        String::from_utf8(self.0.borrow().concat()).unwrap()
    }
}

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().push(bytes.to_vec());
        Ok(bytes.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn text<R: Sample>(number: R) -> String {
    let mut text = Vec::new();
    number.append_text(&mut text);
    String::from_utf8(text).unwrap()
}

/// Numbers that are spread over all bit patterns, the same in every run.
fn bit_patterns() -> impl Iterator<Item = u64> {
    (1_u64..=200_000).map(|index| {
        let mixed = index.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb)
    })
}

#[test]
fn doubles_read_back_to_the_same_bits() {
    let hard = [
        0.0,
        -0.0,
        0.1,
        1.0 / 3.0,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        f64::from_bits(1),
        f64::from_bits(0x000f_ffff_ffff_ffff),
        f64::EPSILON,
        1e21,
        1e22,
        1e23,
        9_007_199_254_740_993.0,
        5e-324,
    ];
    let random = bit_patterns().map(f64::from_bits);
    // Most random bit patterns are huge or tiny; these are of the size of coordinates.
    let near_one = bit_patterns().map(|bits| (bits as i64) as f64 / 2_f64.powi(62));
    let rounded = bit_patterns().map(|bits| ((bits % 20_000_001) as f64 - 1e7) / 1e5);
    let all = hard.into_iter().chain(random).chain(near_one).chain(rounded);
    for number in all.filter(|number| number.is_finite()) {
        let text = text(number);
        let back: f64 = text.parse().unwrap();
        assert_eq!(back.to_bits(), number.to_bits(), "{number:e} became {text}");
        assert!(text.len() <= format!("{number}").len(), "{number} became {text}");
        assert!(text.len() <= format!("{number:e}").len(), "{number:e} became {text}");
    }
}

#[test]
fn singles_read_back_to_the_same_bits() {
    let hard = [
        0.0,
        -0.0,
        0.1,
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
        f32::from_bits(1),
        f32::from_bits(0x007f_ffff),
        1e21,
        16_777_216.0,
    ];
    let random = bit_patterns().map(|bits| f32::from_bits((bits >> 32) as u32));
    let near_one = bit_patterns().map(|bits| (bits as i64) as f32 / 2_f32.powi(62));
    let all = hard.into_iter().chain(random).chain(near_one);
    for number in all.filter(|number| number.is_finite()) {
        let text = text(number);
        let back: f32 = text.parse().unwrap();
        assert_eq!(back.to_bits(), number.to_bits(), "{number:e} became {text}");
        assert!(text.len() <= format!("{number}").len(), "{number} became {text}");
        assert!(text.len() <= format!("{number:e}").len(), "{number:e} became {text}");
    }
}

#[test]
fn the_shorter_form_is_chosen() {
    let forms = [
        (0.0, "0"),
        (-0.0, "-0"),
        (1.0, "1"),
        (-2.5, "-2.5"),
        (100.0, "100"),
        (1000.0, "1e3"),
        (1234.0, "1234"),
        (12_300.0, "12300"),
        (123_000.0, "123e3"),
        (0.1, "0.1"),
        (0.01, "0.01"),
        (0.001, "1e-3"),
        (0.001_25, "125e-5"),
        (0.012_345, "0.012345"),
        (1e21, "1e21"),
        (1.5e300, "15e299"),
        (5e-324, "5e-324"),
        (f64::NAN, "NaN"),
        (f64::NEG_INFINITY, "-inf"),
    ];
    for (number, expected) in forms {
        assert_eq!(text(number), expected);
    }
    assert_eq!(text(0.1_f32), "0.1");
    assert_eq!(text(f32::MAX), "34028235e31");
}

#[test]
fn rows_are_frames_then_particles() {
    let written = Shared::default();
    let mut recorder = CsvRecorder::new(written.clone(), "frames.csv".into());
    let velocity = [[0.0, -0.0, 4.0], [1.0, 2.0, 3.0]];
    for number in 0..2 {
        let frame = Frame {
            number,
            time: number as f64 / 60.0,
            position: &[[0.1_f32, 0.0, 2.0], [1e-7, 5.0, -6.5]],
            velocity: &velocity,
        };
        recorder.record(&frame).unwrap();
        // One write a frame: what is there always ends in a whole one.
        assert_eq!(written.0.borrow().len() as u64, number + 1);
    }
    Recorder::<f32>::finish(Box::new(recorder)).unwrap();
    assert_eq!(
        written.text(),
        "frame,time,particle,x,y,z,vx,vy,vz\n\
         0,0,0,0.1,0,2,0,-0,4\n\
         0,0,1,1e-7,5,-6.5,1,2,3\n\
         1,0.016666666666666666,0,0.1,0,2,0,-0,4\n\
         1,0.016666666666666666,1,1e-7,5,-6.5,1,2,3\n"
    );
}

#[test]
fn a_recording_of_nothing_has_its_header() {
    let written = Shared::default();
    let mut recorder = CsvRecorder::new(written.clone(), "frames.csv".into());
    let empty = Frame::<f64> { number: 0, time: 0.0, position: &[], velocity: &[] };
    recorder.record(&empty).unwrap();
    Recorder::<f64>::finish(Box::new(recorder)).unwrap();
    assert_eq!(written.text(), "frame,time,particle,x,y,z,vx,vy,vz\n");
}

#[test]
fn a_full_disk_is_told_with_the_name_of_the_file() {
    let Ok(full) = File::options().write(true).open("/dev/full") else {
        eprintln!("SKIPPED: there is no /dev/full here");
        return;
    };
    let mut recorder = CsvRecorder::new(full, "/dev/full".into());
    let frame = Frame { number: 0, time: 0.0, position: &[[1.0_f64; 3]], velocity: &[[1.0; 3]] };
    let error = recorder.record(&frame).unwrap_err();
    assert_eq!(error.source.kind(), io::ErrorKind::StorageFull);
    assert!(error.to_string().starts_with("cannot write /dev/full: "));
}
