//! Every scene that cannot be run is refused with the place, the value and the remedy.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod scene_support;

use std::path::Path;

use hooke_runner::scene::Scene;
use scene_support::{Folder, assert_says, load, printed};

/// A sound scene to break one thing in.
const SOUND: &str = r#"
[[particle]]
position = [0, 0, 1]
[[particle]]
position = [1, 0, 1]
"#;

#[track_caller]
fn refuses(toml: &str, place: &str, value: &str, remedy: &str) {
    let error = load("scene.toml", toml)
        .err()
        .unwrap_or_else(|| panic!("loaded:\n{toml}"));
    eprintln!("{}", printed(&error));
    assert_says(&error, place, value, remedy);
}

/// With `line` after a sound scene; it stands on line 6 or later.
#[track_caller]
fn refuses_after(lines: &str, place: &str, value: &str, remedy: &str) {
    refuses(&format!("{SOUND}{lines}"), place, value, remedy);
}

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
    refuses(
        "gravitation = [0, 0, 1]\n",
        "scene.toml:1:1",
        "`gravitation`",
        "Did you mean `gravity`?",
    );
    refuses(
        "[[ropes]]\n",
        "scene.toml:1:3",
        "`ropes`",
        "Did you mean `rope`?",
    );
    refuses(
        "[camera]\nfov = 40.0\n",
        "scene.toml:2:1",
        "`camera` has no key `fov`",
        "field_of_view",
    );
    refuses(
        "xyzzy = 1\n",
        "scene.toml:1:1",
        "`xyzzy`",
        "The keys here are name, gravity",
    );
}

#[test]
fn wrong_types_say_what_belongs_there() {
    refuses(
        "time_step = \"fast\"\n",
        "scene.toml:1:13: `time_step`",
        "the text \"fast\"",
        "a number of seconds or \"auto\"",
    );
    refuses(
        "duration = \"2\"",
        "scene.toml:1:12: `duration`",
        "the text \"2\"",
        "write a number",
    );
    refuses(
        "duration = 1979-05-27",
        "`duration`",
        "the date 1979-05-27",
        "write a number",
    );
    refuses(
        "name = 3",
        "`name`",
        "the number 3",
        "a text in double quotes",
    );
    refuses(
        "gravity = 9.81",
        "`gravity`",
        "the number 9.81",
        "a list of 3 numbers",
    );
    refuses(
        "gravity = [0.0, 9.81]",
        "`gravity`",
        "a list of 2",
        "a list of 3 numbers",
    );
    refuses(
        "gravity = [0.0, 0.0, 9.81, 0.0]",
        "`gravity`",
        "a list of 4",
        "a list of 3 numbers",
    );
    refuses(
        "gravity = [0.0, true, 9.81]",
        "scene.toml:1:17: `gravity[1]`",
        "`true`",
        "write a number",
    );
    refuses("particle = 3", "`particle`", "the number 3", "write a list");
    refuses(
        "[particle]\nposition = [0, 0, 0]",
        "`particle`",
        "a table",
        "write `[[particle]]` with two brackets",
    );
    refuses(
        "particle = [[0, 0, 0]]",
        "`particle[0]`",
        "a list",
        "a table of keys and values",
    );
    refuses(
        "[[particle]]\nposition = [0, 0, 0]\npinned = 1",
        ":3:10: `particle[0].pinned`",
        "1",
        "true or false",
    );
    refuses_after(
        "[[spring]]\nbetween = [0, 0.5]\nstiffness = 1",
        "`spring[0].between[1]`",
        "0.5",
        "a whole number",
    );
    refuses_after(
        "[[spring]]\nbetween = [0, -1]\nstiffness = 1",
        "`spring[0].between[1]`",
        "-1",
        "a whole number",
    );
    refuses(
        "stepper = 3",
        "`stepper`",
        "the number 3",
        "\"semi-implicit-euler\"",
    );
}

#[test]
fn missing_keys_are_named() {
    refuses_after(
        "[[spring]]\nbetween = [0, 1]",
        ":6:1: `spring[0]`",
        "needs the key `stiffness`",
        "stiffness = …",
    );
    refuses(
        "[[particle]]\nmass = 1",
        "scene.toml:1:1: `particle[0].position`",
        "left out",
        "position = [x, y, z]",
    );
}

