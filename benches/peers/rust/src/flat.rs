//! The scene as columns of numbers, for the workers that are not written in Rust.

use std::error::Error;

use hooke_runner::model::Hold;
use hooke_runner::scene::Scene;

/// Everything a peer needs to know; lists of x, y, z are flat.
#[derive(serde::Serialize)]
pub struct Flat {
    gravity: [f64; 3],
    position: Vec<f64>,
    velocity: Vec<f64>,
    mass: Vec<f64>,
    pinned: Vec<usize>,
    /// Particles i and j of each spring.
    between: Vec<u32>,
    stiffness: Vec<f64>,
    damping: Vec<f64>,
    rest_length: Vec<f64>,
    planes: Vec<Plane>,
}

#[derive(serde::Serialize)]
struct Plane {
    normal: [f64; 3],
    point: [f64; 3],
    restitution: f64,
}

impl Flat {
    pub fn new(scene: &Scene) -> Result<Self, Box<dyn Error>> {
        let model = scene.model()?;
        let (particles, springs) = (&model.particles, &model.springs);
        Ok(Self {
            gravity: scene.settings().gravity,
            position: particles.iter().flat_map(|particle| particle.position).collect(),
            velocity: particles.iter().flat_map(|particle| particle.velocity).collect(),
            mass: particles.iter().map(|particle| particle.mass).collect(),
            pinned: (0..particles.len()).filter(|number| particles[*number].hold != Hold::Free).collect(),
            between: springs.iter().flat_map(|spring| spring.between).collect(),
            stiffness: springs.iter().map(|spring| spring.stiffness).collect(),
            damping: springs.iter().map(|spring| spring.damping).collect(),
            rest_length: springs.iter().map(|spring| spring.rest_length).collect(),
            planes: model
                .planes
                .iter()
                .map(|plane| Plane { normal: plane.normal, point: plane.point, restitution: plane.restitution })
                .collect(),
        })
    }
}
