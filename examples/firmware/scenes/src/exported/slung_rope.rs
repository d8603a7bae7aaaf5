//! The scene "slung rope", written by `hooke export --firmware`: not to be changed by hand.
#![allow(dead_code, reason = "a program takes what it needs")]

use hooke::{Fixed, Particle, Plane, Spring, World};

/// Room for the scene, and for nothing more.
pub type Capacity = Fixed<PARTICLES, SPRINGS, PLANES>;
/// A world of that capacity.
pub type Scene = World<f32, PARTICLES, SPRINGS, PLANES>;
/// What the scene is stepped by.
pub type Stepper = hooke::Auto<f32, Capacity, 0>;
/// What happens at its planes.
pub type Response = hooke::TimeOfImpact<f32, Capacity>;

/// Particles.
pub const PARTICLES: usize = 41;

/// Springs.
pub const SPRINGS: usize = 40;

/// Planes.
pub const PLANES: usize = 0;

/// What positions are relative to, m.
pub const ORIGIN: [f64; 3] = [0.0, 0.0, 0.0];

/// m/s²
pub const GRAVITY: [f32; 3] = [0.0, 0.0, -9.81];

/// Position (m), velocity (m/s), mass (kg), whether it is pinned.
pub static PARTICLE: [([f32; 3], [f32; 3], f32, bool); PARTICLES] = [
    ([-1.0, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, true),
    ([-0.95, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.9, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.85, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.8, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.75, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.7, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.65, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.6, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.55, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.5, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.45, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.4, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.35, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.3, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.25, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.2, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.15, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.1, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([-0.05, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.0, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.05, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.1, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.15, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.2, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.25, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.3, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.35, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.4, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.45, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.5, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.55, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.6, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.65, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.7, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.75, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.8, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.85, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.9, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([0.95, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, false),
    ([1.0, 0.0, 2.0], [0.0, 0.0, 0.0], 0.02, true),
];

/// Ends, stiffness (N/m), damping (N·s/m), rest length (m).
pub static SPRING: [([u32; 2], f32, f32, f32); SPRINGS] = [
    ([0, 1], 250.0, 0.3, 0.05),
    ([1, 2], 250.0, 0.3, 0.05),
    ([2, 3], 250.0, 0.3, 0.05),
    ([3, 4], 250.0, 0.3, 0.05),
    ([4, 5], 250.0, 0.3, 0.05),
    ([5, 6], 250.0, 0.3, 0.05),
    ([6, 7], 250.0, 0.3, 0.05),
    ([7, 8], 250.0, 0.3, 0.05),
    ([8, 9], 250.0, 0.3, 0.05),
    ([9, 10], 250.0, 0.3, 0.05),
    ([10, 11], 250.0, 0.3, 0.05),
    ([11, 12], 250.0, 0.3, 0.05),
    ([12, 13], 250.0, 0.3, 0.05),
    ([13, 14], 250.0, 0.3, 0.05),
    ([14, 15], 250.0, 0.3, 0.05),
    ([15, 16], 250.0, 0.3, 0.05),
    ([16, 17], 250.0, 0.3, 0.05),
    ([17, 18], 250.0, 0.3, 0.05),
    ([18, 19], 250.0, 0.3, 0.05),
    ([19, 20], 250.0, 0.3, 0.05),
    ([20, 21], 250.0, 0.3, 0.05),
    ([21, 22], 250.0, 0.3, 0.05),
    ([22, 23], 250.0, 0.3, 0.05),
    ([23, 24], 250.0, 0.3, 0.05),
    ([24, 25], 250.0, 0.3, 0.05),
    ([25, 26], 250.0, 0.3, 0.05),
    ([26, 27], 250.0, 0.3, 0.05),
    ([27, 28], 250.0, 0.3, 0.05),
    ([28, 29], 250.0, 0.3, 0.05),
    ([29, 30], 250.0, 0.3, 0.05),
    ([30, 31], 250.0, 0.3, 0.05),
    ([31, 32], 250.0, 0.3, 0.05),
    ([32, 33], 250.0, 0.3, 0.05),
    ([33, 34], 250.0, 0.3, 0.05),
    ([34, 35], 250.0, 0.3, 0.05),
    ([35, 36], 250.0, 0.3, 0.05),
    ([36, 37], 250.0, 0.3, 0.05),
    ([37, 38], 250.0, 0.3, 0.05),
    ([38, 39], 250.0, 0.3, 0.05),
    ([39, 40], 250.0, 0.3, 0.05),
];

/// Point (m), direction, restitution.
pub static PLANE: [([f32; 3], [f32; 3], f32); PLANES] = [
];

/// The whole scene.
pub const STEPS: u32 = 5000;

/// When a step ends, s; step 1 is the first.
#[must_use]
pub fn end(step: u32) -> f64 {
    if step < STEPS { f64::from(step) * 0.001 } else { 5.0 }
}

/// How long a step is, s.
#[must_use]
pub fn length(_step: u32) -> f32 {
    0.001
}

/// A stepper as the scene says.
#[must_use]
pub const fn stepper() -> Stepper {
    Stepper::new(1e-6)
}

/// A response as the scene says.
#[must_use]
pub const fn response() -> Response {
    Response::new()
}

/// Fills a new world. Nothing if it is not empty.
pub fn fill(world: &mut Scene) -> Option<()> {
    for (position, velocity, mass, pinned) in &PARTICLE {
        let particle = Particle::at(*position).with_velocity(*velocity).with_mass(*mass);
        world.add_particle(if *pinned { particle.pinned() } else { particle }).ok()?;
    }
    for (between, stiffness, damping, rest_length) in &SPRING {
        world.add_spring(Spring::new(*between, *stiffness, *rest_length).with_damping(*damping)).ok()?;
    }
    for (point, normal, restitution) in &PLANE {
        world.add_plane(Plane::through(*point, *normal, *restitution).ok()?).ok()?;
    }
    world.set_gravity(GRAVITY).ok()?;
    Some(())
}