#[test]
fn unknown_names_name_the_nearest_and_all() {
    refuses(
        "stepper = \"semi-implicit-eular\"",
        ":1:11: `stepper`",
        "\"semi-implicit-eular\"",
        "`semi-implicit-euler`? ",
    );
    refuses(
        "stepper = \"zzz\"",
        "`stepper`",
        "\"zzz\"",
        "\"velocity-verlet\", \"auto\"",
    );
    refuses(
        "precision = \"f16\"",
        "`precision`",
        "\"f16\"",
        "\"f32\", \"f64\"",
    );
    refuses(
        "collision = \"projection\"",
        "`collision`",
        "\"projection\"",
        "Did you mean `project`?",
    );
}

#[test]
fn files_that_cannot_be_read() {
    let says = |path: &Path, value: &str, remedy: &str| {
        let error = Scene::load(path).unwrap_err();
        eprintln!("{}", printed(&error));
        assert_says(&error, &path.display().to_string(), value, remedy);
    };
    let folder = Folder::new();
    let there = folder.write("scene.toml", "");
    says(&there, "empty", "hooke new");
    says(
        &folder.write("blank.toml", " \n# nothing\n"),
        "empty",
        "hooke new",
    );
    says(&folder.write("blank.json", "{}"), "empty", "hooke new");
    says(&folder.write("blank.json", "\n"), "empty", "hooke new");
    says(
        &there.with_file_name("nowhere.toml"),
        "No such file",
        "spelling",
    );
    says(
        &folder.write("scene.yaml", SOUND),
        "\"yaml\"",
        "`….toml` or `….json`",
    );
    says(
        &folder.write("scene", SOUND),
        "\"\"",
        "`….toml` or `….json`",
    );
    says(
        &folder.write("latin.toml", b"name = \"caf\xe9\"\n"),
        "byte 11 is 0xe9",
        "UTF-8",
    );
    std::fs::create_dir(there.with_file_name("folder.toml")).unwrap();
    says(
        &there.with_file_name("folder.toml"),
        "folder.toml",
        "not a folder",
    );
    Scene::load(&folder.write("marked.toml", format!("\u{feff}{SOUND}"))).unwrap();
}

#[test]
fn broken_toml_and_json_name_the_line() {
    refuses(
        "gravity = [0, 0\nduration = 1",
        "scene.toml:2:",
        "",
        "key = value",
    );
    refuses(
        "duration = 1\nduration = 2",
        "scene.toml:2:1",
        "`duration` is written twice",
        "",
    );
    refuses("duration = 1e999", "scene.toml:1:12", "1e999", "1.8e308");
    for (json, place, value, remedy) in [
        (
            "{\"duration\": 1,\n \"gravity\": [0, 0, }",
            "scene.json:2:20",
            "not JSON: expected value, at `}`",
            "comma",
        ),
        (
            "{\"duration\": 1,\n \"duration\": 2}",
            "scene.json:2:3",
            "`duration` is written twice",
            "keep one",
        ),
        (
            "{\n\"duration\": 1e999}",
            "scene.json:2:13",
            "1e999",
            "1.8e308",
        ),
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
        eprintln!("{}", printed(&error));
        assert_says(&error, place, value, remedy);
    }
    let deep = format!("name = {}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert_says(
        &load("scene.toml", &deep).unwrap_err(),
        "scene.toml:1:",
        "",
        "",
    );
    let deep = format!(
        "{{\"name\": {}{}}}",
        "[".repeat(100_000),
        "]".repeat(100_000)
    );
    assert_says(
        &load("scene.json", &deep).unwrap_err(),
        "scene.json:1:",
        "deep",
        "brackets",
    );
}

#[test]
fn springs_join_two_particles_that_exist() {
    let spring = |between: &str| format!("[[spring]]\nbetween = {between}\nstiffness = 1");
    refuses_after(
        &spring("[0, 7]"),
        ":7:11: `spring[0].between`",
        "[0, 7]: there is no particle 7",
        "add the one",
    );
    refuses_after(
        &spring("[2, 0]"),
        "`spring[0].between`",
        "2 particles, numbers 0 to 1",
        "exist",
    );
    refuses_after(
        &spring("[1, 1]"),
        ":7:11: `spring[0].between`",
        "joins particle 1 to itself",
        "two different",
    );
    refuses(
        &spring("[0, 1]"),
        "`spring[0].between`",
        "the scene has no particles",
        "add",
    );
}

#[test]
fn springs_are_not_negative() {
    for value in ["-5", "nan", "inf", "-inf"] {
        for key in ["stiffness", "damping", "rest_length"] {
            let mut keys = vec![("stiffness", "1")];
            keys.retain(|(known, _)| *known != key);
            keys.push((key, value));
            let lines: String = keys
                .iter()
                .map(|(key, value)| format!("{key} = {value}\n"))
                .collect();
            let spring = format!("[[spring]]\nbetween = [0, 1]\n{lines}");
            let shown = format!("{:?}", value.parse::<f64>().unwrap());
            refuses_after(
                &spring,
                &format!("`spring[0].{key}` is"),
                &shown,
                "0 or more",
            );
        }
    }
}

