//! Parts of a scene, in few words. Positions and velocities come from the solution at time 0.

use hooke_runner::model::{Hold, ModelParticle, ModelPlane, ModelSpring};

/// A particle that moves, kg.
pub fn free(mass: f64) -> ModelParticle {
    ModelParticle { position: [0.0; 3], velocity: [0.0; 3], mass, hold: Hold::Free }
}

/// A particle that does not.
pub fn pinned() -> ModelParticle {
    ModelParticle { hold: Hold::Pinned, ..free(1.0) }
}

/// A spring between two particles: N/m, N·s/m, m.
pub fn spring(between: [usize; 2], stiffness: f64, damping: f64, rest_length: f64) -> ModelSpring {
    ModelSpring { between: between.map(|number| number as u32), stiffness, damping, rest_length }
}

/// The plane z = 0, particles above it.
pub fn floor(restitution: f64) -> ModelPlane {
    ModelPlane { point: [0.0; 3], normal: [0.0, 0.0, 1.0], restitution }
}
