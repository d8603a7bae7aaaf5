//! The scenes of the benchmarks, in any size.

use std::io::Write;

use crate::mesh::irregular;
use hooke_runner::model::Model;
use hooke_runner::scene::Scene;

/// A scene's name, and what makes it.
pub type Named = (&'static str, fn() -> Model);

/// What a step is measured on.
pub const STEP: [Named; 13] = [
    ("cloth-32", || cloth(32, 0.05)),
    ("cloth-64", || cloth(64, 0.05)),
    ("cloth-256", || cloth(256, 0.05)),
    ("cloth-1024", || cloth(1024, 0.05)),
    ("cloth-64-undamped", || cloth(64, 0.0)),
    ("rope-1000", || rope(1000)),
    ("rope-100000", || rope(100_000)),
    ("block-16", || block(16)),
    ("block-64", || block(64)),
    ("mesh-64", || irregular(64)),
    ("mesh-256", || irregular(256)),
    ("ropes-1000x100", || ropes(1000, 100)),
    ("balls-100000", || balls(100_000)),
];

/// m/s², in all of them.
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// A level square metre of `side`² particles with structural, shear and bend springs, damped by `damping` (N·s/m), two
/// corners pinned.
#[must_use]
pub fn cloth(side: u32, damping: f64) -> Model {
    let law = format!("{{ stiffness = 100.0, damping = {damping:?} }}");
    model(&format!(
        "[[cloth]]\ncorner = [0.0, 0.0, 1.0]\nedge_u = [1.0, 0.0, 0.0]\nedge_v = [0.0, 1.0, 0.0]\n\
         particles = [{side}, {side}]\nmass = 0.01\nstructural = {law}\nshear = {law}\nbend = {law}\n\
         pinned = [\"u0v0\", \"u1v0\"]\n"
    ))
}

/// A level rope of so many particles, 1 cm apart, the first one pinned.
#[must_use]
pub fn rope(particles: u32) -> Model {
    ropes(1, particles)
}

/// Ropes side by side.
#[must_use]
pub fn ropes(count: u32, particles: u32) -> Model {
    let length = 0.01 * f64::from(particles - 1);
    let rope = |index: u32| {
        let y = 0.01 * f64::from(index);
        format!(
            "[[rope]]\nfrom = [0.0, {y:?}, 1.0]\nto = [{length:?}, {y:?}, 1.0]\nparticles = {particles}\nmass = 0.01\n\
             stiffness = 1000.0\ndamping = 0.1\npinned = [\"first\"]\n"
        )
    };
    model(&(0..count).map(rope).collect::<String>())
}

/// A cube of `side`³ particles, each joined to its 26 neighbours, above a floor.
#[must_use]
pub fn block(side: u32) -> Model {
    model(&format!(
        "[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\nrestitution = 0.3\n\
         [[block]]\ncorner = [0.0, 0.0, 1.0]\nsize = [1.0, 1.0, 1.0]\nparticles = [{side}, {side}, {side}]\nmass = 0.01\n\
         stiffness = 200.0\ndamping = 0.05\n"
    ))
}

/// Free particles 1 m to 10 m above a floor.
#[must_use]
pub fn balls(count: u32) -> Model {
    model(&format!(
        "[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\nrestitution = 0.8\n\
         [[cloud]]\ncorner = [0.0, 0.0, 1.0]\nsize = [100.0, 100.0, 9.0]\nparticles = {count}\nmass = 0.01\n"
    ))
}

/// The same, moving sideways too: [`balls`] fall straight, and need only one axis.
#[must_use]
pub fn thrown_balls(count: u32) -> Model {
    let mut model = balls(count);
    model.particles.iter_mut().for_each(|particle| particle.velocity = [1.0, 0.5, 0.0]);
    model
}

/// What a scene file makes.
///
/// # Panics
/// If it is no scene, or the file system has no room for it.
#[must_use]
pub fn model(toml: &str) -> Model {
    let mut file = tempfile::Builder::new().suffix(".toml").tempfile().expect("room for a scene");
    file.write_all(toml.as_bytes()).expect("room for a scene");
    Scene::load(file.path()).expect("a sound scene").model().expect("a scene that fits")
}
