//! Scenes as source for firmware. That the source compiles, and is stepped to the desktop's digests on a Cortex-M, is checked
//! in `examples/firmware`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod cli_support;

use std::fs;

use cli_support::{Folder, ROPE};

/// Numbers that are no short fractions in binary, and one below 0.
const BALL: &str = r#"
gravity = [0.0, -0.0, -9.81]
duration = 0.105
time_step = 1e-2
collision = "project"
stepper = "rk4"
[[particle]]
position = [0.1, 1e-7, 123456.789]
velocity = [-0.3333333333333333, 0.0, 0.0]
mass = 0.7
[[particle]]
position = [0.2, 0.0, 123457.0]
pinned = true
[[spring]]
between = [1, 0]
stiffness = 1e9
[[plane]]
point = [0.0, 0.0, 123456.0]
normal = [0.0, 0.0, 1.0]
restitution = 0.9
"#;

/// The numbers of the first row of a table.
fn first_row(source: &str, table: &str) -> Vec<f64> {
    let rows = source.split_once(&format!("pub static {table}: ")).unwrap().1;
    let row = rows.lines().nth(1).unwrap();
    let numbers = row.split(|letter: char| !(letter.is_ascii_digit() || ".-e".contains(letter)));
    numbers.filter_map(|number| number.parse().ok()).collect()
}

#[test]
fn numbers_read_back_to_the_same_bits() {
    let folder = Folder::with(BALL);
    let source = folder.hooke(&["export", "scene.toml", "--firmware", "--out", "-"]).exits(0).output();
    // Far from the origin, it is stepped relative to the metre in its middle.
    assert!(source.contains("ORIGIN: [f64; 3] = [0.0, 0.0, 123457.0]"), "{source}");
    let expected = [0.1_f64, 1e-7, 123_456.789 - 123_457.0, -1.0 / 3.0, 0.0, 0.0, 0.7];
    let bits = |numbers: &[f64]| numbers.iter().map(|number| (*number as f32).to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&first_row(&source, "PARTICLE")), bits(&expected), "{source}");
    // Shortest: no digit more than it takes in the scene's precision.
    assert!(source.contains("-0.33333334") && source.contains("[0.0, -0.0, -9.81]"), "{source}");
    let source = folder.hooke(&["export", "scene.toml", "--firmware", "--out", "-", "--precision", "f64"]).output();
    let double = first_row(&source, "PARTICLE");
    let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&double), bits(&expected), "{source}");
    assert_ne!(bits(&double), bits(&expected.map(|number| f64::from(number as f32))), "single precision would do");
}

#[test]
fn it_says_how_the_scene_is_stepped() {
    let folder = Folder::with(BALL);
    let source = folder.hooke(&["export", "scene.toml", "--firmware", "--out", "-"]).exits(0).output();
    for part in [
        "PARTICLES: usize = 2;",
        "SPRINGS: usize = 1;",
        "PLANES: usize = 1;",
        "hooke::Rk4<f32, Capacity>",
        "hooke::Project",
        "STEPS: u32 = 11;",
        // The last step is half as long.
        "if step < STEPS { 0.01 } else { 0.005 }",
        "([1, 0], 1000000000.0, 0.0, ",
        "0.0), 1.0, true)",
    ] {
        assert!(source.contains(part) || source.contains(&part.replace("0.0), ", "0.0], ")), "{part}\n{source}");
    }
    let source = Folder::with(ROPE).hooke(&["export", "scene.toml", "--firmware", "--out", "-"]).exits(0).output();
    assert!(source.contains("hooke::Auto<f32, Capacity, 0>"), "{source}");
    let implicit = ["export", "scene.toml", "--firmware", "--out", "-", "--stepper", "implicit-euler"];
    // A chain's factor has as many blocks as springs.
    assert!(Folder::with(ROPE).hooke(&implicit).output().contains("hooke::ImplicitEuler<f32, Capacity, 1>"));
}

