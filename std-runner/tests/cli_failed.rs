//! Runs that fail, and runs that are ended from outside: what was recorded can be read.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]
#![cfg(unix)]

mod cli_support;

use std::fs::{self, OpenOptions};
use std::io::{BufRead, BufReader};
use std::os::unix::fs::symlink;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use cli_support::{Folder, ROPE, csv_frames, npz_frames};

fn hooke(folder: &Folder, arguments: &[&str]) -> Command {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin("hooke"));
    command.current_dir(folder.path()).args(arguments);
    command
}

#[test]
fn a_run_that_blows_up_says_where_when_and_why() {
    let folder = Folder::with(ROPE);
    let wild = ["--duration", "100", "--time-step", "0.1", "--frame-rate", "10", "--out", "a.csv", "--out", "a.npz"];
    for stepper in ["explicit-euler", "semi-implicit-euler", "velocity-verlet"] {
        let answer = folder.hooke(&[&["run", "scene.toml", "--stepper", stepper], &wild[..]].concat()).exits(1);
        answer
            .tells(&["warning: ", "particle", "became infinite or NaN in the step after", "spring", "can be read"])
            .tells(&["--time-step 0.0", "--stepper implicit-euler"]);
        let frames = csv_frames(&folder.file("a.csv"));
        assert!(frames > 3);
        assert_eq!(npz_frames(&folder.file("a.npz")), frames);
    }
}

#[test]
fn unsolved_steps_are_a_failure() {
    let folder = Folder::with(ROPE);
    // Far more force than `f32` can resolve against the weight.
    let far = ["--stepper", "implicit-euler", "--duration", "1e6", "--time-step", "1e5", "--frame-rate", "1e-5"];
    let answer = folder.hooke(&[&["run", "scene.toml", "--out", "a.csv"], &far[..]].concat()).exits(1);
    answer.tells(&["of 10 steps were not solved to the tolerance", "--tolerance", "smaller --time-step"]);
    assert_eq!(csv_frames(&folder.file("a.csv")), 11);
}

#[test]
fn interrupting_ends_in_order() {
    ends_in_order("-INT");
}

#[test]
fn being_asked_to_terminate_ends_in_order() {
    ends_in_order("-TERM");
}

fn ends_in_order(signal: &str) {
    let folder = Folder::with(ROPE);
    let arguments =
        ["run", "scene.toml", "--duration", "1e6", "--frame-rate", "200", "--out", "a.csv", "--out", "a.npz"];
    let child = hooke(&folder, &arguments).stderr(Stdio::piped()).spawn().unwrap();
    while fs::metadata(folder.file("a.csv")).map_or(0, |file| file.len()) < 10_000 {
        thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(error.contains("kinetic") && error.contains("of 1000000 s"), "{error}");
    assert!(csv_frames(&folder.file("a.csv")) > 1);
    assert_eq!(csv_frames(&folder.file("a.csv")), npz_frames(&folder.file("a.npz")));
}

#[test]
fn a_reader_that_has_seen_enough_ends_the_run_quietly() {
    let folder = Folder::with(ROPE);
    let arguments = ["run", "scene.toml", "--duration", "1e6", "--out", "-"];
    let mut child = hooke(&folder, &arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(line, "frame,time,particle,x,y,z,vx,vy,vz\n");
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
}

#[test]
fn a_named_pipe_is_recorded_to() {
    let folder = Folder::with(ROPE);
    for name in ["x.csv", "x.gif"] {
        assert!(Command::new("mkfifo").arg(folder.file(name)).status().unwrap().success());
        let child = hooke(&folder, &["run", "scene.toml", "--out", name]).stderr(Stdio::null()).spawn().unwrap();
        let recorded = fs::read(folder.file(name)).unwrap();
        assert!(child.wait_with_output().unwrap().status.success());
        assert!(recorded.starts_with(b"frame,time,") || recorded.starts_with(b"GIF89a"), "{name}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn full_disks_are_told() {
    let folder = Folder::with(ROPE);
    for arguments in
        [&["run", "scene.toml", "--out", "-"][..], &["check", "scene.toml"], &["schema"], &["new", "rope", "-"]]
    {
        let full = OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = hooke(&folder, arguments).stdout(full).output().unwrap();
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(error.contains("standard output") && error.contains("No space left"), "{error}");
    }
    symlink("/dev/full", folder.file("full.csv")).unwrap();
    let answer = folder.hooke(&["run", "scene.toml", "--out", "full.csv"]).exits(1);
    answer.tells(&["cannot write full.csv", "No space left", "no frame was recorded"]);
}
