//! Irregular scenes: random spring graphs with everything that a regular one lacks.

use crate::random::Random;
use glam::DVec3;
use hooke_runner::model::{Hold, Model, ModelParticle, ModelPlane, ModelSpring};

/// What a random graph is made of.
#[derive(Clone, Copy, Debug)]
pub struct Graph {
    /// All particles; every fourth is in free flight, one in six of the others is pinned.
    pub particles: usize,
    /// Springs between random particles, some of them twice.
    pub springs: usize,
    /// The least and the largest stiffness, N/m.
    pub stiffness: [f64; 2],
    /// The largest damping, N·s/m; a third of the springs has none.
    pub damping: f64,
    /// The least and the largest rest length over the distance at the start.
    pub strain: [f64; 2],
}

impl Default for Graph {
    fn default() -> Self {
        Self { particles: 24, springs: 40, stiffness: [5.0, 50.0], damping: 0.3, strain: [0.7, 1.2] }
    }
}

impl Graph {
    /// The graph of a seed. The last two particles share one place and one velocity, and a spring of length 0 that
    /// nothing ever draws out.
    #[must_use]
    pub fn model(self, seed: u64) -> Model {
        let mut random = Random::new(seed);
        let mut particles: Vec<ModelParticle> =
            (0..self.particles).map(|number| particle(&mut random, number)).collect();
        let attached: Vec<usize> = (0..self.particles).filter(|number| !is_free_flying(*number)).collect();
        let mut springs = Vec::new();
        while springs.len() < self.springs {
            let [i, j] = [0; 2].map(|_| attached[random.below(attached.len())]);
            if i == j {
                continue;
            }
            let distance = DVec3::from(particles[i].position).distance(DVec3::from(particles[j].position));
            let spring = ModelSpring {
                between: [i as u32, j as u32],
                stiffness: random.scale(self.stiffness[0], self.stiffness[1]),
                damping: if random.below(3) == 0 { 0.0 } else { random.between(0.0, self.damping) },
                rest_length: distance * random.between(self.strain[0], self.strain[1]),
            };
            springs.push(spring);
            if random.below(8) == 0 {
                springs.push(ModelSpring { between: [j as u32, i as u32], ..spring });
            }
        }
        let twin = ModelParticle { hold: Hold::Free, ..particle(&mut random, 1) };
        let first = particles.len() as u32;
        particles.extend([twin, twin]);
        springs.push(ModelSpring { between: [first, first + 1], stiffness: 9.0, damping: 0.1, rest_length: 0.2 });
        Model { particles, springs, ..Model::default() }
    }
}

/// Free particles stand between the others, so that slots and numbers differ.
fn is_free_flying(number: usize) -> bool {
    number % 4 == 2
}

fn particle(random: &mut Random, number: usize) -> ModelParticle {
    ModelParticle {
        position: random.vector(1.0),
        velocity: random.vector(0.5),
        mass: random.scale(0.05, 0.5),
        hold: if !is_free_flying(number) && random.below(6) == 0 { Hold::Pinned } else { Hold::Free },
    }
}

/// A tilted box around the unit cube, its sides in an order that is none, their restitutions from 0 to 1.
#[must_use]
pub fn tilted_box() -> Vec<ModelPlane> {
    let tilt = crate::problems::skew();
    let sides = [DVec3::Z, -DVec3::X, DVec3::Y, DVec3::X, -DVec3::Z, -DVec3::Y];
    let restitutions = [0.0, 1.0, 0.3, 0.8, 0.5, 0.9];
    let planes = sides.into_iter().zip(restitutions).map(|(inward, restitution)| {
        let normal = (tilt * inward).normalize();
        ModelPlane { point: (-1.3 * normal).to_array(), normal: normal.to_array(), restitution }
    });
    planes.collect()
}