#[test]
fn it_goes_where_it_is_told() {
    let folder = Folder::with(ROPE);
    folder
        .hooke(&["export", "scene.toml", "--firmware", "--out", "rope.rs"])
        .exits(0)
        .prints_nothing()
        .tells(&["rope.rs"]);
    let printed = folder.hooke(&["export", "scene.toml", "--firmware", "--out", "-"]).exits(0).output();
    assert_eq!(fs::read_to_string(folder.file("rope.rs")).unwrap(), printed);
    folder.hooke(&["export", "scene.toml", "--firmware", "--out", "rope.c"]).exits(2).tells(&["rope.rs"]);
    folder.hooke(&["export", "scene.toml", "--firmware", "--out", "none/rope.rs"]).exits(2).tells(&["mkdir -p none"]);
    folder.hooke(&["export", "scene.toml", "--firmware"]).exits(2);
    folder.hooke(&["export", "scene.toml", "--out", "-"]).exits(2).tells(&["--firmware"]);
    assert_eq!(folder.made(), ["rope.rs"]);
}

#[test]
fn what_it_cannot_hold_is_refused() {
    let export = |scene: &str, flags: &[&str]| {
        let folder = Folder::with(scene);
        let answer = folder.hooke(&[&["export", "scene.toml", "--firmware", "--out", "a.rs"], flags].concat());
        assert!(folder.made().is_empty() || flags.is_empty() && scene == ROPE);
        answer
    };
    export(ROPE, &[]).exits(0);
    let keyframes = "[[particle]]\nposition = [0.0, 0.0, 0.0]\n[[particle]]\nkeyframes = [[0.0, 0.0, 0.0, 2.0], [1.0, 0.3, 0.0, 2.0]]\n";
    export(keyframes, &[]).exits(2).tells(&["particle 1", "keyframes", "World::drive"]);
    export(ROPE, &["--stepper", "dop853", "--time-step", "auto"]).exits(2).tells(&["time_step", "--time-step 1e-3"]);
    export(ROPE, &["--precision", "f32-compensated"]).exits(2).tells(&["precision", "--precision f32"]);
    let accurate = ROPE.replace("time_step = 1e-3", "max_error = 1e-4");
    export(&accurate, &[]).exits(2).tells(&["max_error", "leave it out"]);
}

/// The time step that a scene leaves open, which `hooke run` would look for by pilot runs.
#[test]
fn it_says_what_ends_in_the_same_bits() {
    let open = ROPE.replace("time_step = 1e-3\n", "").replace("stepper = \"auto\"\n", "");
    let folder = Folder::with(&open);
    let exported = folder.hooke(&["export", "scene.toml", "--firmware", "--out", "rope.rs"]).exits(0);
    let told = exported.error();
    let flags = told.split_once("ends in the same bits with ").expect(&told).1;
    let flags: Vec<&str> = flags.split(';').next().unwrap().split_whitespace().collect();
    assert_eq!([flags[0], flags[1], flags[2]], ["--stepper", "auto", "--time-step"], "{told}");
    assert!(told.contains("pilot runs"), "{told}");
    // With these flags nothing is left open: the source is the same, to the length and the number of its steps.
    let source = |flags: &[&str]| {
        folder.hooke(&[&["export", "scene.toml", "--firmware", "--out", "-"], flags].concat()).exits(0).output()
    };
    assert_eq!(source(&flags), source(&[]));
    assert!(source(&flags).contains(&format!("step < STEPS {{ {} }} else", flags[3])), "{told}");
    // Without them, what pilot runs find is something else.
    let digest = |flags: &[&str]| folder.hooke(&[&["run", "scene.toml", "--digest"], flags].concat()).exits(0).output();
    assert_ne!(digest(&flags), digest(&[]));
    // Of a scene that says its time step, nothing has to be repeated.
    let given = Folder::with(ROPE).hooke(&["export", "scene.toml", "--firmware", "--out", "-"]).exits(0).error();
    assert!(given.contains("`hooke run` ends in the same bits\n"), "{given}");
}
