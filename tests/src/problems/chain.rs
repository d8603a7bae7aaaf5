//! Equal masses on equal springs in a straight line, swinging in one of their modes along that line.
//!
//! The stiffness matrix is k tridiag(−1, 2, −1), with 1 in place of 2 beside a free end;
//! its eigenvectors are sines and cosines (Strang, "The Discrete Cosine Transform", SIAM Review 41, 1999).

use super::{Problem, build, harmonic, skew};
use crate::moment::Moment;
use hooke_runner::model::Model;
use std::f64::consts::{PI, TAU};

/// How the chain's two ends are held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// A spring to a pin at both ends.
    FixedFixed,
    /// A spring to a pin at the first mass.
    FixedFree,
    /// No pin.
    FreeFree,
}

/// A chain in one mode.
#[derive(Clone, Copy, Debug)]
pub struct Chain {
    /// How it is held.
    pub ends: Ends,
    /// N, how many masses move.
    pub masses: usize,
    /// m of each, kg
    pub mass: f64,
    /// k of each spring, N/m
    pub stiffness: f64,
    /// `k_d` of each spring, N·s/m
    pub damping: f64,
    /// L of each spring, m
    pub rest_length: f64,
    /// j, from 1 to N, or to N − 1 where both ends are free.
    pub mode: usize,
    /// The factor of the mode's shape at the start, m.
    pub displacement: f64,
    /// The factor of the mode's shape in the velocities at the start, m/s.
    pub velocity: f64,
}

impl Chain {
    /// A chain of `masses` in mode `mode`, with `damping` in N·s/m and k/m = 1000 s⁻².
    ///
    /// The swing is small: springs that push buckle, and any rounding off the line grows with their compression.
    #[must_use]
    pub fn new(ends: Ends, masses: usize, mode: usize, damping: f64) -> Self {
        Self {
            ends,
            masses,
            mass: 0.05,
            stiffness: 50.0,
            damping,
            rest_length: 0.1,
            mode,
            displacement: 0.002,
            velocity: 0.015,
        }
    }

    /// θ: half the phase from one mass to the next.
    fn half_phase(&self) -> f64 {
        let (n, j) = (self.masses as f64, self.mode as f64);
        match self.ends {
            Ends::FixedFixed => j * PI / (2.0 * (n + 1.0)),
            Ends::FixedFree => (2.0 * j - 1.0) * PI / (2.0 * (2.0 * n + 1.0)),
            Ends::FreeFree => j * PI / (2.0 * n),
        }
    }

    /// `ω_j` = 2√(k/m) sin θ, rad/s, with θ = jπ/(2(N+1)) fixed-fixed, (2j−1)π/(2(2N+1)) fixed-free, jπ/(2N) free-free.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        2.0 * (self.stiffness / self.mass).sqrt() * self.half_phase().sin()
    }

    /// `ζ_j` = `k_d` `ω_j`/(2k): the damping matrix is `k_d`/k times the stiffness matrix, so it mixes no modes.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        self.damping * self.frequency() / (2.0 * self.stiffness)
    }

    /// The mode's shape at mass i = 1 … N: sin 2iθ beside a pin, cos (2i − 1)θ where both ends are free.
    fn shape(&self, i: usize) -> f64 {
        let theta = self.half_phase();
        match self.ends {
            Ends::FixedFixed | Ends::FixedFree => (2.0 * i as f64 * theta).sin(),
            Ends::FreeFree => ((2.0 * i as f64 - 1.0) * theta).cos(),
        }
    }

    /// Mass i at i L + shape(i) × [`harmonic::motion`] with `ω_j` and `ζ_j`, watched for three periods.
    ///
    /// No spring may be so compressed that its length reaches 0.
    #[must_use]
    pub fn problem(self) -> Problem {
        let mut particles = vec![build::free(self.mass); self.masses];
        if self.ends != Ends::FreeFree {
            particles.insert(0, build::pinned());
        }
        if self.ends == Ends::FixedFixed {
            particles.push(build::pinned());
        }
        let springs =
            (1..particles.len()).map(|j| build::spring([j - 1, j], self.stiffness, self.damping, self.rest_length));
        // Particle 0 is mass 1 where there is no pin before it.
        let first = usize::from(self.ends == Ends::FreeFree);
        let places = first..first + particles.len();
        let model = Model { springs: springs.collect(), particles, ..Model::default() };
        let name = format!("chain of {}, {:?}, mode {}, damping {}", self.masses, self.ends, self.mode, self.damping);
        let duration = 3.0 * TAU / self.frequency();
        Problem::new(name, model, [0.0; 3], duration, move |time| {
            let (x, v) =
                harmonic::motion(self.frequency(), self.damping_ratio(), self.displacement, self.velocity, time);
            places.clone().fold(Moment::default(), |moment, i| {
                let pin = i == 0 || i > self.masses;
                let shape = if pin { 0.0 } else { self.shape(i) };
                let rest = i as f64 * self.rest_length;
                moment.with([rest + shape * x, 0.0, 0.0], [shape * v, 0.0, 0.0])
            })
        })
        .turned(skew())
    }
}
