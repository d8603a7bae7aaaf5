//! `hooke run` where everything is right.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod cli_support;

use std::fs;

use cli_support::{Folder, ROPE, csv_frames, npz_frames};

#[test]
fn without_out_only_the_summary_is_printed() {
    let folder = Folder::with(ROPE);
    let answer = folder.hooke(&["run", "scene.toml"]).exits(0).prints_nothing();
    answer.tells(&[
        "100 of 1 ms, auto, f32",
        "auto chose",
        "velocity-verlet",
        "not recorded",
        "ns per spring and step",
    ]);
    assert!(folder.made().is_empty());
}

#[test]
fn the_summary_has_the_ledger_unless_it_is_left_out() {
    let folder = Folder::with(ROPE);
    let lines = ["kinetic", "elastic", "gravitational", "lost to damping", "lost in impacts", "work of moving pins"];
    folder.hooke(&["run", "scene.toml"]).exits(0).tells(&lines).tells(&["integrator's own error"]);
    let without = folder.hooke(&["run", "scene.toml", "--no-ledger"]).exits(0);
    assert!(!without.error().contains("kinetic"));
}

#[test]
fn out_repeats_and_its_ending_picks_the_format() {
    let folder = Folder::with(ROPE);
    let answer = folder.hooke(&["run", "scene.toml", "--out", "a.csv", "--out", "b.npz", "-o", "C.CSV"]).exits(0);
    answer.prints_nothing().tells(&["to a.csv, b.npz, C.CSV"]);
    assert_eq!(folder.made(), ["C.CSV", "a.csv", "b.npz"]);
    assert_eq!(csv_frames(&folder.file("a.csv")), 7);
    assert_eq!(npz_frames(&folder.file("b.npz")), 7);
    assert_eq!(fs::read(folder.file("a.csv")).unwrap(), fs::read(folder.file("C.CSV")).unwrap());
}

#[test]
fn a_dash_is_csv_on_standard_output_and_nothing_else() {
    let folder = Folder::with(ROPE);
    let answer = folder.hooke(&["run", "scene.toml", "--out", "-", "--out", "a.csv"]).exits(0);
    assert_eq!(answer.output(), fs::read_to_string(folder.file("a.csv")).unwrap());
    assert_eq!(folder.made(), ["a.csv"]);
}

#[test]
fn flags_win_over_the_scene() {
    let folder = Folder::with(ROPE);
    let flags = ["--duration", "0.05", "--time-step", "2e-3", "--frame-rate", "100", "--precision", "f64"];
    let more = ["--stepper", "semi-implicit-euler", "--gravity", "0,0,0", "--out", "a.csv"];
    let answer = folder.hooke(&[&["run", "scene.toml"], &flags[..], &more[..]].concat()).exits(0);
    answer.tells(&["25 of 2 ms, semi-implicit-euler, f64", "gravity: it is 0"]);
    let text = fs::read_to_string(folder.file("a.csv")).unwrap();
    assert_eq!(csv_frames(&folder.file("a.csv")), 6);
    assert!(text.contains("\n5,0.05,4,1,0,1,0,0,0\n"), "nothing moves without gravity: {text}");
}

#[test]
fn every_frame_is_the_state_at_its_time() {
    let scene = "duration = 0.3\ntime_step = 1e-3\nframe_rate = 50\nprecision = \"f64\"\n\
                 stepper = \"semi-implicit-euler\"\n[[particle]]\nposition = [0.0, 0.0, 0.0]\nvelocity = [2.0, 0.0, 0.0]";
    let folder = Folder::with(scene);
    folder.hooke(&["run", "scene.toml", "--out", "a.csv"]).exits(0);
    let text = fs::read_to_string(folder.file("a.csv")).unwrap();
    for row in text.lines().skip(1) {
        let values: Vec<f64> = row.split(',').map(|value| value.parse().unwrap()).collect();
        assert!((values[3] - 2.0 * values[1]).abs() < 1e-12, "{row}");
    }
}

#[test]
fn a_shorter_last_step_is_told() {
    let folder = Folder::with(ROPE);
    let answer = folder.hooke(&["run", "scene.toml", "--time-step", "3e-3"]).exits(0);
    answer.tells(&["34 of 3 ms", "the last step is 1 ms, since the duration is not a whole number of steps"]);
    assert!(!folder.hooke(&["run", "scene.toml"]).error().contains("last step"));
}

#[test]
fn a_pipe_gets_no_progress_bar_and_no_escape_codes() {
    let folder = Folder::with(ROPE);
    for arguments in
        [&["run", "scene.toml"][..], &["check", "scene.toml"], &["run", "nothing.toml"], &["run", "--help"]]
    {
        let answer = folder.hooke(arguments);
        let all = answer.output() + &answer.error();
        assert!(!all.contains(['\u{1b}', '\r', '█', '░']), "{all}");
    }
}

#[test]
fn hits_and_exact_flight_are_told() {
    let scene = "gravity = [0.0, 0.0, -10.0]\n[[particle]]\nposition = [0.0, 0.0, 0.1]\n\
                 [[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\nrestitution = 0.5";
    let folder = Folder::with(scene);
    let answer = folder.hooke(&["run", "scene.toml"]).exits(0);
    answer.tells(&["60 from frame to frame", "hits", "spring forces: there are no springs", "lost in impacts"]);
}

#[test]
fn the_digest_is_one_line_that_tells_the_last_state() {
    let folder = Folder::with(ROPE);
    let digest = |more: &[&str]| {
        let answer = folder.hooke(&[&["run", "scene.toml", "--digest"], more].concat()).exits(0);
        let line = answer.output();
        let digest = line.strip_suffix('\n').unwrap().to_owned();
        assert!(digest.len() == 16 && digest.chars().all(|digit| digit.is_ascii_hexdigit()), "{line:?}");
        answer.tells(&["digest", &digest]);
        digest
    };
    let expected = digest(&[]);
    // What is recorded, kept or shared among threads does not concern the state.
    for same in [&["--no-ledger"][..], &["--threads", "2"], &["--frame-rate", "17", "--out", "a.csv"]] {
        assert_eq!(digest(same), expected, "{same:?}");
    }
    for other in [["--duration", "0.099"], ["--precision", "f64"], ["--gravity", "0,0,-9.8100000000001"]] {
        let is_same = digest(&other) == expected;
        // This gravity is the same number in f32.
        assert_eq!(is_same, other[0] == "--gravity", "{other:?}");
    }
    assert!(!folder.hooke(&["run", "scene.toml"]).exits(0).error().contains("digest"));
}

#[test]
fn the_digest_and_frames_do_not_share_standard_output() {
    let folder = Folder::with(ROPE);
    let answer = folder.hooke(&["run", "scene.toml", "--digest", "--out", "-"]).exits(2);
    answer.prints_nothing().tells(&["--digest and --out -", "--out FILE.csv"]);
}

#[test]
fn a_run_to_an_accuracy_has_a_digest() {
    let folder = Folder::with(ROPE);
    let run = || folder.hooke(&["run", "scene.toml", "--max-error", "1e-4", "--digest"]).exits(0).output();
    let digest = run();
    assert_eq!((digest.len(), run()), (17, digest));
}
