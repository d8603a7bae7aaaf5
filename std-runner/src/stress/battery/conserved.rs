//! What the laws of motion keep, worked out from positions and velocities alone.

use super::case::Case;
use super::observe::Moment;
use crate::model::Hold;

/// Where the energy is, J.
#[derive(Clone, Copy, Debug, Default)]
pub struct Energy {
    kinetic: f64,
    elastic: f64,
    gravitational: f64,
}

impl Energy {
    /// J
    pub fn sum(self) -> f64 {
        self.kinetic + self.elastic + self.gravitational
    }

    /// What the sum is left of, J.
    pub fn scale(self) -> f64 {
        self.kinetic.max(self.elastic).max(self.gravitational.abs())
    }
}

/// Of the particles that move. Heights are from where each was at the start: else the choice of an origin would hide what
/// is lost.
pub fn energy(case: &Case, moment: &Moment) -> Energy {
    let mut energy = Energy::default();
    let states = moment.position.iter().zip(&moment.velocity);
    for (particle, (position, velocity)) in case.model.particles.iter().zip(states) {
        if particle.hold == Hold::Free {
            let moved = difference(particle.position, *position);
            energy.kinetic += 0.5 * particle.mass * dot(*velocity, *velocity);
            energy.gravitational -= particle.mass * dot(case.gravity, moved);
        }
    }
    for spring in &case.model.springs {
        let [Some(from), Some(to)] = spring.between.map(|end| moment.position.get(end as usize)) else { continue };
        let d = difference(*from, *to);
        energy.elastic += 0.5 * spring.stiffness * (dot(d, d).sqrt() - spring.rest_length).powi(2);
    }
    energy
}

/// The sum of m v by component, and of m |v| by component, kg m/s.
pub fn momentum(case: &Case, moment: &Moment) -> [[f64; 3]; 2] {
    let mut sums = [[0.0; 3]; 2];
    for (particle, velocity) in case.model.particles.iter().zip(&moment.velocity) {
        for (axis, component) in velocity.iter().enumerate() {
            sums[0][axis] += particle.mass * component;
            sums[1][axis] += particle.mass * component.abs();
        }
    }
    sums
}

fn difference(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| to[axis] - from[axis])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a * b).sum()
}
