//! How scenes are run: settings, the flags that replace them, the schema, and the scenes to start from.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod scene_support;

use clap::{Parser, ValueEnum};
use hooke_runner::model::Hold;
use hooke_runner::scene::{CollisionForm, Overrides, Precision, Scene, Starter, StepperName, TimeStep, schema};
use scene_support::{Folder, assert_says, load};

/// The whole format, as its description shows it.
const EVERYTHING: &str = include_str!("scene_support/everything.toml");

/// A closed mesh of 12 vertices, 30 edges and 20 triangles.
const ICOSAHEDRON: &str = "\
v -1 1.618 0\nv 1 1.618 0\nv -1 -1.618 0\nv 1 -1.618 0\nv 0 -1 1.618\nv 0 1 1.618
v 0 -1 -1.618\nv 0 1 -1.618\nv 1.618 0 -1\nv 1.618 0 1\nv -1.618 0 -1\nv -1.618 0 1
f 1 12 6\nf 1 6 2\nf 1 2 8\nf 1 8 11\nf 1 11 12\nf 2 6 10\nf 6 12 5\nf 12 11 3\nf 11 8 7\nf 8 2 9
f 4 10 5\nf 4 5 3\nf 4 3 7\nf 4 7 9\nf 4 9 10\nf 5 10 6\nf 3 5 12\nf 7 3 11\nf 9 7 8\nf 10 9 2\n";

#[derive(Parser)]
struct Command {
    #[command(flatten)]
    overrides: Overrides,
}

fn overrides(flags: &[&str]) -> Result<Overrides, clap::Error> {
    Command::try_parse_from([&["hooke"], flags].concat()).map(|command| command.overrides)
}

#[test]
fn the_format_loads_whole() {
    let folder = Folder::new();
    folder.write("icosphere.obj", ICOSAHEDRON);
    let scene = Scene::load(&folder.write("everything.toml", EVERYTHING)).unwrap();
    let settings = scene.settings();
    assert_eq!(settings.name, "ball on a spring over a floor");
    assert_eq!(settings.gravity, [0.0, 0.0, -9.81]);
    assert_eq!((settings.duration, settings.time_step, settings.frame_rate), (2.0, TimeStep::Seconds(1e-3), 60.0));
    assert_eq!((settings.stepper, settings.precision), (StepperName::Auto, Precision::F32));
    assert_eq!((settings.tolerance, settings.collision), (1e-6, CollisionForm::TimeOfImpact));
    assert_eq!(settings.camera.size, Some([960, 720]));
    let model = scene.model().unwrap();
    assert_eq!(model.particles.len(), 2 + 100 + 32 * 32 + 512 + 1000 + 12);
    let block = 3 * 7 * 64 + 6 * 49 * 8 + 4 * 343;
    assert_eq!(model.springs.len(), 1 + 99 + 5_826 + block + 30 + 30);
    assert_eq!(model.planes.len(), 1);
    assert_eq!(model.particles.iter().filter(|particle| particle.hold == Hold::Pinned).count(), 1 + 1 + 2 + 64);
}

#[test]
fn what_is_left_out_has_a_default() {
    let scene = load("swinging thing.toml", "duration = 1").unwrap();
    let settings = scene.settings();
    assert_eq!(settings.name, "swinging thing");
    assert_eq!(settings.gravity, [0.0; 3]);
    assert_eq!((settings.duration, settings.time_step, settings.frame_rate), (1.0, TimeStep::Auto, 60.0));
    assert_eq!((settings.stepper, settings.precision), (StepperName::Auto, Precision::F32));
    assert_eq!((settings.tolerance, settings.collision), (1e-6, CollisionForm::TimeOfImpact));
    assert_eq!(settings.camera, hooke_runner::model::CameraChoice::default());
    assert_eq!(load("scene.toml", "name = \"x\"").unwrap().settings().duration, 1.0);
}

#[test]
fn flags_replace_keys_and_leave_the_rest() {
    let mut scene = load("scene.toml", "duration = 3\ntolerance = 1e-3\nprecision = \"f64\"").unwrap();
    let before = scene.settings().clone();
    scene.apply(&overrides(&[]).unwrap()).unwrap();
    assert_eq!(*scene.settings(), before);
    let flags = ["--time-step", "1e-4", "--stepper", "velocity-verlet", "--gravity", "-1,0,-9.81", "--duration=5"];
    scene.apply(&overrides(&flags).unwrap()).unwrap();
    let settings = scene.settings();
    assert_eq!(settings.time_step, TimeStep::Seconds(1e-4));
    assert_eq!(settings.stepper, StepperName::VelocityVerlet);
    assert_eq!(settings.gravity, [-1.0, 0.0, -9.81]);
    assert_eq!((settings.duration, settings.tolerance, settings.precision), (5.0, 1e-3, Precision::F64));
    let flags = ["--time-step", "auto", "--precision=f32", "--tolerance=1", "--collision=reflect", "--frame-rate=24"];
    scene.apply(&overrides(&flags).unwrap()).unwrap();
    let settings = scene.settings();
    assert_eq!((settings.time_step, settings.precision), (TimeStep::Auto, Precision::F32));
    assert_eq!((settings.tolerance, settings.frame_rate), (1.0, 24.0));
    assert_eq!(settings.collision, CollisionForm::Reflect);
}

