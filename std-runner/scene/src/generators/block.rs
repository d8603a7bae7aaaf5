//! A solid grid of particles.

use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::{ModelParticle, ModelSpring};

use super::super::checks;
use super::super::error::Problem;
use super::super::particle::one_kilogram;
use super::super::selector::Selector;
use super::super::size::Size;
use super::super::spring::Law;
use super::Generator;
use super::lattice::{Common, Lattice};

/// A solid grid of particles; springs join each to its up to 26 neighbours along the axes, the diagonals of the faces
/// and the diagonals of the body, all at rest at the start. The springs of each direction are numbered together.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Block {
    /// Where its particle \[0, 0, 0\] is, m.
    corner: [f64; 3],
    /// From the corner to the one across, m.
    size: [f64; 3],
    /// How many along x, y and z, each 2 or more; particle \[i_x, i_y, i_z\] is number
    /// first + (i_z * n_y + i_y) * n_x + i_x.
    particles: [u32; 3],
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
    /// What stays where it is: faces such as "z0", where i_z = 0, or particles \[i_x, i_y, i_z\].
    #[serde(default)]
    pinned: Vec<Selector<Face, 3>>,
}

/// A face of a block.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "BlockFace")]
enum Face {
    /// The face at the start of x.
    X0,
    /// The face at the end of x.
    X1,
    /// The face at the start of y.
    Y0,
    /// The face at the end of y.
    Y1,
    /// The face at the start of z.
    Z0,
    /// The face at the end of z.
    Z1,
}

/// To half of the 26 neighbours; the other half is the same springs from their other ends.
const NEIGHBOURS: [[i32; 3]; 13] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [1, 1, 0],
    [-1, 1, 0],
    [1, 0, 1],
    [-1, 0, 1],
    [0, 1, 1],
    [0, -1, 1],
    [1, 1, 1],
    [-1, 1, 1],
    [1, -1, 1],
    [-1, -1, 1],
];

impl Block {
    fn lattice(&self) -> Lattice {
        let [x, y, z] = self.size;
        let sides = [DVec3::X * x, DVec3::Y * y, DVec3::Z * z];
        Lattice { counts: self.particles, corner: self.corner.into(), sides }
    }

    fn law(&self) -> Law {
        Law { stiffness: self.stiffness, damping: self.damping }
    }

    fn pins(&self, place: [u32; 3]) -> bool {
        let starts = |axis: usize| place[axis] == 0;
        let ends = |axis: usize| place[axis] == self.particles[axis] - 1;
        self.pinned.iter().any(|selector| match selector {
            Selector::At(pinned) => *pinned == place,
            Selector::Named(Face::X0) => starts(0),
            Selector::Named(Face::X1) => ends(0),
            Selector::Named(Face::Y0) => starts(1),
            Selector::Named(Face::Y1) => ends(1),
            Selector::Named(Face::Z0) => starts(2),
            Selector::Named(Face::Z1) => ends(2),
        })
    }
}

impl Generator for Block {
    fn check(&self) -> Result<(), Problem> {
        checks::vector("corner", self.corner, "metres")?;
        checks::vector("size", self.size, "metres")?;
        checks::sides(self.particles)?;
        checks::positive("mass", self.mass, "kg")?;
        checks::vector("velocity", self.velocity, "m/s")?;
        self.law().check()?;
        self.pinned.iter().enumerate().try_for_each(|(number, pinned)| pinned.check(number, self.particles))
    }

    fn size(&self) -> Size {
        let lattice = self.lattice();
        let springs = NEIGHBOURS.iter().map(|&offset| lattice.pair_count(offset)).sum();
        Size { particles: lattice.particle_count(), springs }
    }

    fn particles(&self, out: &mut Vec<ModelParticle>) {
        let common = Common { mass: self.mass, velocity: self.velocity };
        self.lattice().particles(common, |place| self.pins(place), out);
    }

    fn springs(&self, first: u32, out: &mut Vec<ModelSpring>) {
        let lattice = self.lattice();
        for offset in NEIGHBOURS {
            lattice.springs(first, offset, self.law(), out);
        }
    }
}
