//! Values that no scene can hold are refused with the place, the value and the remedy.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod scene_support;

use scene_support::{load, refuses, refuses_after};

#[test]
fn springs_join_two_particles_that_exist() {
    let spring = |between: &str| format!("[[spring]]\nbetween = {between}\nstiffness = 1");
    refuses_after(&spring("[0, 7]"), ":7:11: `spring[0].between`", "[0, 7]: there is no particle 7", "add the one");
    refuses_after(&spring("[2, 0]"), "`spring[0].between`", "2 particles, numbers 0 to 1", "exist");
    refuses_after(&spring("[1, 1]"), ":7:11: `spring[0].between`", "joins particle 1 to itself", "two different");
    refuses(&spring("[0, 1]"), "`spring[0].between`", "the scene has no particles", "add");
}

#[test]
fn springs_are_not_negative() {
    for value in ["-5", "nan", "inf", "-inf"] {
        for key in ["stiffness", "damping", "rest_length"] {
            let mut keys = vec![("stiffness", "1")];
            keys.retain(|(known, _)| *known != key);
            keys.push((key, value));
            let lines: String = keys.iter().map(|(key, value)| format!("{key} = {value}\n")).collect();
            let spring = format!("[[spring]]\nbetween = [0, 1]\n{lines}");
            let shown = format!("{:?}", value.parse::<f64>().unwrap());
            refuses_after(&spring, &format!("`spring[0].{key}` is"), &shown, "0 or more");
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
        refuses(&mass, "scene.toml:3:8: `particle[0].mass`", &shown, "kg more than 0");
    }
}

#[test]
fn planes_have_a_direction_and_a_bounce() {
    let plane = |normal: &str, restitution: &str| {
        format!("[[plane]]\npoint = [0, 0, 0]\nnormal = {normal}\nrestitution = {restitution}")
    };
    load("scene.toml", &plane("[0, 0, 1e-200]", "0")).unwrap();
    refuses(&plane("[0, 0, 0]", "1"), ":3:10: `plane[0].normal`", "[0.0, 0.0, 0.0]", "direction such as");
    refuses(&plane("[0, nan, 0]", "1"), "`plane[0].normal`", "NaN", "three finite numbers");
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
        refuses(&format!("gravity = {value}"), "scene.toml:1:11: `gravity`", "", "three finite numbers");
        refuses(&format!("[[particle]]\nposition = {value}"), ":2:12: `particle[0].position`", "", "three finite");
        let velocity = format!("[[particle]]\nposition = [0, 0, 0]\nvelocity = {value}");
        refuses(&velocity, "`particle[0].velocity`", "", "three finite numbers of m/s");
        refuses(&format!("[[plane]]\nnormal = [0, 0, 1]\npoint = {value}"), "`plane[0].point`", "", "three finite");
        refuses(&format!("[camera]\ntarget = {value}"), "`camera.target`", "", "three finite");
    }
}

#[test]
fn cameras_can_see() {
    refuses("[camera]\nfield_of_view = 180", ":2:17: `camera.field_of_view`", "180.0", "such as 40.0");
    refuses("[camera]\nfield_of_view = 0", "`camera.field_of_view`", "0.0", "such as 40.0");
    refuses("[camera]\nsize = [8, 100]", "`camera.size`", "[8, 100]", "[960, 720]");
    refuses("[camera]\nsize = [100, 8193]", "`camera.size`", "[100, 8193]", "[960, 720]");
    refuses("[camera]\nup = [0, 0, 0]", "`camera.up`", "[0.0, 0.0, 0.0]", "direction");
    refuses("[camera]\nposition = [1, 2, 3]\ntarget = [1, 2, 3]", "`camera.target`", "[1.0, 2.0, 3.0]", "move");
    load("scene.toml", "[camera]\nfield_of_view = 179.9\nsize = [16, 8191]\nposition = [1, 0, 0]").unwrap();
}

#[test]
fn keyframes_are_in_order_and_alone() {
    let particle = |lines: &str| format!("[[particle]]\n{lines}\n");
    refuses(&particle("keyframes = []"), "`particle[0].keyframes`", "[]", "rows of t, x, y, z");
    refuses(
        &particle("keyframes = [[0, 0, 0, 0],\n[1, 0, 0, 0],\n[1, 0, 0, 1]]"),
        "scene.toml:4:1: `particle[0].keyframes[2]`",
        "[1.0, 0.0, 0.0, 1.0]",
        "in order of time",
    );
    refuses(&particle("keyframes = [[0, 0, nan, 0]]"), "`particle[0].keyframes[0]`", "NaN", "four finite");
    refuses(&particle("keyframes = [[nan, 0, 0, 0]]"), "`particle[0].keyframes[0]`", "NaN", "four finite");
    refuses(&particle("keyframes = [[0, 0, 0]]"), "`particle[0].keyframes[0]`", "a list of 3", "a list of 4 numbers");
    refuses(&particle("pinned = true\nkeyframes = [[0, 0, 0, 0]]"), ":2:10: `particle[0].pinned`", "true", "either");
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
    refuses(&particle(&format!("{held}keyframes = [[0, 0, 0, 0]]")), "`particle[0].velocity`", "[1.0", "velocity away");
}