#[test]
fn what_must_be_positive_is() {
    for value in ["0", "-1.5", "nan", "inf"] {
        let shown = format!("{:?}", value.parse::<f64>().unwrap());
        for key in ["duration", "time_step", "frame_rate", "tolerance"] {
            refuses(
                &format!("{key} = {value}"),
                &format!("scene.toml:1:{}: `{key}`", key.len() + 4),
                &shown,
                "more than 0",
            );
        }
        let mass = format!("[[particle]]\nposition = [0, 0, 0]\nmass = {value}");
        refuses(
            &mass,
            "scene.toml:3:8: `particle[0].mass`",
            &shown,
            "kg more than 0",
        );
    }
}

#[test]
fn planes_have_a_direction_and_a_bounce() {
    let plane = |normal: &str, restitution: &str| {
        format!("[[plane]]\npoint = [0, 0, 0]\nnormal = {normal}\nrestitution = {restitution}")
    };
    load("scene.toml", &plane("[0, 0, 1e-200]", "0")).unwrap();
    refuses(
        &plane("[0, 0, 0]", "1"),
        ":3:10: `plane[0].normal`",
        "[0.0, 0.0, 0.0]",
        "direction such as",
    );
    refuses(
        &plane("[0, nan, 0]", "1"),
        "`plane[0].normal`",
        "NaN",
        "three finite numbers",
    );
    for value in ["-0.1", "1.1", "nan"] {
        refuses(
            &plane("[0, 0, 1]", value),
            ":4:15: `plane[0].restitution`",
            &format!("{:?}", value.parse::<f64>().unwrap()),
            "between",
        );
    }
}

#[test]
fn vectors_are_finite() {
    for value in ["[0, 0, nan]", "[inf, 0, 0]", "[0, 1e200, 0]"] {
        refuses(
            &format!("gravity = {value}"),
            "scene.toml:1:11: `gravity`",
            "",
            "three finite numbers",
        );
        refuses(
            &format!("[[particle]]\nposition = {value}"),
            ":2:12: `particle[0].position`",
            "",
            "three finite",
        );
        let velocity = format!("[[particle]]\nposition = [0, 0, 0]\nvelocity = {value}");
        refuses(
            &velocity,
            "`particle[0].velocity`",
            "",
            "three finite numbers of m/s",
        );
        refuses(
            &format!("[[plane]]\nnormal = [0, 0, 1]\npoint = {value}"),
            "`plane[0].point`",
            "",
            "three finite",
        );
        refuses(
            &format!("[camera]\ntarget = {value}"),
            "`camera.target`",
            "",
            "three finite",
        );
    }
}

#[test]
fn cameras_can_see() {
    refuses(
        "[camera]\nfield_of_view = 180",
        ":2:17: `camera.field_of_view`",
        "180.0",
        "such as 40.0",
    );
    refuses(
        "[camera]\nfield_of_view = 0",
        "`camera.field_of_view`",
        "0.0",
        "such as 40.0",
    );
    refuses(
        "[camera]\nsize = [8, 100]",
        "`camera.size`",
        "[8, 100]",
        "[960, 720]",
    );
    refuses(
        "[camera]\nsize = [100, 8193]",
        "`camera.size`",
        "[100, 8193]",
        "[960, 720]",
    );
    refuses(
        "[camera]\nup = [0, 0, 0]",
        "`camera.up`",
        "[0.0, 0.0, 0.0]",
        "direction",
    );
    refuses(
        "[camera]\nposition = [1, 2, 3]\ntarget = [1, 2, 3]",
        "`camera.target`",
        "[1.0, 2.0, 3.0]",
        "move",
    );
    load(
        "scene.toml",
        "[camera]\nfield_of_view = 179.9\nsize = [16, 8191]\nposition = [1, 0, 0]",
    )
    .unwrap();
}

