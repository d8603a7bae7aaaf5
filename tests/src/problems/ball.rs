//! A ball bouncing on a plane, level or inclined.

use super::bounces::{Bounces, Phase};
use super::{Problem, build, skew};
use crate::moment::Moment;
use hooke_runner::model::Model;

/// A thrown ball over a plane. Axes before turning: x down the slope, y across, z along the normal.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    /// m, kg
    pub mass: f64,
    /// Magnitude, m/s².
    pub gravity: f64,
    /// α, the plane's slope, rad, less than π/2.
    pub slope: f64,
    /// h, from the plane along its normal at the start, m.
    pub height: f64,
    /// At the start, m/s.
    pub velocity: [f64; 3],
    /// e
    pub restitution: f64,
    /// s
    pub duration: f64,
}

impl Default for Ball {
    /// Let go a metre above a level floor.
    fn default() -> Self {
        Self { mass: 0.2, gravity: 9.81, slope: 0.0, height: 1.0, velocity: [0.0; 3], restitution: 0.8, duration: 3.0 }
    }
}

impl Ball {
    /// The normal and the tangential motion are independent (no friction).
    ///
    /// With `g_n` = g cos α and the start at height h with normal velocity w: impact speed b = √(w² + 2 `g_n` h) at
    /// t₁ = (w + b)/`g_n`; impact n has speed e^{n−1} b, and a flight that starts with speed u lasts 2u/`g_n`.
    /// Summed as a geometric series, for w = 0: `t_n` = t₁ (1 + 2e (1 − e^{n−1})/(1 − e)), and all is over at
    /// T = t₁ (1 + e)/(1 − e). Along the slope: s₀ + u₀ t + ½ g sin α t².
    ///
    /// All of it follows from a velocity that falls by `g_n` a second and from the geometric series.
    #[must_use]
    pub fn problem(self) -> Problem {
        let pull = self.gravity * self.slope.cos();
        let slide = self.gravity * self.slope.sin();
        let [along, across, normal] = self.velocity;
        let first = normal.hypot((2.0 * pull * self.height).sqrt());
        let bounces = Bounces::new(self.restitution, [(normal + first) / pull, first], self.duration, true, |speed| {
            2.0 * speed / pull
        });
        let model = Model {
            particles: vec![build::free(self.mass)],
            planes: vec![build::floor(self.restitution)],
            ..Model::default()
        };
        let name =
            format!("ball, restitution {}, slope {}, velocity {:?}", self.restitution, self.slope, self.velocity);
        let impacts = bounces.impacts(0, self.mass);
        let rest = bounces.rest();
        let gravity = [slide, 0.0, -pull];
        let mut problem = Problem::new(name, model, gravity, self.duration, move |time| {
            let arc = |start: f64, speed: f64, since: f64| {
                let fall = pull * since;
                (start + (speed - 0.5 * fall) * since, speed - fall)
            };
            let (z, w) = match bounces.phase(time) {
                Phase::Approach => arc(self.height, normal, time),
                Phase::Flight { since, speed } => arc(0.0, speed, since),
                Phase::Rest => (0.0, 0.0),
            };
            let x = (along + 0.5 * slide * time) * time;
            Moment::default().with([x, across * time, z], [along + slide * time, across, w])
        });
        problem.impacts = impacts;
        problem.rest = rest;
        problem.turned(skew())
    }

    /// t₁ (1 + e)/(1 − e), t₁ = √(2h/`g_n`): when a ball let go without normal velocity stops bouncing, s.
    #[must_use]
    pub fn end_of_bouncing(&self) -> f64 {
        let first = (2.0 * self.height / (self.gravity * self.slope.cos())).sqrt();
        first * (1.0 + self.restitution) / (1.0 - self.restitution)
    }
}
