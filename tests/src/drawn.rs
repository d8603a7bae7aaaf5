//! Scenes drawn at random that are large enough to show what a method costs: ropes, cloths, blocks and single springs,
//! damped or not, over a plane or none.

use std::fmt::Write;

use hooke_runner::model::Model;
use hooke_runner::scene::{Scene, Settings};

use crate::random::Random;

/// The scene of a number: its name, its parts and how it is run.
///
/// # Panics
/// If it cannot be written to a file for a moment.
#[must_use]
pub fn drawn(number: u64) -> (String, Model, Settings) {
    let mut random = Random::new(0x5ca1e + number);
    let mut text = "gravity = [0.0, 0.0, -9.81]\n".to_owned();
    let damping = if random.below(2) == 0 { 0.0 } else { random.scale(0.01, 0.3) };
    let stiffness = random.scale(50.0, 2000.0);
    let mut line = |key: &str, value: String| writeln!(text, "{key} = {value}").expect("there is room");
    line("duration", format!("{:?}", random.between(0.5, 1.5)));
    let name = match number % 4 {
        0 => {
            let particles = 8 + random.below(40);
            line("[[rope]]\nfrom", "[0.0, 0.0, 1.0]".into());
            line("to", format!("[{:?}, 0.0, {:?}]", random.between(0.4, 1.0), random.between(0.5, 1.5)));
            line("particles", particles.to_string());
            line("pinned", "[\"first\"]".into());
            format!("a rope of {particles}")
        }
        1 => {
            let side = 5 + random.below(8);
            line("[[cloth]]\ncorner", "[0.0, 0.0, 1.0]".into());
            line("edge_u", format!("[{:?}, 0.0, 0.0]", random.between(0.5, 1.0)));
            line("edge_v", format!("[0.0, {:?}, {:?}]", random.between(0.5, 1.0), random.between(-0.3, 0.3)));
            line("particles", format!("[{side}, {side}]"));
            for law in ["structural", "shear"] {
                line(law, format!("{{ stiffness = {stiffness:?}, damping = {damping:?} }}"));
            }
            line("pinned", "[\"u0v0\", \"u1v0\"]".into());
            format!("a cloth of {side} x {side}")
        }
        2 => {
            let side = 3 + random.below(3);
            line("[[block]]\ncorner", "[0.0, 0.0, 0.1]".into());
            line("size", format!("[0.3, 0.3, {:?}]", random.between(0.2, 0.5)));
            line("particles", format!("[{side}, {side}, {side}]"));
            format!("a block of {side} x {side} x {side} over a plane")
        }
        _ => {
            line("[[particle]]\nposition", "[0.0, 0.0, 1.0]".into());
            line("pinned", "true".into());
            line(
                "[[particle]]\nposition",
                format!("[{:?}, 0.1, {:?}]", random.between(0.2, 0.8), random.between(0.2, 0.9)),
            );
            line("velocity", format!("[0.0, {:?}, 0.0]", random.between(-2.0, 2.0)));
            line("[[spring]]\nbetween", "[0, 1]".into());
            "a pendulum on a spring".into()
        }
    };
    if number % 4 != 1 {
        line("stiffness", format!("{stiffness:?}"));
        line("damping", format!("{damping:?}"));
    }
    match number % 4 {
        3 => line("rest_length", "0.7".into()),
        _ => line("mass", format!("{:?}", random.scale(0.002, 0.02))),
    }
    if number % 4 == 2 {
        line("[[plane]]\npoint", "[0.0, 0.0, 0.0]".into());
        line("normal", format!("[{:?}, 0.0, 1.0]", random.between(-0.3, 0.3)));
        line("restitution", format!("{:?}", random.between(0.2, 0.9)));
    }
    let folder = tempfile::tempdir().expect("a folder for a moment");
    let path = folder.path().join("drawn.toml");
    std::fs::write(&path, &text).expect("there is room");
    let scene = Scene::load(&path).expect("a sound scene");
    let model = scene.model().expect("a scene that fits");
    (format!("{number}, {name}"), model, scene.settings().clone())
}
