//! Wrong input: told, refused with code 2, and nothing is written.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod cli_support;

use std::fs;

use cli_support::{Folder, ROPE};

#[track_caller]
fn refused(scene: &str, arguments: &[&str], parts: &[&str]) {
    let folder = Folder::with(scene);
    let all = [&["run", "scene.toml", "--out", "good.csv", "--out", "good.npz"], arguments].concat();
    folder.hooke(&all).exits(2).prints_nothing().tells(parts);
    assert!(folder.made().is_empty(), "{:?}", folder.made());
}

#[test]
fn outputs() {
    refused(ROPE, &["--out", "x.foo"], &["x.foo", ".foo", ".csv, .npz, .gif, .png", "help:"]);
    refused(ROPE, &["--out", "x"], &["--out x has no ending", ".csv, .npz, .gif, .png"]);
    refused(ROPE, &["--out", "none/x.csv"], &["there is no folder none", "mkdir -p none"]);
    refused(ROPE, &["--out", "./good.csv"], &["./good.csv is given twice"]);
    refused(ROPE, &["--out", "-", "--out", "-"], &["--out - is given twice"]);
}

#[test]
fn an_output_that_is_a_folder() {
    let folder = Folder::with(ROPE);
    fs::create_dir(folder.file("x.csv")).unwrap();
    folder.hooke(&["run", "scene.toml", "--out", "x.csv"]).exits(2).tells(&["x.csv is a folder"]);
}

#[test]
#[cfg(unix)]
fn an_output_that_leads_to_the_scene() {
    let folder = Folder::with(ROPE);
    std::os::unix::fs::symlink("scene.toml", folder.file("x.csv")).unwrap();
    let answer = folder.hooke(&["run", "scene.toml", "--out", "x.csv"]).exits(2);
    answer.prints_nothing().tells(&["--out x.csv leads to the scene file itself", "another file"]);
    assert_eq!(fs::read_to_string(folder.file("scene.toml")).unwrap(), ROPE);
}

#[test]
#[cfg(target_os = "linux")]
fn places_that_take_no_file() {
    for place in ["/proc/x.csv", "/proc/x.gif", "/proc/x.npz", "/proc/x.png"] {
        refused(ROPE, &["--out", place], &["cannot write /proc/x", "another place"]);
    }
    let folder = Folder::with(ROPE);
    std::os::unix::fs::symlink("/dev/null", folder.file("x.npz")).unwrap();
    folder.hooke(&["run", "scene.toml", "--out", "x.npz"]).exits(2).tells(&["a pipe or a device", "another format"]);
}

#[test]
#[cfg(target_os = "linux")]
fn an_earlier_recording_is_kept_when_another_place_takes_no_file() {
    let folder = Folder::with(ROPE);
    for name in ["a.csv", "a.npz", "a.gif"] {
        fs::write(folder.file(name), "earlier").unwrap();
        folder.hooke(&["run", "scene.toml", "--out", name, "--out", "new.csv", "--out", "/proc/x.csv"]).exits(2);
        assert_eq!(fs::read_to_string(folder.file(name)).unwrap(), "earlier");
        assert!(!folder.file("new.csv").exists());
        // Otherwise nothing of it is left, however long it was.
        fs::write(folder.file(name), [b'x'; 1_000_000]).unwrap();
        folder.hooke(&["run", "scene.toml", "--out", name]).exits(0);
        assert!(fs::metadata(folder.file(name)).unwrap().len() < 900_000);
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_scene_without_an_end() {
    let folder = Folder::empty();
    std::os::unix::fs::symlink("/dev/zero", folder.file("zero.toml")).unwrap();
    let answer = folder.hooke(&["run", "zero.toml"]).exits(2).prints_nothing();
    answer.tells(&["zero.toml", "cannot read a scene here: it is longer than 256 MiB", "the file you mean"]);
}

#[test]
fn scenes() {
    refused("gravty = [0.0, 0.0, 1.0]", &[], &["scene.toml:1:1", "gravty", "gravity"]);
    refused("duration = -1.0", &[], &["scene.toml:1:", "duration", "-1.0", "more than 0"]);
    refused("[[particle]]\nposition = [0.0, 0.0, 0.0]\nmass = 1e-300", &[], &["particle 0", "--precision f64"]);
    let folder = Folder::empty();
    folder.hooke(&["run", "nothing.toml"]).exits(2).tells(&["nothing.toml", "help:"]);
    folder.hooke(&["check", "nothing.toml"]).exits(2).prints_nothing().tells(&["nothing.toml"]);
}

#[test]
fn flags() {
    refused(ROPE, &["--time-step", "-1"], &["--time-step", "-1.0", "more than 0"]);
    refused(ROPE, &["--time-step", "1e-60"], &["1e-60 s", "f32", "--precision f64"]);
    refused(ROPE, &["--stepper", "newton"], &["newton", "velocity-verlet"]);
    refused(ROPE, &["--gravity", "1,2"], &["1,2", "three numbers"]);
    refused(ROPE, &["--unknown"], &["--unknown"]);
}

#[test]
fn runs_without_an_end() {
    let parts = ["more steps or frames than can be counted", "--duration", "--time-step", "--frame-rate"];
    refused(ROPE, &["--duration", "1e308"], &parts);
    refused(ROPE, &["--frame-rate", "1e300"], &parts);
    refused(ROPE, &["--time-step", "1e-300", "--precision", "f64"], &parts);
    refused("[[particle]]\nposition = [0.0, 0.0, 0.0]\nvelocity = [1.0, 0.0, 0.0]", &["--duration", "1e308"], &parts);
    let check = Folder::with(ROPE).hooke(&["check", "scene.toml", "--duration", "1e308"]).exits(2);
    check.prints_nothing().tells(&parts);
}

#[test]
fn a_name_of_one_line() {
    for name in ["a\\u001b[31mb", "a\\nb"] {
        refused(&format!("name = \"{name}\"\n{ROPE}"), &[], &["scene.toml:1:8", "one line of text"]);
    }
}

#[test]
fn little_is_shown_of_a_long_line() {
    let folder = Folder::empty();
    let particles = vec!["{\"position\": [0, 0, 0]}"; 10_000].join(", ");
    for (rest, place) in [("\"gravty\": 1", "scene.json:1:250017"), ("\"name\": [1]", "scene.json:1:250024")] {
        fs::write(folder.file("scene.json"), format!("{{\"particle\": [{particles}], {rest}}}")).unwrap();
        let answer = folder.hooke(&["check", "scene.json"]).exits(2).tells(&[place, rest, "`--"]);
        assert!(answer.error().len() < 2000, "{}", answer.error().len());
    }
    let list = vec!["1.0"; 10_000].join(",\n");
    fs::write(folder.file("scene.toml"), format!("duration = [\n{list}\n]\n")).unwrap();
    let answer = folder.hooke(&["check", "scene.toml"]).exits(2).tells(&["scene.toml:1:12", "found a list"]);
    assert!(answer.error().len() < 2000, "{}", answer.error());
}

#[test]
fn no_verb_at_all() {
    Folder::empty().hooke(&[]).exits(2).tells(&["Usage: hooke", "run", "check", "new"]);
}