#[test]
fn keyframes_are_in_order_and_alone() {
    let particle = |lines: &str| format!("[[particle]]\n{lines}\n");
    refuses(
        &particle("keyframes = []"),
        "`particle[0].keyframes`",
        "[]",
        "rows of t, x, y, z",
    );
    refuses(
        &particle("keyframes = [[0, 0, 0, 0],\n[1, 0, 0, 0],\n[1, 0, 0, 1]]"),
        "scene.toml:4:1: `particle[0].keyframes[2]`",
        "[1.0, 0.0, 0.0, 1.0]",
        "in order of time",
    );
    refuses(
        &particle("keyframes = [[0, 0, nan, 0]]"),
        "`particle[0].keyframes[0]`",
        "NaN",
        "four finite",
    );
    refuses(
        &particle("keyframes = [[nan, 0, 0, 0]]"),
        "`particle[0].keyframes[0]`",
        "NaN",
        "four finite",
    );
    refuses(
        &particle("keyframes = [[0, 0, 0]]"),
        "`particle[0].keyframes[0]`",
        "a list of 3",
        "a list of 4 numbers",
    );
    refuses(
        &particle("pinned = true\nkeyframes = [[0, 0, 0, 0]]"),
        ":2:10: `particle[0].pinned`",
        "true",
        "either",
    );
    refuses(
        &particle("position = [0, 0, 1]\nkeyframes = [[0, 0, 0, 0]]"),
        ":2:12: `particle[0].position`",
        "[0.0, 0.0, 1.0]: the keyframes have it at [0.0, 0.0, 0.0]",
        "leave the position out",
    );
    let held = "position = [0, 0, 0]\nvelocity = [1, 0, 0]\n";
    refuses(
        &particle(&format!("{held}pinned = true")),
        "`particle[0].velocity`",
        "[1.0, 0.0, 0.0]",
        "let the particle go",
    );
    refuses(
        &particle(&format!("{held}keyframes = [[0, 0, 0, 0]]")),
        "`particle[0].velocity`",
        "[1.0",
        "velocity away",
    );
}

#[test]
fn generators_need_two_particles_a_side() {
    let rope = |n: &str| {
        format!("[[rope]]\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nparticles = {n}\nstiffness = 1")
    };
    refuses(
        &rope("1"),
        ":4:13: `rope[0].particles`",
        "is 1",
        "2 or more",
    );
    refuses(
        &rope("-3"),
        ":4:13: `rope[0].particles`",
        "-3",
        "a whole number",
    );
    refuses(
        &rope("2.5"),
        ":4:13: `rope[0].particles`",
        "2.5",
        "a whole number",
    );
    let cloth = |n: &str| {
        format!(
            "[[cloth]]\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\nparticles = {n}"
        )
    };
    refuses(
        &cloth("[1, 5]"),
        ":5:13: `cloth[0].particles`",
        "[1, 5]",
        "2 whole numbers, each 2 or more",
    );
    refuses(
        &cloth("[5, 0]"),
        "`cloth[0].particles`",
        "[5, 0]",
        "2 or more",
    );
    let block = |n: &str| {
        format!("[[block]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = {n}\nstiffness = 1")
    };
    refuses(
        &block("[2, 2, 1]"),
        ":4:13: `block[0].particles`",
        "[2, 2, 1]",
        "3 whole numbers, each 2 or more",
    );
    let cloud =
        |n: &str| format!("[[cloud]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = {n}");
    refuses(
        &cloud("0"),
        ":4:13: `cloud[0].particles`",
        "is 0",
        "1 or more",
    );
    for sound in [rope("2"), cloth("[2, 2]"), block("[2, 2, 2]"), cloud("1")] {
        load("scene.toml", &sound).unwrap();
    }
}

#[test]
fn generators_keep_the_rules_of_what_they_make() {
    let tables = [
        (
            "rope",
            "from = [0, 0, 0]\nto = [1, 0, 0]\nparticles = 2\nstiffness = 1",
        ),
        (
            "cloth",
            "corner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\nparticles = [2, 2]",
        ),
        (
            "block",
            "corner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = [2, 2, 2]\nstiffness = 1",
        ),
        (
            "cloud",
            "corner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = 2",
        ),
    ];
    for (key, lines) in tables {
        let with = |line: &str| format!("[[{key}]]\n{lines}\n{line}");
        load("scene.toml", &with("mass = 2\nvelocity = [1, 2, 3]")).unwrap();
        refuses(
            &with("mass = 0"),
            &format!("`{key}[0].mass`"),
            "0.0",
            "more than 0",
        );
        refuses(
            &with("velocity = [nan, 0, 0]"),
            &format!("`{key}[0].velocity`"),
            "NaN",
            "three finite",
        );
        refuses(
            &with("sped = 1"),
            &format!("`{key}[0]`"),
            "`sped`",
            "The keys here are",
        );
        let broken = with("").replace("[0, 0, 0]", "[0, inf, 0]");
        refuses(&broken, &format!("`{key}[0]."), "inf", "three finite");
    }
    for (key, lines) in [tables[0], tables[2]] {
        refuses(
            &format!("[[{key}]]\n{lines}\ndamping = -1"),
            &format!("`{key}[0].damping`"),
            "-1.0",
            "0 or more",
        );
        let negative = lines.replace("stiffness = 1", "stiffness = -1");
        refuses(
            &format!("[[{key}]]\n{negative}"),
            &format!("`{key}[0].stiffness`"),
            "-1.0",
            "0 or more",
        );
    }
    for family in ["structural", "shear", "bend"] {
        let cloth = format!(
            "[[cloth]]\n{}\n{family} = {{ stiffness = 1, damping = nan }}",
            tables[1].1
        );
        refuses(
            &cloth,
            &format!(
                "scene.toml:6:{}: `cloth[0].{family}.damping`",
                family.len() + 31
            ),
            "NaN",
            "0 or more",
        );
    }
}

