//! The equation of motion as general solvers want it: y' = f(y), y = all positions, then all velocities, f64.

use std::error::Error;

use glam::DVec3;
use hooke_runner::model::Hold;
use hooke_runner::scene::Scene;

/// A scene without planes.
#[derive(Clone)]
pub struct RightHandSide {
    /// y at the start.
    pub start: Vec<f64>,
    /// 3 times the number of particles: where the velocities begin.
    half: usize,
    inverse_mass: Vec<f64>,
    gravity: DVec3,
    springs: Vec<Spring>,
}

#[derive(Clone, Copy)]
struct Spring {
    /// Where x of either particle is.
    between: [usize; 2],
    stiffness: f64,
    damping: f64,
    rest_length: f64,
}

/// What both the force and its derivative begin with.
struct Stretched {
    length: f64,
    direction: DVec3,
    velocity: DVec3,
    tension: f64,
}

impl RightHandSide {
    pub fn new(scene: &Scene) -> Result<Self, Box<dyn Error>> {
        let model = scene.model()?;
        if !model.planes.is_empty() {
            return Err("it solves smooth equations: no planes".into());
        }
        let positions = model.particles.iter().flat_map(|particle| particle.position);
        let velocities = model.particles.iter().flat_map(|particle| particle.velocity);
        Ok(Self {
            start: positions.chain(velocities).collect(),
            half: 3 * model.particles.len(),
            inverse_mass: model
                .particles
                .iter()
                .map(|particle| if particle.hold == Hold::Free { 1.0 / particle.mass } else { 0.0 })
                .collect(),
            gravity: DVec3::from_array(scene.settings().gravity),
            springs: model
                .springs
                .iter()
                .map(|spring| Spring {
                    between: spring.between.map(|number| 3 * number as usize),
                    stiffness: spring.stiffness,
                    damping: spring.damping,
                    rest_length: spring.rest_length,
                })
                .collect(),
        })
    }

    /// The positions in a state.
    pub fn positions(&self, state: &[f64]) -> Vec<f64> {
        state[..self.half].to_vec()
    }

    /// f(y)
    pub fn rate(&self, state: &[f64], rate: &mut [f64]) {
        let (velocity, acceleration) = self.halves(&state[self.half..], rate);
        for spring in &self.springs {
            let Some(Stretched { direction, tension, .. }) = self.stretched(spring, state, velocity) else { continue };
            scatter(spring, acceleration, direction * tension);
        }
        for (acceleration, inverse_mass) in acceleration.chunks_exact_mut(3).zip(&self.inverse_mass) {
            let gravity = if *inverse_mass > 0.0 { self.gravity } else { DVec3::ZERO };
            (DVec3::from_slice(acceleration) * *inverse_mass + gravity).write_to_slice(acceleration);
        }
    }

    /// ∂f/∂y · change
    pub fn rate_change(&self, state: &[f64], change: &[f64], rate: &mut [f64]) {
        let (_, acceleration) = self.halves(&change[self.half..], rate);
        for spring in &self.springs {
            let Some(Stretched { length, direction, velocity, tension }) =
                self.stretched(spring, state, &state[self.half..])
            else {
                continue;
            };
            let moved = between(spring, change);
            let turned = (moved - direction * moved.dot(direction)) / length;
            let sped = between(spring, &change[self.half..]).dot(direction) + velocity.dot(turned);
            let tension_change = spring.stiffness * moved.dot(direction) + spring.damping * sped;
            scatter(spring, acceleration, direction * tension_change + turned * tension);
        }
        for (acceleration, inverse_mass) in acceleration.chunks_exact_mut(3).zip(&self.inverse_mass) {
            (DVec3::from_slice(acceleration) * *inverse_mass).write_to_slice(acceleration);
        }
    }

    /// Writes the rate of the positions, and lends the accelerations, all 0.
    fn halves<'a, 'b>(&self, velocity: &'a [f64], rate: &'b mut [f64]) -> (&'a [f64], &'b mut [f64]) {
        let (position_rate, acceleration) = rate.split_at_mut(self.half);
        position_rate.copy_from_slice(velocity);
        acceleration.fill(0.0);
        (velocity, acceleration)
    }

    fn stretched(&self, spring: &Spring, position: &[f64], velocity: &[f64]) -> Option<Stretched> {
        let separation = between(spring, position);
        let length = separation.length();
        // A spring without length has no direction to pull in.
        if length == 0.0 {
            return None;
        }
        let direction = separation / length;
        let velocity = between(spring, velocity);
        let tension = spring.stiffness * (length - spring.rest_length) + spring.damping * velocity.dot(direction);
        Some(Stretched { length, direction, velocity, tension })
    }
}

fn between(spring: &Spring, vectors: &[f64]) -> DVec3 {
    let [i, j] = spring.between;
    DVec3::from_slice(&vectors[j..]) - DVec3::from_slice(&vectors[i..])
}

fn scatter(spring: &Spring, sums: &mut [f64], force: DVec3) {
    let [i, j] = spring.between;
    (DVec3::from_slice(&sums[i..]) + force).write_to_slice(&mut sums[i..]);
    (DVec3::from_slice(&sums[j..]) - force).write_to_slice(&mut sums[j..]);
}
