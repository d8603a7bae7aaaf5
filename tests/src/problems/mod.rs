//! Problems whose exact solution is known, one file a family.
//!
//! Each is written along the simplest axes and then turned by [`skew`], so that no coordinate is special.

use crate::energy;
use crate::moment::Moment;
use glam::{DQuat, DVec3};
use hooke_runner::model::Model;
use std::fmt::{Debug, Formatter};

pub mod ball;
mod bounces;
pub mod bouncing_oscillator;
mod build;
pub mod chain;
pub mod hanging;
pub mod harmonic;
pub mod oscillator;
pub mod projectile;
mod sets;
pub mod two_bodies;

pub use sets::{bouncing, smooth};

/// The state at a time in s, from 0 on.
pub type Exact = Box<dyn Fn(f64) -> Moment + Send + Sync>;

/// A scene and what becomes of it.
pub struct Problem {
    /// What it is, for a failing test to say.
    pub name: String,
    /// The scene.
    pub model: Model,
    /// m/s²
    pub gravity: [f64; 3],
    /// How long it is worth watching, s.
    pub duration: f64,
    /// The state at any time from 0 to `duration`; at the instant of an impact, the one after it.
    pub exact: Exact,
    /// All impacts up to `duration`, in order; endless sequences end where the speed has fallen to
    /// [`FAINTEST`] of the first.
    pub impacts: Vec<Impact>,
    /// When the last of endlessly many bounces is over and the particle rests on the plane, s (Zeno's paradox).
    pub rest: Option<f64>,
}

/// Impacts slower than this part of the first are not listed: their energy, 1e-24 of the first's, is below rounding.
pub const FAINTEST: f64 = 1e-12;

/// A particle meets a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// s
    pub time: f64,
    /// Its number.
    pub particle: usize,
    /// The plane's number.
    pub plane: usize,
    /// How fast it comes in, along the normal, m/s.
    pub speed: f64,
    /// ½ m (1 − e²) speed², J
    pub energy_lost: f64,
}

impl Problem {
    /// A scene that starts from `exact(0)`: the particles of `model` are put there.
    fn new(
        name: impl Into<String>,
        mut model: Model,
        gravity: [f64; 3],
        duration: f64,
        exact: impl Fn(f64) -> Moment + Send + Sync + 'static,
    ) -> Self {
        let start = exact(0.0);
        assert_eq!(start.position.len(), model.particles.len());
        for (number, particle) in model.particles.iter_mut().enumerate() {
            particle.position = start.position[number];
            particle.velocity = start.velocity[number];
        }
        Self { name: name.into(), model, gravity, duration, exact: Box::new(exact), impacts: Vec::new(), rest: None }
    }

    /// The same scene in axes turned about the origin: gravity, planes, particles and the solution alike.
    #[must_use]
    pub fn turned(mut self, rotation: DQuat) -> Self {
        let turn = move |vector: [f64; 3]| (rotation * DVec3::from(vector)).to_array();
        self.gravity = turn(self.gravity);
        for particle in &mut self.model.particles {
            particle.position = turn(particle.position);
            particle.velocity = turn(particle.velocity);
        }
        for plane in &mut self.model.planes {
            plane.point = turn(plane.point);
            plane.normal = DVec3::from(turn(plane.normal)).normalize().to_array();
        }
        let exact = self.exact;
        self.exact = Box::new(move |time| {
            let mut moment = exact(time);
            for vector in moment.position.iter_mut().chain(&mut moment.velocity) {
                *vector = turn(*vector);
            }
            moment
        });
        self
    }

    /// Kinetic + elastic + gravitational energy at `time` in s, J.
    #[must_use]
    pub fn energy(&self, time: f64) -> f64 {
        energy::total(&self.model, self.gravity, &(self.exact)(time))
    }

    /// What impacts have taken by `time` in s, J.
    #[must_use]
    pub fn lost_in_impacts(&self, time: f64) -> f64 {
        let until = self.impacts.iter().take_while(|hit| hit.time <= time);
        until.map(|hit| hit.energy_lost).sum()
    }

    /// What damping has taken by `time` in s, J: what is gone and no impact took.
    #[must_use]
    pub fn lost_to_damping(&self, time: f64) -> f64 {
        self.energy(0.0) - self.energy(time) - self.lost_in_impacts(time)
    }
}

impl Debug for Problem {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.name)
    }
}

/// A rotation that leaves no axis near any other: x becomes (0.48, −0.57, 0.67), z becomes (−0.27, 0.63, 0.73).
#[must_use]
pub fn skew() -> DQuat {
    DQuat::from_scaled_axis(DVec3::new(-0.5, -0.6, -0.9))
}
