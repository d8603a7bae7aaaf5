//! The force law in f64, written for reading: the accelerations that every stepper must be true to.

use glam::DVec3;
use hooke_runner::model::{Hold, Model};

/// One spring, as the law needs it.
#[derive(Clone, Copy, Debug)]
struct Spring {
    between: [usize; 2],
    stiffness: f64,
    damping: f64,
    rest_length: f64,
}

/// Gravity and springs: everything that accelerates a particle between two hits.
#[derive(Clone, Debug)]
pub struct RightHandSide {
    gravity: DVec3,
    /// kg, `None` for a particle that nothing accelerates
    mass: Vec<Option<f64>>,
    springs: Vec<Spring>,
}

impl RightHandSide {
    /// The law for this scene, under `gravity` in m/s².
    ///
    /// A particle on a track keeps the velocity that it starts with: the law holds from one of its keys to the next.
    #[must_use]
    pub fn new(model: &Model, gravity: [f64; 3]) -> Self {
        let mass = model.particles.iter().map(|particle| match particle.hold {
            Hold::Free => Some(particle.mass),
            Hold::Pinned | Hold::Track(_) => None,
        });
        let springs = model.springs.iter().map(|spring| Spring {
            between: spring.between.map(|number| number as usize),
            stiffness: spring.stiffness,
            damping: spring.damping,
            rest_length: spring.rest_length,
        });
        Self { gravity: gravity.into(), mass: mass.collect(), springs: springs.collect() }
    }

    /// How many particles it is for.
    #[must_use]
    pub fn particles(&self) -> usize {
        self.mass.len()
    }

    /// The mass of a particle in kg; `None` if nothing accelerates it: it is pinned or on a track.
    #[must_use]
    pub fn mass(&self, particle: usize) -> Option<f64> {
        self.mass[particle]
    }

    /// The acceleration of every particle in m/s², from positions in m and velocities in m/s:
    ///
    /// m a = m g + Σ (k (l − `l_rest`) + `k_d` l̇) d̂, d = x_j − x_i, l = |d|, d̂ = d/l, l̇ = (v_j − v_i)·d̂,
    ///
    /// added at i and subtracted at j. A spring of length 0 pulls in no direction; a pinned particle, or one on a track, has a = 0.
    pub fn accelerate(&self, position: &[[f64; 3]], velocity: &[[f64; 3]], acceleration: &mut [[f64; 3]]) {
        let at = |vectors: &[[f64; 3]], number: usize| DVec3::from(vectors[number]);
        let mut force: Vec<DVec3> = self.mass.iter().map(|mass| mass.unwrap_or(0.0) * self.gravity).collect();
        for spring in &self.springs {
            let [i, j] = spring.between;
            let d = at(position, j) - at(position, i);
            let l = d.length();
            if l == 0.0 {
                continue;
            }
            let direction = d / l;
            let length_rate = (at(velocity, j) - at(velocity, i)).dot(direction);
            let tension = spring.stiffness * (l - spring.rest_length) + spring.damping * length_rate;
            force[i] += tension * direction;
            force[j] -= tension * direction;
        }
        for ((a, f), mass) in acceleration.iter_mut().zip(force).zip(&self.mass) {
            *a = mass.map_or(DVec3::ZERO, |mass| f / mass).into();
        }
    }
}
