//! Energy of a state, and the rate at which damping takes it.

use crate::moment::Moment;
use glam::DVec3;
use hooke_runner::model::{Hold, Model, ModelSpring};

/// Kinetic + elastic + gravitational energy, J: Σ ½ m v² + Σ ½ k (l − `l_rest`)² − Σ m g·x, g in m/s².
///
/// Pinned particles hold none that could change, so they are left out.
#[must_use]
pub fn total(model: &Model, gravity: [f64; 3], moment: &Moment) -> f64 {
    let gravity = DVec3::from(gravity);
    let mut energy = 0.0;
    for (number, particle) in model.particles.iter().enumerate() {
        if particle.hold == Hold::Free {
            let velocity = DVec3::from(moment.velocity[number]);
            let position = DVec3::from(moment.position[number]);
            energy += particle.mass * (0.5 * velocity.length_squared() - gravity.dot(position));
        }
    }
    for spring in &model.springs {
        let stretch = separation(spring, &moment.position).length() - spring.rest_length;
        energy += 0.5 * spring.stiffness * stretch * stretch;
    }
    energy
}

/// The power that goes into damping, W: Σ `k_d` l̇².
#[must_use]
pub fn damping_power(model: &Model, moment: &Moment) -> f64 {
    let power = model.springs.iter().map(|spring| {
        let direction = separation(spring, &moment.position).normalize_or_zero();
        let length_rate = separation(spring, &moment.velocity).dot(direction);
        spring.damping * length_rate * length_rate
    });
    power.sum()
}

fn separation(spring: &ModelSpring, vectors: &[[f64; 3]]) -> DVec3 {
    let [i, j] = spring.between.map(|number| number as usize);
    DVec3::from(vectors[j]) - DVec3::from(vectors[i])
}
