//! Free particles, evenly spread.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::model::{ModelParticle, ModelSpring};

use super::super::checks;
use super::super::error::Problem;
use super::super::particle::one_kilogram;
use super::super::size::Size;
use super::Generator;
use super::lattice::Common;

/// Free particles, evenly spread over a box, at the same places on every machine.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Cloud {
    /// A corner of the box, m.
    corner: [f64; 3],
    /// From that corner to the one across, m.
    size: [f64; 3],
    /// How many, 1 or more.
    #[schemars(extend("minimum" = 1))]
    particles: u32,
    /// kg, of each particle, more than 0.
    #[serde(default = "one_kilogram")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    mass: f64,
    /// m/s, of every particle.
    #[serde(default)]
    velocity: [f64; 3],
}

/// The real root of p⁴ = p + 1: steps by its inverse powers fill a box without ever lining up.
const PLASTIC: f64 = 1.220_744_084_605_759_5;

impl Generator for Cloud {
    fn check(&self) -> Result<(), Problem> {
        checks::vector("corner", self.corner, "metres")?;
        checks::vector("size", self.size, "metres")?;
        checks::count("particles", self.particles, 1)?;
        checks::positive("mass", self.mass, "kg")?;
        checks::vector("velocity", self.velocity, "m/s")
    }

    fn size(&self) -> Size {
        Size { particles: self.particles.into(), springs: 0 }
    }

    fn particles(&self, out: &mut Vec<ModelParticle>) {
        let common = Common { mass: self.mass, velocity: self.velocity };
        let powers = [PLASTIC, PLASTIC * PLASTIC, PLASTIC * PLASTIC * PLASTIC];
        out.extend((0..self.particles).map(|number| {
            let along = |axis: usize| {
                let spread = 0.5 + (f64::from(number) + 1.0) / powers[axis];
                self.corner[axis] + self.size[axis] * (spread - spread.floor())
            };
            common.particle([along(0), along(1), along(2)], false)
        }));
    }

    fn springs(&self, _first: u32, _out: &mut Vec<ModelSpring>) {}
}
