//! The verbs beside `run`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod cli_support;

use std::fs;

use cli_support::{Folder, ROPE};

#[test]
fn new_writes_a_scene_that_checks_and_runs() {
    let folder = Folder::empty();
    for starter in ["rope", "cloth", "block", "balls", "pendulum"] {
        let file = format!("{starter}.toml");
        folder.hooke(&["new", starter]).exits(0).prints_nothing().tells(&[&format!("hooke run {file}")]);
        let answer = folder.hooke(&["check", &file]).exits(0);
        answer.prints(&["nothing to warn of"]);
        folder.hooke(&["run", &file, "--duration", "0.01"]).exits(0);
    }
}

#[test]
fn new_replaces_nothing_unless_forced() {
    let folder = Folder::empty();
    fs::write(folder.file("mine.toml"), "mine").unwrap();
    folder.hooke(&["new", "rope", "mine.toml"]).exits(2).tells(&["mine.toml exists already", "--force"]);
    assert_eq!(fs::read_to_string(folder.file("mine.toml")).unwrap(), "mine");
    folder.hooke(&["new", "rope", "mine.toml", "--force"]).exits(0);
    assert!(fs::read_to_string(folder.file("mine.toml")).unwrap().contains("[[rope]]"));
    folder.hooke(&["new", "rope", "none/mine.toml"]).exits(2).tells(&["mkdir -p none"]);
    folder.hooke(&["new", "rope", "mine.json"]).exits(2).tells(&["mine.toml"]);
    folder.hooke(&["new", "rope", "-"]).exits(0).prints(&["[[rope]]"]);
    assert_eq!(folder.made(), ["mine.toml"]);
}

#[test]
fn check_counts_and_explains() {
    let folder = Folder::with(ROPE);
    let answer = folder.hooke(&["check", "scene.toml"]).exits(0);
    let counts = ["5: 1 pinned", "springs    4", "memory", "100 of 1 ms for 100 ms", "7, 60 a second"];
    let answer = answer.prints(&counts).prints(&["hits: there are no planes", "the forces of 4 springs"]);
    answer.prints(&["velocity-verlet", "spring", "between particles", "below 100 µs", "auto", "nothing to warn of"]);
}

#[test]
fn check_warns_and_exits_0() {
    let folder = Folder::with(ROPE);
    let with = |flags: &[&str]| folder.hooke(&[&["check", "scene.toml"], flags].concat()).exits(0);
    with(&["--time-step", "0.1", "--stepper", "velocity-verlet"]).prints(&["warning: the time step of 100 ms is"]);
    with(&["--time-step", "0.1"]).prints(&["warning: auto will use implicit-euler"]);
    with(&["--stepper", "explicit-euler"]).prints(&["warning: explicit-euler adds"]);
    with(&["--frame-rate", "5000"]).prints(&["warning: 5000 frames per second"]);
}

#[test]
fn bench_tells_who_is_fastest_and_writes_every_run() {
    let folder = Folder::with(ROPE);
    let answer = folder.hooke(&["bench", "scene.toml", "--longest", "0.002", "--out", "runs.csv"]).exits(0);
    answer.prints(&["reference: dop853 in f64", "confirmed by", "fastest to reach an error", "100 mm"]);
    let runs = fs::read_to_string(folder.file("runs.csv")).unwrap();
    let mut lines = runs.lines().skip_while(|line| line.starts_with('#'));
    let columns = lines.next().unwrap().split(',').count();
    assert_eq!(columns, 19);
    assert!(lines.clone().all(|line| line.split(',').count() == columns), "{runs}");
    for stepper in ["semi-implicit-euler,f32", "velocity-verlet,f64", "tr-bdf2,f64"] {
        assert!(lines.clone().any(|line| line.contains(stepper)), "{stepper} in {runs}");
    }
    let answer = folder.hooke(&["bench", "scene.toml", "--longest", "0.002", "--out", "-"]).exits(0);
    answer
        .prints(&["stepper,precision,collision,tolerance,steps,time_step,error,velocity_error"])
        .tells(&["fastest to reach an error"]);
    folder.hooke(&["bench", "scene.toml", "--out", "none/runs.csv"]).exits(2).tells(&["mkdir -p none"]);
    folder.hooke(&["bench", "scene.toml", "--longest", "-1"]).exits(2);
    folder.hooke(&["bench", "nowhere.toml"]).exits(2).tells(&["nowhere.toml"]);
}

#[test]
fn a_stepper_without_damping_refuses_scenes_that_have_some() {
    let folder = Folder::with(ROPE);
    let flags = ["--stepper", "dormand-prince-rkn8"];
    for verb in ["run", "check"] {
        folder.hooke(&[&[verb, "scene.toml"], &flags[..]].concat()).exits(2).tells(&["without damping", "dop853"]);
    }
    let undamped = Folder::with(&ROPE.replace("damping = 0.01", "damping = 0.0"));
    undamped.hooke(&[&["run", "scene.toml"], &flags[..]].concat()).exits(0);
}

#[test]
fn the_schema_is_json() {
    let answer = Folder::empty().hooke(&["schema"]).exits(0);
    let schema: serde_json::Value = serde_json::from_str(&answer.output()).unwrap();
    assert_eq!(schema["title"], "Hooke scene");
}

#[test]
fn completions_for_every_shell() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        Folder::empty().hooke(&["completions", shell]).exits(0).prints(&["hooke", "no-ledger"]);
    }
    Folder::empty().hooke(&["completions", "sh"]).exits(2).tells(&["bash"]);
}

#[test]
fn help_shows_examples_and_units() {
    let folder = Folder::empty();
    let answer = folder.hooke(&["--help"]).exits(0);
    answer.prints(&["Examples:", "hooke new rope", "hooke run rope.toml --out rope.gif", "Units are SI", "Exit codes"]);
    folder.hooke(&["help", "run"]).exits(0).prints(&["Examples:", "--out <FILE>", "--time-step", "Ctrl-C", "NPZ"]);
    folder.hooke(&["--version"]).exits(0).prints(&["hooke "]);
}
