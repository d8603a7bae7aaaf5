//! Chains in equilibrium under gravity: they must stay where they are.
//!
//! Statics of a string of point masses (Routh, "A Treatise on Analytical Statics", chapter X), with springs for links.

use super::{Problem, build, skew};
use crate::moment::Moment;
use glam::DVec3;
use hooke_runner::model::Model;

/// A chain of equal masses on equal springs, under gravity.
#[derive(Clone, Copy, Debug)]
pub struct Hanging {
    /// N, how many masses hang.
    pub masses: usize,
    /// m of each, kg
    pub mass: f64,
    /// k of each spring, N/m
    pub stiffness: f64,
    /// `k_d` of each spring, N·s/m: at rest it does nothing.
    pub damping: f64,
    /// `l_0` of each spring, m
    pub rest_length: f64,
    /// g, m/s², downwards
    pub gravity: f64,
}

impl Default for Hanging {
    fn default() -> Self {
        Self { masses: 8, mass: 0.05, stiffness: 60.0, damping: 0.0, rest_length: 0.1, gravity: 9.81 }
    }
}

impl Hanging {
    /// From one pin, straight down: spring i carries the N − i + 1 masses below it, so it is longer by
    /// (N − i + 1) m g/k, and the tip hangs N `l_0` + m g N (N + 1)/(2k) below the pin.
    #[must_use]
    pub fn hung(self) -> Problem {
        let weight = self.mass * self.gravity;
        let mut depth = 0.0;
        let mut places = vec![DVec3::ZERO];
        for i in 1..=self.masses {
            let carried = (self.masses - i + 1) as f64;
            depth += self.rest_length + carried * weight / self.stiffness;
            places.push(DVec3::new(0.0, 0.0, -depth));
        }
        self.at_rest("hanging chain", places, 1)
    }

    /// How far the tip of [`Self::hung`] is below its pin, m.
    #[must_use]
    pub fn depth(&self) -> f64 {
        let n = self.masses as f64;
        let weight = self.mass * self.gravity;
        n * self.rest_length + weight * n * (n + 1.0) / (2.0 * self.stiffness)
    }

    /// Between two pins level with each other, `span` m apart.
    ///
    /// All springs i = 0 … N share the horizontal tension H; the vertical one is `V_i` = m g (N/2 − i).
    /// With `T_i` = √(H² + `V_i`²), spring i spans H (`l_0`/`T_i` + 1/k) across and `V_i` (`l_0`/`T_i` + 1/k) down.
    /// H is where the spans add up.
    ///
    /// # Panics
    /// The span is so short that the middle spring of an odd number would have to push.
    #[must_use]
    pub fn slung(self, span: f64) -> Problem {
        let links = |tension: f64| {
            (0..=self.masses).map(move |i| {
                let upward = self.mass * self.gravity * (self.masses as f64 / 2.0 - i as f64);
                let total = tension.hypot(upward);
                let per_force = self.rest_length / total + 1.0 / self.stiffness;
                DVec3::new(tension * per_force, 0.0, -upward * per_force)
            })
        };
        let reach = |tension: f64| links(tension).map(|link| link.x).sum::<f64>();
        // The reach grows with the tension without end: double it until it is enough, then halve the interval to the last bit.
        let mut high = self.mass * self.gravity;
        while reach(high) < span {
            high *= 2.0;
        }
        let mut low = 0.0;
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if reach(middle) < span {
                low = middle;
            } else {
                high = middle;
            }
        }
        assert!(low > 0.0, "the chain hangs without any spring pushing");
        let places = links(high).scan(DVec3::ZERO, |place, link| {
            *place += link;
            Some(*place)
        });
        let places = std::iter::once(DVec3::ZERO).chain(places).collect();
        self.at_rest("slung chain", places, 2)
    }

    /// A pin at the first place, and at the last if `pins` is 2; no motion, watched for 1 s.
    fn at_rest(self, name: &str, places: Vec<DVec3>, pins: usize) -> Problem {
        let mut particles = vec![build::free(self.mass); places.len()];
        particles[0] = build::pinned();
        if pins == 2 {
            particles[places.len() - 1] = build::pinned();
        }
        let springs =
            (1..places.len()).map(|j| build::spring([j - 1, j], self.stiffness, self.damping, self.rest_length));
        let model = Model { springs: springs.collect(), particles, ..Model::default() };
        let gravity = [0.0, 0.0, -self.gravity];
        Problem::new(name, model, gravity, 1.0, move |_| Moment {
            position: places.iter().map(DVec3::to_array).collect(),
            velocity: vec![[0.0; 3]; places.len()],
        })
        .turned(skew())
    }
}
