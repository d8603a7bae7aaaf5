//! Scenes that are solved by formulas: particles in free flight, bouncing on one plane, or swinging along a spring.

mod bounce;
mod oscillator;

use bounce::Bounce;
use oscillator::Oscillator;

use super::probe::State;
use crate::model::{Hold, Model, ModelParticle, ModelSpring};
use crate::scene::Settings;

/// The exact motion of every particle of a scene.
#[derive(Clone, Debug)]
pub struct ClosedForm {
    duration: f64,
    gravity: [f64; 3],
    motions: Vec<Motion>,
}

/// Of one particle.
#[derive(Clone, Debug)]
enum Motion {
    /// It stays.
    Held([f64; 3]),
    /// x + v t + ½ g t²
    Flight(ModelParticle),
    /// The same, with bounces.
    Bounces(ModelParticle, Bounce),
    /// Along a spring to a pinned particle.
    Swings(Oscillator),
}

impl ClosedForm {
    /// Of a scene, if it is one of these: no particle on a track, at most one plane, every free particle without springs
    /// or, where there is no plane, on one spring to a pinned particle, moving along it and never to its other end.
    #[must_use]
    pub fn of(model: &Model, settings: &Settings) -> Option<Self> {
        let motions =
            (0..model.particles.len()).map(|number| motion(model, settings, number)).collect::<Option<_>>()?;
        Some(Self { duration: settings.duration, gravity: settings.gravity, motions })
    }

    /// At so many evenly spaced times, the last at the end.
    #[must_use]
    pub fn states(&self, moments: u64) -> Vec<State> {
        (1..=moments).map(|moment| self.at(self.duration * moment as f64 / moments as f64)).collect()
    }

    fn at(&self, time: f64) -> State {
        let states = self.motions.iter().map(|motion| match motion {
            Motion::Held(position) => (*position, [0.0; 3]),
            Motion::Flight(from) => flight(from, self.gravity, time),
            Motion::Bounces(from, bounce) => bounce.at(flight(from, self.gravity, time), time),
            Motion::Swings(oscillator) => oscillator.at(time),
        });
        let (positions, velocities) = states.unzip();
        State { positions, velocities }
    }
}

fn motion(model: &Model, settings: &Settings, number: usize) -> Option<Motion> {
    let particle = *model.particles.get(number)?;
    let mut springs = model.springs.iter().filter(|spring| spring.between.contains(&(number as u32)));
    match (particle.hold, springs.next(), springs.next(), model.planes.as_slice()) {
        (Hold::Track(_), ..) => None,
        (Hold::Pinned, ..) => Some(Motion::Held(particle.position)),
        (Hold::Free, None, None, []) => Some(Motion::Flight(particle)),
        (Hold::Free, None, None, [plane]) => {
            Some(Motion::Bounces(particle, Bounce::of(&particle, plane, settings.gravity)?))
        }
        (Hold::Free, Some(spring), None, []) => {
            Some(Motion::Swings(Oscillator::of(&particle, other_end(model, spring, number)?, spring, settings)?))
        }
        _ => None,
    }
}

/// Where the other end of a spring is pinned; nothing if it is not.
fn other_end(model: &Model, spring: &ModelSpring, number: usize) -> Option<[f64; 3]> {
    let other = spring.between.into_iter().find(|end| *end as usize != number)?;
    model.particles.get(other as usize).filter(|other| other.hold == Hold::Pinned).map(|other| other.position)
}

fn flight(from: &ModelParticle, gravity: [f64; 3], time: f64) -> ([f64; 3], [f64; 3]) {
    let position =
        [0, 1, 2].map(|axis| from.position[axis] + time * (from.velocity[axis] + 0.5 * time * gravity[axis]));
    (position, [0, 1, 2].map(|axis| from.velocity[axis] + time * gravity[axis]))
}

fn dot(left: [f64; 3], right: [f64; 3]) -> f64 {
    left.iter().zip(right).map(|(left, right)| left * right).sum()
}

/// `from` and so much of a direction.
fn along(from: [f64; 3], direction: [f64; 3], by: f64) -> [f64; 3] {
    [0, 1, 2].map(|axis| from[axis] + by * direction[axis])
}
