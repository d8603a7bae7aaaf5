//! A straight row of particles, neighbours joined.

use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::{ModelParticle, ModelSpring};

use super::super::checks;
use super::super::error::Problem;
use super::super::particle::one_kilogram;
use super::super::size::Size;
use super::super::spring::Law;
use super::Generator;
use super::lattice::{Common, Lattice};

/// A straight row of evenly spaced particles; a spring joins each to the next, at rest at the start.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Rope {
    /// Where its first particle is, m.
    from: [f64; 3],
    /// Where its last particle is, m.
    to: [f64; 3],
    /// How many particles, 2 or more.
    #[schemars(extend("minimum" = 2))]
    particles: u32,
    /// kg, of each particle, more than 0.
    #[serde(default = "one_kilogram")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    mass: f64,
    /// m/s, of every particle that is not pinned.
    #[serde(default)]
    velocity: [f64; 3],
    /// N/m, 0 or more.
    #[schemars(extend("minimum" = 0))]
    stiffness: f64,
    /// N·s/m, 0 or more.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    damping: f64,
    /// Its ends that stay where they are.
    #[serde(default)]
    pinned: Vec<End>,
}

/// An end of a rope.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum End {
    /// Its first particle.
    First,
    /// Its last particle.
    Last,
}

impl Rope {
    fn lattice(&self) -> Lattice {
        let corner = DVec3::from(self.from);
        let sides = [DVec3::from(self.to) - corner, DVec3::ZERO, DVec3::ZERO];
        Lattice { counts: [self.particles, 1, 1], corner, sides }
    }

    fn law(&self) -> Law {
        Law { stiffness: self.stiffness, damping: self.damping }
    }
}

/// To the next particle.
const NEXT: [i32; 3] = [1, 0, 0];

impl Generator for Rope {
    fn check(&self) -> Result<(), Problem> {
        checks::vector("from", self.from, "metres")?;
        checks::vector("to", self.to, "metres")?;
        checks::count("particles", self.particles, 2)?;
        checks::positive("mass", self.mass, "kg")?;
        checks::vector("velocity", self.velocity, "m/s")?;
        self.law().check()
    }

    fn size(&self) -> Size {
        let lattice = self.lattice();
        Size { particles: lattice.particle_count(), springs: lattice.pair_count(NEXT) }
    }

    fn particles(&self, out: &mut Vec<ModelParticle>) {
        let last = self.particles - 1;
        let pinned = |[place, ..]: [u32; 3]| {
            self.pinned.iter().any(|end| match end {
                End::First => place == 0,
                End::Last => place == last,
            })
        };
        let common = Common { mass: self.mass, velocity: self.velocity };
        self.lattice().particles(common, pinned, out);
        if let Some(last) = out.last_mut() {
            // To the bit, where adding up the way there may round.
            last.position = self.to;
        }
    }

    fn springs(&self, first: u32, out: &mut Vec<ModelSpring>) {
        self.lattice().springs(first, NEXT, self.law(), out);
    }
}
