//! A mass on a spring that bounces on a plane.

use super::bounces::{Bounces, Phase};
use super::{Problem, build, harmonic, skew};
use crate::moment::Moment;
use hooke_runner::model::Model;
use std::f64::consts::TAU;

/// An undamped oscillator along the normal of a plane: a mass hangs from a pin above a floor.
///
/// Its weight keeps the spring taut at the top of the swing, too: a spring that pushes would throw the mass off its line.
#[derive(Clone, Copy, Debug)]
pub struct BouncingOscillator {
    /// m, kg
    pub mass: f64,
    /// k, N/m
    pub stiffness: f64,
    /// L, m
    pub rest_length: f64,
    /// Towards the plane, m/s²; m g/k is more than the swing.
    pub gravity: f64,
    /// `x_e`, the height of the equilibrium over the plane, m; negative: the spring presses the mass against it.
    pub equilibrium: f64,
    /// Over the plane at the start, m, more than 0.
    pub height: f64,
    /// Away from the plane at the start, m/s.
    pub velocity: f64,
    /// e
    pub restitution: f64,
}

impl BouncingOscillator {
    /// ω = 5 rad/s, let go from 0.2 m with a push; for an equilibrium between −0.15 m and 0.15 m.
    #[must_use]
    pub fn new(equilibrium: f64, restitution: f64) -> Self {
        Self {
            mass: 0.5,
            stiffness: 12.5,
            rest_length: 0.6,
            gravity: 9.81,
            equilibrium,
            height: 0.2,
            velocity: 0.3,
            restitution,
        }
    }

    /// ω = √(k/m), rad/s
    #[must_use]
    pub fn frequency(&self) -> f64 {
        (self.stiffness / self.mass).sqrt()
    }

    /// Between impacts x = `x_e` + an undamped oscillation, so a flight that leaves the plane at u comes back at u.
    ///
    /// On the phase circle (x − `x_e`, ẋ/ω), run through at the rate ω, such a flight turns through 2(π − atan(u/(ω `x_e`))) for `x_e` > 0,
    /// π for `x_e` = 0, 2 atan(u/(ω |`x_e`|)) for `x_e` < 0: all are 2 atan2(u, −ω `x_e`).
    /// Impact n has the speed e^{n−1} b. Only for `x_e` < 0 do the flights shrink to nothing (Zeno).
    /// Watched for six periods.
    ///
    /// # Panics
    /// The first swing does not reach the plane, or slackens the spring.
    #[must_use]
    pub fn problem(self) -> Problem {
        let omega = self.frequency();
        let level = self.equilibrium;
        let start = self.height - level;
        let amplitude = start.hypot(self.velocity / omega);
        assert!(amplitude > level.abs(), "the swing reaches the plane");
        let sag = self.mass * self.gravity / self.stiffness;
        assert!(amplitude < sag, "the spring stays taut");
        let phase = (self.velocity / omega).atan2(start);
        let arrival = (phase + (-level / amplitude).acos()) / omega;
        // The sum and the difference, not a difference of squares, which would cancel at a grazing hit.
        let speed = omega * ((amplitude - level) * (amplitude + level)).sqrt();
        let flight = move |speed: f64| 2.0 * speed.atan2(-omega * level) / omega;
        let duration = 6.0 * TAU / omega;
        let bounces = Bounces::new(self.restitution, [arrival, speed], duration, level < 0.0, flight);
        let model = Model {
            particles: vec![build::pinned(), build::free(self.mass)],
            springs: vec![build::spring([0, 1], self.stiffness, 0.0, self.rest_length)],
            planes: vec![build::floor(self.restitution)],
            ..Model::default()
        };
        let name = format!("bouncing oscillator, equilibrium {level}, restitution {}", self.restitution);
        let (impacts, rest) = (bounces.impacts(1, self.mass), bounces.rest());
        let gravity = [0.0, 0.0, -self.gravity];
        let pin = [0.0, 0.0, level + sag + self.rest_length];
        let mut problem = Problem::new(name, model, gravity, duration, move |time| {
            let swing = |x0: f64, v0: f64, since: f64| {
                let (x, v) = harmonic::motion(omega, 0.0, x0, v0, since);
                (level + x, v)
            };
            let (z, w) = match bounces.phase(time) {
                Phase::Approach => swing(start, self.velocity, time),
                Phase::Flight { since, speed } => swing(-level, speed, since),
                Phase::Rest => (0.0, 0.0),
            };
            Moment::default().with(pin, [0.0; 3]).with([0.0, 0.0, z], [0.0, 0.0, w])
        });
        problem.impacts = impacts;
        problem.rest = rest;
        problem.turned(skew())
    }
}
