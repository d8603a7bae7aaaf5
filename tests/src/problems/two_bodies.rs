//! Two masses on one spring, flying freely: Goldstein, "Classical Mechanics", chapter 3.
//!
//! With c the centre of mass, r = x₁ − x₀ and μ = m₀m₁/(m₀ + m₁):
//! c̈ = g, μ r̈ = the spring's force; x₀ = c − (m₁/M) r, x₁ = c + (m₀/M) r.

use super::projectile::flight;
use super::{Problem, build, harmonic, skew};
use crate::moment::Moment;
use glam::DVec3;
use hooke_runner::model::Model;
use std::f64::consts::TAU;

/// Two masses, their spring, and the flight of their centre of mass from the origin.
#[derive(Clone, Copy, Debug)]
pub struct TwoBodies {
    /// kg
    pub masses: [f64; 2],
    /// k, N/m
    pub stiffness: f64,
    /// `k_d`, N·s/m
    pub damping: f64,
    /// L, m
    pub rest_length: f64,
    /// Of the centre of mass at the start, m/s.
    pub velocity: [f64; 3],
    /// m/s²
    pub gravity: [f64; 3],
}

impl Default for TwoBodies {
    /// Unequal masses thrown upwards, ω = 12 rad/s or so.
    fn default() -> Self {
        Self {
            masses: [0.5, 1.25],
            stiffness: 50.0,
            damping: 0.0,
            rest_length: 0.8,
            velocity: [0.7, -0.4, 3.0],
            gravity: [0.0, 0.0, -9.81],
        }
    }
}

impl TwoBodies {
    /// μ = m₀m₁/(m₀ + m₁), kg
    #[must_use]
    pub fn reduced_mass(&self) -> f64 {
        let [m0, m1] = self.masses;
        m0 * m1 / (m0 + m1)
    }

    /// √(k/μ), rad/s
    #[must_use]
    pub fn frequency(&self) -> f64 {
        (self.stiffness / self.reduced_mass()).sqrt()
    }

    /// Along their line: l − L is an oscillator with ω² = k/μ, ζ = `k_d`/(2√(kμ)).
    ///
    /// `stretch` is l − L in m and `rate` its derivative in m/s, at the start; |stretch| stays below L.
    #[must_use]
    pub fn radial(self, stretch: f64, rate: f64) -> Problem {
        let zeta = self.damping / (2.0 * (self.stiffness * self.reduced_mass()).sqrt());
        let name = format!("two bodies, radial, damping {}", self.damping);
        self.problem(name, move |time| {
            let (x, v) = harmonic::motion(self.frequency(), zeta, stretch, rate, time);
            (DVec3::X * (self.rest_length + x), DVec3::X * v)
        })
    }

    /// On a circle: the spring's pull is the centripetal force, μ Ω² R = k (R − L), R in m and above L.
    ///
    /// l̇ = 0, so damping changes nothing.
    #[must_use]
    pub fn circular(self, radius: f64) -> Problem {
        let rotation = self.orbital_frequency(radius);
        self.problem("two bodies, circular orbit".into(), move |time| {
            let (sine, cosine) = (rotation * time).sin_cos();
            let arm = DVec3::new(cosine, sine, 0.0);
            let along = DVec3::new(-sine, cosine, 0.0);
            (radius * arm, radius * rotation * along)
        })
    }

    /// Ω = √(k (R − L)/(μ R)), rad/s, on a circle of radius R in m.
    #[must_use]
    pub fn orbital_frequency(&self, radius: f64) -> f64 {
        (self.stiffness * (radius - self.rest_length) / (self.reduced_mass() * radius)).sqrt()
    }

    /// κ = √(k/μ + 3Ω²), rad/s: how fast a slightly disturbed circle breathes.
    ///
    /// The effective potential ½k(r − L)² + J²/(2μr²) has the curvature k + 3J²/(μR⁴) at R, and J = μR²Ω.
    #[must_use]
    pub fn epicyclic_frequency(&self, radius: f64) -> f64 {
        let rotation = self.orbital_frequency(radius);
        (self.stiffness / self.reduced_mass() + 3.0 * rotation * rotation).sqrt()
    }

    /// Rest length 0: the force −k r is linear, so r = r₀ cos ωt + (v₀/ω) sin ωt in all three dimensions.
    ///
    /// `separation` in m and `rate` in m/s at the start; not parallel, or r passes through 0.
    /// The rest length is taken as 0 and the damping too: damping along d̂ alone would not be linear.
    #[must_use]
    pub fn harmonic(self, separation: [f64; 3], rate: [f64; 3]) -> Problem {
        let bodies = Self { rest_length: 0.0, damping: 0.0, ..self };
        let (r0, v0) = (DVec3::from(separation), DVec3::from(rate));
        let omega = bodies.frequency();
        bodies.problem("two bodies, rest length 0".into(), move |time| {
            let (sine, cosine) = (omega * time).sin_cos();
            (r0 * cosine + v0 / omega * sine, v0 * cosine - r0 * omega * sine)
        })
    }

    /// Puts the two bodies about their ballistic centre of mass; watched for three periods 2π/√(k/μ).
    fn problem(self, name: String, relative: impl Fn(f64) -> (DVec3, DVec3) + Send + Sync + 'static) -> Problem {
        let [m0, m1] = self.masses;
        let model = Model {
            particles: vec![build::free(m0), build::free(m1)],
            springs: vec![build::spring([0, 1], self.stiffness, self.damping, self.rest_length)],
            ..Model::default()
        };
        let duration = 3.0 * TAU / self.frequency();
        Problem::new(name, model, self.gravity, duration, move |time| {
            let (place, drift) = flight([0.0; 3], self.velocity, self.gravity, time);
            let (r, v) = relative(time);
            let [back, ahead] = [-m1 / (m0 + m1), m0 / (m0 + m1)];
            let body = |moment: Moment, part: f64| {
                moment.with((DVec3::from(place) + part * r).to_array(), (DVec3::from(drift) + part * v).to_array())
            };
            body(body(Moment::default(), back), ahead)
        })
        .turned(skew())
    }
}
