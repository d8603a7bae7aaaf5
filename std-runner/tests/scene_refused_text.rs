//! Files, keys, types and names that no scene has are refused with the place, what is there, and the remedy.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod scene_support;

use std::path::Path;

use hooke_runner::scene::Scene;
use scene_support::{Folder, SOUND, assert_says, load, refuses, refuses_after};

#[test]
fn the_scene_that_the_others_break_is_sound() {
    load("scene.toml", SOUND).unwrap();
    let spring = "[[spring]]\nbetween = [0, 1]\nstiffness = 0\ndamping = 0\nrest_length = 0\n";
    load("scene.toml", &format!("{SOUND}{spring}{spring}")).unwrap();
}

#[test]
fn unknown_keys_name_the_nearest() {
    refuses_after(
        "[[spring]]\nbetween = [0, 1]\nstifness = 3.0\n",
        "scene.toml:8:1",
        "`spring[0]` has no key `stifness`",
        "Did you mean `stiffness`?",
    );
    refuses("gravitation = [0, 0, 1]\n", "scene.toml:1:1", "`gravitation`", "Did you mean `gravity`?");
    refuses("[[ropes]]\n", "scene.toml:1:3", "`ropes`", "Did you mean `rope`?");
    refuses("[camera]\nfov = 40.0\n", "scene.toml:2:1", "`camera` has no key `fov`", "field_of_view");
    refuses("xyzzy = 1\n", "scene.toml:1:1", "`xyzzy`", "The keys here are name, gravity");
}

#[test]
fn wrong_types_say_what_belongs_there() {
    refuses(
        "time_step = \"fast\"\n",
        "scene.toml:1:13: `time_step`",
        "the text \"fast\"",
        "a number of seconds or \"auto\"",
    );
    refuses("duration = \"2\"", "scene.toml:1:12: `duration`", "the text \"2\"", "write a number");
    refuses("duration = 1979-05-27", "`duration`", "the date 1979-05-27", "write a number");
    refuses("name = 3", "`name`", "the number 3", "a text in double quotes");
    refuses("gravity = 9.81", "`gravity`", "the number 9.81", "a list of 3 numbers");
    refuses("gravity = [0.0, 9.81]", "`gravity`", "a list of 2", "a list of 3 numbers");
    refuses("gravity = [0.0, 0.0, 9.81, 0.0]", "`gravity`", "a list of 4", "a list of 3 numbers");
    refuses("gravity = [0.0, true, 9.81]", "scene.toml:1:17: `gravity[1]`", "`true`", "write a number");
    refuses("particle = 3", "`particle`", "the number 3", "write a list");
    refuses("[particle]\nposition = [0, 0, 0]", "`particle`", "a table", "write `[[particle]]` with two brackets");
    refuses("particle = [[0, 0, 0]]", "`particle[0]`", "a list", "a table of keys and values");
    refuses("[[particle]]\nposition = [0, 0, 0]\npinned = 1", ":3:10: `particle[0].pinned`", "1", "true or false");
    refuses_after("[[spring]]\nbetween = [0, 0.5]\nstiffness = 1", "`spring[0].between[1]`", "0.5", "a whole number");
    refuses_after("[[spring]]\nbetween = [0, -1]\nstiffness = 1", "`spring[0].between[1]`", "-1", "a whole number");
    refuses("stepper = 3", "`stepper`", "the number 3", "\"semi-implicit-euler\"");
}

#[test]
fn missing_keys_are_named() {
    refuses_after("[[spring]]\nbetween = [0, 1]", ":6:1: `spring[0]`", "needs the key `stiffness`", "stiffness = …");
    refuses("[[particle]]\nmass = 1", "scene.toml:1:1: `particle[0].position`", "left out", "position = [x, y, z]");
}

#[test]
fn unknown_names_name_the_nearest_and_all() {
    refuses(
        "stepper = \"semi-implicit-eular\"",
        ":1:11: `stepper`",
        "\"semi-implicit-eular\"",
        "`semi-implicit-euler`? ",
    );
    refuses("stepper = \"zzz\"", "`stepper`", "\"zzz\"", "\"velocity-verlet\", \"rk4\"");
    refuses("precision = \"f16\"", "`precision`", "\"f16\"", "\"f32\", \"f32-compensated\", \"f64\"");
    refuses("collision = \"projection\"", "`collision`", "\"projection\"", "Did you mean `project`?");
}

#[test]
fn files_that_cannot_be_read() {
    let says = |path: &Path, value: &str, remedy: &str| {
        let error = Scene::load(path).unwrap_err();
        assert_says(&error, &path.display().to_string(), value, remedy);
    };
    let folder = Folder::new();
    let there = folder.write("scene.toml", "");
    says(&there, "empty", "hooke new");
    says(&folder.write("blank.toml", " \n# nothing\n"), "empty", "hooke new");
    says(&folder.write("blank.json", "{}"), "empty", "hooke new");
    says(&folder.write("blank.json", "\n"), "empty", "hooke new");
    says(&there.with_file_name("nowhere.toml"), "No such file", "spelling");
    says(&folder.write("scene.yaml", SOUND), "\"yaml\"", "`….toml` or `….json`");
    says(&folder.write("scene", SOUND), "\"\"", "`….toml` or `….json`");
    says(&folder.write("latin.toml", b"name = \"caf\xe9\"\n"), "byte 11 is 0xe9", "UTF-8");
    std::fs::create_dir(there.with_file_name("folder.toml")).unwrap();
    says(&there.with_file_name("folder.toml"), "folder.toml", "not a folder");
    Scene::load(&folder.write("marked.toml", format!("\u{feff}{SOUND}"))).unwrap();
}

#[test]
fn broken_toml_and_json_name_the_line() {
    refuses("gravity = [0, 0\nduration = 1", "scene.toml:2:", "", "key = value");
    refuses("duration = 1\nduration = 2", "scene.toml:2:1", "`duration` is written twice", "");
    refuses("duration = 1e999", "scene.toml:1:12", "1e999", "1.8e308");
    for (json, place, value, remedy) in [
        ("{\"duration\": 1,\n \"gravity\": [0, 0, }", "scene.json:2:20", "not JSON: expected value, at `}`", "comma"),
        ("{\"duration\": 1,\n \"duration\": 2}", "scene.json:2:3", "`duration` is written twice", "keep one"),
        ("{\n\"duration\": 1e999}", "scene.json:2:13", "1e999", "1.8e308"),
        ("[1]", "scene.json:1:1", "a list", "a table"),
        (
            "{\n \"particle\": [{\"position\": [0, 0, 0], \"mas\": 1}]}",
            "scene.json:2:40",
            "`mas`",
            "Did you mean `mass`?",
        ),
        (
            "{\n \"particle\": [{\"position\": [0, 0, 0],\n \"mass\": -1}]}",
            "scene.json:3:10",
            "`particle[0].mass` is -1.0",
            "more than 0",
        ),
        (
            "{\"name\": \"x\",\n\"particle\": [{\"position\": null}]}",
            "scene.json:2:",
            "`particle[0].position`",
            "position",
        ),
    ] {
        let error = load("scene.json", json).unwrap_err();
        assert_says(&error, place, value, remedy);
    }
    let deep = format!("name = {}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert_says(&load("scene.toml", &deep).unwrap_err(), "scene.toml:1:", "", "");
    let deep = format!("{{\"name\": {}{}}}", "[".repeat(100_000), "]".repeat(100_000));
    assert_says(&load("scene.json", &deep).unwrap_err(), "scene.json:1:", "deep", "brackets");
}
