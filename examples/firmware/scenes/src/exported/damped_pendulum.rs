//! The scene "damped pendulum on a spring", written by `hooke export --firmware`: not to be changed by hand.
#![allow(dead_code, reason = "a program takes what it needs")]

use hooke::{Fixed, Particle, Plane, Spring, World};

/// Room for the scene, and for nothing more.
pub type Capacity = Fixed<PARTICLES, SPRINGS, PLANES>;
/// A world of that capacity.
pub type Scene = World<f64, PARTICLES, SPRINGS, PLANES>;
/// What the scene is stepped by.
pub type Stepper = hooke::VelocityVerlet<f64, Capacity>;
/// What happens at its planes.
pub type Response = hooke::TimeOfImpact<f64, Capacity>;

/// Particles.
pub const PARTICLES: usize = 2;

/// Springs.
pub const SPRINGS: usize = 1;

/// Planes.
pub const PLANES: usize = 0;

/// What positions are relative to, m.
pub const ORIGIN: [f64; 3] = [0.0, 0.0, 0.0];

/// m/s²
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Position (m), velocity (m/s), mass (kg), whether it is pinned.
pub static PARTICLE: [([f64; 3], [f64; 3], f64, bool); PARTICLES] = [
    ([0.0, 0.0, 2.0], [0.0, 0.0, 0.0], 1.0, true),
    ([1.1, 0.0, 1.6], [0.0, 0.0, 0.0], 0.5, false),
];

/// Ends, stiffness (N/m), damping (N·s/m), rest length (m).
pub static SPRING: [([u32; 2], f64, f64, f64); SPRINGS] = [
    ([0, 1], 60.0, 0.6, 1.0),
];

/// Point (m), direction, restitution.
pub static PLANE: [([f64; 3], [f64; 3], f64); PLANES] = [
];

/// The whole scene.
pub const STEPS: u32 = 3000;

/// When a step ends, s; step 1 is the first.
#[must_use]
pub fn end(step: u32) -> f64 {
    if step < STEPS { f64::from(step) * 0.002 } else { 6.0 }
}

/// How long a step is, s.
#[must_use]
pub fn length(_step: u32) -> f64 {
    0.002
}

/// A stepper as the scene says.
#[must_use]
pub const fn stepper() -> Stepper {
    Stepper::new()
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