#[test]
fn pins_are_in_the_grid() {
    let rope = "[[rope]]\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nparticles = 4\nstiffness = 1\n";
    refuses(
        &format!("{rope}pinned = [\"frist\"]"),
        ":6:11: `rope[0].pinned[0]`",
        "\"frist\"",
        "Did you mean `first`?",
    );
    refuses(
        &format!("{rope}pinned = \"first\""),
        "`rope[0].pinned`",
        "\"first\"",
        "write a list",
    );
    let cloth = "[[cloth]]\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\nparticles = [4, 5]\n";
    refuses(
        &format!("{cloth}pinned = [\"u0\", \"u2v0\"]"),
        ":6:17: `cloth[0].pinned[1]`",
        "\"u2v0\"",
        "\"u0v0\"",
    );
    refuses(
        &format!("{cloth}pinned = [[0, 5]]"),
        ":6:11: `cloth[0].pinned[0]`",
        "[0, 5]: the places go from [0, 0] to [3, 4]",
        "exists",
    );
    refuses(
        &format!("{cloth}pinned = [[0, 1, 2]]"),
        "`cloth[0].pinned[0]`",
        "a list of 3",
        "2 whole numbers",
    );
    refuses(
        &format!("{cloth}pinned = [[0]]"),
        "`cloth[0].pinned[0]`",
        "a list of 1",
        "2 numbers",
    );
    refuses(
        &format!("{cloth}pinned = [true]"),
        "`cloth[0].pinned[0]`",
        "`true`",
        "a name in double quotes or a list",
    );
    let block =
        "[[block]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = [2, 3, 4]\nstiffness = 1\n";
    refuses(
        &format!("{block}pinned = [\"w0\"]"),
        "`block[0].pinned[0]`",
        "\"w0\"",
        "\"x0\", \"x1\"",
    );
    refuses(
        &format!("{block}pinned = [[1, 2, 4]]"),
        "`block[0].pinned[0]`",
        "[1, 2, 4]",
        "exists",
    );
    load(
        "scene.toml",
        &format!("{block}pinned = [[1, 2, 3], \"z1\"]"),
    )
    .unwrap();
}

#[test]
fn scenes_larger_than_memory_are_refused_before_they_are_made() {
    let cloud = "[[cloud]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = 4_000_000_000\n";
    let error = load("scene.toml", cloud).unwrap().model().unwrap_err();
    assert_says(&error, "scene.toml", "4000000000 particles", "fewer");
    assert!(error.to_string().contains("640 GB"), "{error}");

    let too_many = load("scene.toml", &format!("{cloud}{cloud}")).unwrap();
    assert_says(
        &too_many.model().unwrap_err(),
        "scene.toml",
        "8000000000 particles, and at most 4294967295",
        "fewer",
    );

    let block = "[[block]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = [4_000_000_000, 4_000_000_000, 4_000_000_000]\nstiffness = 1";
    let error = load("scene.toml", block).unwrap().model().unwrap_err();
    assert_says(
        &error,
        "scene.toml",
        "64000000000000000000000000000 particles",
        "fewer",
    );

    // 3e8 particles can be numbered, the springs between them cannot.
    let springs = block.replace(
        "[4_000_000_000, 4_000_000_000, 4_000_000_000]",
        "[1000, 1000, 400]",
    );
    let error = load("scene.toml", &springs).unwrap().model().unwrap_err();
    assert_says(
        &error,
        "scene.toml",
        "springs, and at most 4294967295",
        "fewer",
    );

    let small = load("scene.toml", SOUND).unwrap();
    assert_eq!(small.model_within(320).unwrap().particles.len(), 2);
    let error = small.model_within(319).unwrap_err();
    assert_says(
        &error,
        "scene.toml",
        "need 320 bytes of memory, and 319 bytes are available",
        "memory",
    );
}
