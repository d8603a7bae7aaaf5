//! One mass on a spring.

use super::{Problem, build, harmonic, skew};
use crate::moment::Moment;
use hooke_runner::model::Model;

/// A mass on a spring from a pinned particle, moving along the spring.
#[derive(Clone, Copy, Debug)]
pub struct Oscillator {
    /// m, kg
    pub mass: f64,
    /// k, N/m
    pub stiffness: f64,
    /// ζ = `k_d` / (2√(k m)): below 1 it swings, at 1 and above it creeps back.
    pub damping_ratio: f64,
    /// L, m; longer than the swing, for at length 0 a spring has no direction.
    pub rest_length: f64,
    /// Gravity along the spring, away from the pin, m/s².
    pub gravity: f64,
    /// From the equilibrium at the start, away from the pin, m.
    pub displacement: f64,
    /// At the start, away from the pin, m/s.
    pub velocity: f64,
}

impl Default for Oscillator {
    /// ω = 20 rad/s, let go from 0.15 m with a push, no damping, no gravity.
    fn default() -> Self {
        Self {
            mass: 0.25,
            stiffness: 100.0,
            damping_ratio: 0.0,
            rest_length: 0.7,
            gravity: 0.0,
            displacement: 0.15,
            velocity: -1.0,
        }
    }
}

impl Oscillator {
    /// ω = √(k/m), rad/s
    #[must_use]
    pub fn frequency(&self) -> f64 {
        (self.stiffness / self.mass).sqrt()
    }

    /// `k_d` = 2ζ√(k m), N·s/m
    #[must_use]
    pub fn damping(&self) -> f64 {
        2.0 * self.damping_ratio * (self.stiffness * self.mass).sqrt()
    }

    /// Length L + m g/k + x and x with x from [`harmonic::motion`]: gravity moves the equilibrium and nothing else.
    ///
    /// Watched for three periods.
    #[must_use]
    pub fn problem(self) -> Problem {
        let model = Model {
            particles: vec![build::pinned(), build::free(self.mass)],
            springs: vec![build::spring([0, 1], self.stiffness, self.damping(), self.rest_length)],
            ..Model::default()
        };
        let equilibrium = self.rest_length + self.mass * self.gravity / self.stiffness;
        let name = format!("oscillator, damping ratio {}, gravity {}", self.damping_ratio, self.gravity);
        let duration = 3.0 * std::f64::consts::TAU / self.frequency();
        Problem::new(name, model, [self.gravity, 0.0, 0.0], duration, move |time| {
            let (x, v) = harmonic::motion(self.frequency(), self.damping_ratio, self.displacement, self.velocity, time);
            Moment::default().with([0.0; 3], [0.0; 3]).with([equilibrium + x, 0.0, 0.0], [v, 0.0, 0.0])
        })
        .turned(skew())
    }
}
