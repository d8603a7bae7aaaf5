//! `hooke run --max-error`, as a person uses it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod cli_support;

use std::fs;

use cli_support::{Folder, ROPE};

/// Hit by hit, three balls on two slopes part from what is all but the same: nobody knows where they are for long.
const CHAOS: &str = "\
gravity = [0.0, 0.0, -9.81]
duration = 60.0
frame_rate = 1

[[cloud]]
corner = [-0.5, -0.5, 1.0]
size = [1.0, 1.0, 1.0]
particles = 3
mass = 0.1

[[plane]]
point = [0.0, 0.0, 0.0]
normal = [1.0, 0.0, 1.0]
[[plane]]
point = [0.0, 0.0, 0.0]
normal = [-1.0, 0.2, 1.0]
[[plane]]
point = [0.0, 0.0, 0.0]
normal = [0.0, -1.0, 1.0]
[[plane]]
point = [0.0, 0.0, 0.0]
normal = [0.0, 1.0, 1.0]
";

#[test]
fn an_error_is_asked_for_and_told() {
    let folder = Folder::with(ROPE);
    let asked = ["run", "scene.toml", "--max-error", "1e-5", "--out", "run.csv"];
    let told = folder.hooke(&asked).exits(0);
    told.tells(&["error", "10 µm was asked for", "dop853 in f", "without pilot runs", "the whole duration"]);
    // A stiff spring takes more steps.
    let stiff = ROPE.replace("particles = 5", "particles = 2").replace("stiffness = 100.0", "stiffness = 1e4");
    let long = Folder::with(&stiff).hooke(&["run", "scene.toml", "--max-error", "1e-4", "--duration", "1"]).exits(0);
    long.tells(&["by pilot runs of", "might take"]);
    let rows = fs::read_to_string(folder.file("run.csv")).unwrap();
    // Seven frames of five particles, and the header.
    assert_eq!(rows.lines().count(), 36, "{rows}");
}

#[test]
fn it_gives_the_same_bits_again_whatever_is_recorded() {
    let folder = Folder::with(ROPE);
    let last = |flags: &[&str], file: &str| {
        let flags = [&["run", "scene.toml", "--max-error", "1e-6", "--out", file], flags].concat();
        folder.hooke(&flags).exits(0);
        let rows = fs::read_to_string(folder.file(file)).unwrap();
        // Time and state of the last particle in the last frame.
        rows.lines().last().unwrap().split_once(',').unwrap().1.to_owned()
    };
    let once = last(&[], "once.csv");
    assert_eq!(once, last(&[], "again.csv"));
    assert_eq!(once, last(&["--frame-rate", "13"], "rarely.csv"), "frames are no part of the motion");
    assert_eq!(once, last(&["--threads", "2", "--no-ledger"], "threads.csv"));
}

#[test]
fn flags_beside_it_are_kept_to() {
    let folder = Folder::with(ROPE);
    let run = |flags: &[&str]| folder.hooke(&[&["run", "scene.toml", "--max-error", "1e-4"], flags].concat());
    run(&["--stepper", "rk4"]).exits(0).tells(&["rk4"]);
    run(&["--precision", "f32-compensated"]).exits(0).tells(&["f32-compensated"]);
    run(&["--time-step", "1e-3"]).exits(2).tells(&["--time-step", "max_error", "leave out one of the two"]);
    run(&["--out", "-"]).exits(2).prints_nothing().tells(&["standard output", "--out FILE.csv"]);
    for wrong in ["0", "-1", "nan", "inf"] {
        folder.hooke(&["run", "scene.toml", "--max-error", wrong]).exits(2).tells(&["--max-error"]);
    }
}

#[test]
fn it_is_a_key_of_scenes() {
    let scene = ROPE.replace("time_step = 1e-3\n", "max_error = 1e-4\n");
    let folder = Folder::with(&scene);
    assert!(scene.contains("max_error"), "{scene}");
    folder.hooke(&["run", "scene.toml"]).exits(0).tells(&["100 µm was asked for"]);
    folder.hooke(&["check", "scene.toml"]).exits(0).prints(&["found by pilot runs for an error of 100 µm"]);
    // A time step on the command line stands in place of it.
    folder.hooke(&["run", "scene.toml", "--time-step", "1e-3"]).exits(0).tells(&["100 of 1 ms"]);
    let both = Folder::with(&format!("max_error = 1e-4\n{ROPE}"));
    both.hooke(&["check", "scene.toml"]).exits(2).tells(&["time_step", "max_error"]);
}

#[test]
fn where_motion_is_chaotic_it_says_until_when() {
    let folder = Folder::with(CHAOS);
    let told = folder.hooke(&["run", "scene.toml", "--max-error", "1e-3", "--out", "run.csv"]).exits(1);
    told.tells(&["the error stays below 1 mm until", "chaotic"]);
    let rows = fs::read_to_string(folder.file("run.csv")).unwrap();
    assert_eq!(rows.lines().count(), 1 + 3 * 61, "all frames are there all the same");
    // For as long as it can be known it is kept to.
    folder.hooke(&["run", "scene.toml", "--max-error", "1e-3", "--duration", "2"]).exits(0).tells(&["whole duration"]);
}