#[test]
fn wrong_flags_are_named_and_change_nothing() {
    let mut scene = load("scene.toml", "duration = 3").unwrap();
    for (flags, place, value, remedy) in [
        (["--time-step", "-1"], "`--time-step`", "-1.0", "more than 0"),
        (["--duration", "0"], "`--duration`", "0.0", "more than 0"),
        (["--frame-rate", "nan"], "`--frame-rate`", "NaN", "more than 0"),
        (["--tolerance", "inf"], "`--tolerance`", "inf", "more than 0"),
        (["--gravity", "0,0,inf"], "`--gravity`", "inf", "three finite numbers"),
    ] {
        let before = scene.settings().clone();
        let error = scene.apply(&overrides(&flags).unwrap()).unwrap_err();
        assert_says(&error, place, value, remedy);
        assert_eq!(*scene.settings(), before);
    }
    for (flags, value) in [
        (["--time-step", "fast"], "expected a number of seconds or auto, found \"fast\""),
        (["--gravity", "0,1"], "expected three numbers with commas between"),
        (["--gravity", "0,1,x"], "expected a number, found \"x\""),
        (["--stepper", "semi-implicit-eular"], "semi-implicit-euler"),
    ] {
        let error = overrides(&flags).unwrap_err().to_string();
        assert!(error.contains(value) && error.contains(flags[0]), "{error}");
    }
}

#[test]
fn names_read_back_as_they_are_written() {
    assert_eq!(StepperName::ALL.len(), 12);
    for &stepper in StepperName::ALL {
        assert_eq!(stepper.to_string().parse(), Ok(stepper));
        assert_eq!(stepper.to_possible_value().unwrap().get_name(), stepper.name());
        let scene = load("scene.toml", &format!("stepper = \"{stepper}\"")).unwrap();
        assert_eq!(scene.settings().stepper, stepper);
    }
    for &form in CollisionForm::ALL {
        let scene = load("scene.toml", &format!("collision = \"{form}\"")).unwrap();
        assert_eq!(scene.settings().collision, form);
    }
    for &precision in Precision::ALL {
        let scene = load("scene.toml", &format!("precision = \"{precision}\"")).unwrap();
        assert_eq!(scene.settings().precision, precision);
    }
    let error = "euler".parse::<StepperName>().unwrap_err();
    assert!(error.contains("\"euler\"") && error.contains("explicit-euler, semi-implicit-euler"), "{error}");
    assert_eq!("0.5".parse(), Ok(TimeStep::Seconds(0.5)));
    assert_eq!(TimeStep::Seconds(0.5).to_string().parse(), Ok(TimeStep::Seconds(0.5)));
    assert_eq!(TimeStep::Auto.to_string().parse(), Ok(TimeStep::Auto));
}

#[test]
fn starters_load_and_move() {
    for &starter in Starter::ALL {
        let text = starter.text();
        let scene = load("starter.toml", text).unwrap_or_else(|error| panic!("{starter}: {error}"));
        let model = scene.model().unwrap();
        assert_eq!(scene.settings().name, starter.name());
        assert_ne!(scene.settings().gravity, [0.0; 3]);
        assert!(model.particles.iter().any(|particle| particle.hold == Hold::Free), "{starter}");
        assert!(text.lines().count() <= 40 && text.lines().all(|line| line.chars().count() <= 120), "{starter}");
    }
}

/// Every key of every table in `value`, with the path of tables to it.
fn keys(value: &toml::Value, path: &str, out: &mut Vec<(String, String)>) {
    match value {
        toml::Value::Table(table) => {
            for (key, value) in table {
                out.push((path.to_owned(), key.clone()));
                keys(value, &format!("{path}/{key}"), out);
            }
        }
        toml::Value::Array(items) => items.iter().for_each(|item| keys(item, path, out)),
        _ => {}
    }
}

/// The schema of what stands at `path`, through references, lists and choices.
fn properties<'a>(schema: &'a serde_json::Value, root: &'a serde_json::Value) -> Vec<&'a serde_json::Value> {
    let mut found = Vec::new();
    if let Some(properties) = schema.get("properties") {
        found.push(properties);
    }
    if let Some(reference) = schema.get("$ref").and_then(|reference| reference.as_str()) {
        let target = root.pointer(reference.trim_start_matches('#')).unwrap();
        found.extend(properties(target, root));
    }
    if let Some(items) = schema.get("items") {
        found.extend(properties(items, root));
    }
    for choice in schema.get("anyOf").and_then(|choices| choices.as_array()).into_iter().flatten() {
        found.extend(properties(choice, root));
    }
    found
}

#[test]
fn the_schema_knows_every_key() {
    let root: serde_json::Value = serde_json::from_str(&schema()).unwrap();
    let mut all = Vec::new();
    keys(&EVERYTHING.parse::<toml::Table>().unwrap().into(), "", &mut all);
    assert!(all.len() > 60, "{}", all.len());
    for (path, key) in all {
        let mut schema = &root;
        for step in path.split('/').filter(|step| !step.is_empty()) {
            schema = properties(schema, &root).into_iter().find_map(|properties| properties.get(step)).unwrap();
        }
        let entry = properties(schema, &root).into_iter().find_map(|properties| properties.get(&key));
        assert!(entry.is_some_and(|entry| entry.get("description").is_some()), "{path}/{key} is not described");
    }
    let text = schema();
    assert_eq!(root["additionalProperties"], false);
    assert_eq!(root["properties"]["duration"]["default"], 1.0);
    assert_eq!(root["properties"]["tolerance"]["default"], 1e-6);
    assert!(!text.contains("\"gravitation\""));
    for name in ["semi-implicit-euler", "time-of-impact", "u1v1", "z1", "last"] {
        assert!(text.contains(&format!("{name:?}")), "{name}");
    }
}
