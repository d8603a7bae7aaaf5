//! A flat grid of particles.

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

/// A flat grid of particles. Its springs are numbered: structural along u, structural along v, shear along u + v, shear
/// along v − u, bend along u, bend along v; each in the order of the numbers of the particles that they start from.
/// All are at rest at the start.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Cloth {
    /// Where its particle \[0, 0\] is, m.
    corner: [f64; 3],
    /// From the corner along the whole of side u, m.
    edge_u: [f64; 3],
    /// From the corner along the whole of side v, m.
    edge_v: [f64; 3],
    /// How many particles along u and along v, each 2 or more; particle \[i_u, i_v\] is number first + i_v * n_u + i_u.
    particles: [u32; 2],
    /// kg, of each particle, more than 0.
    #[serde(default = "one_kilogram")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    mass: f64,
    /// m/s, of every particle that is not pinned.
    #[serde(default)]
    velocity: [f64; 3],
    /// Springs to the neighbours along u and v. Left out: none.
    structural: Option<Law>,
    /// Springs to the neighbours along both diagonals. Left out: none.
    shear: Option<Law>,
    /// Springs to the second neighbours along u and v. Left out: none.
    bend: Option<Law>,
    /// What stays where it is: corners such as "u0v1", edges such as "u0", where i_u = 0, or particles \[i_u, i_v\].
    #[serde(default)]
    pinned: Vec<Selector<Part, 2>>,
}

/// A corner or an edge of a cloth.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "ClothPart")]
enum Part {
    /// The corner at the start of u and v.
    U0v0,
    /// The corner at the end of u and the start of v.
    U1v0,
    /// The corner at the start of u and the end of v.
    U0v1,
    /// The corner at the end of u and v.
    U1v1,
    /// The edge at the start of u.
    U0,
    /// The edge at the end of u.
    U1,
    /// The edge at the start of v.
    V0,
    /// The edge at the end of v.
    V1,
}

/// The neighbours that structural, shear and bend springs go to.
const STRUCTURAL: [[i32; 3]; 2] = [[1, 0, 0], [0, 1, 0]];
const SHEAR: [[i32; 3]; 2] = [[1, 1, 0], [-1, 1, 0]];
const BEND: [[i32; 3]; 2] = [[2, 0, 0], [0, 2, 0]];

impl Cloth {
    fn lattice(&self) -> Lattice {
        let [along_u, along_v] = self.particles;
        let sides = [DVec3::from(self.edge_u), DVec3::from(self.edge_v), DVec3::ZERO];
        Lattice { counts: [along_u, along_v, 1], corner: self.corner.into(), sides }
    }

    /// The springs that it has, in their order.
    fn families(&self) -> impl Iterator<Item = (Law, [i32; 3])> {
        let families = [(self.structural, STRUCTURAL), (self.shear, SHEAR), (self.bend, BEND)];
        families
            .into_iter()
            .filter_map(|(law, offsets)| Some((law?, offsets)))
            .flat_map(|(law, offsets)| offsets.map(|offset| (law, offset)))
    }

    fn pins(&self, u: u32, v: u32) -> bool {
        let (u0, v0) = (u == 0, v == 0);
        let (u1, v1) = (u == self.particles[0] - 1, v == self.particles[1] - 1);
        self.pinned.iter().any(|selector| match selector {
            Selector::At(place) => *place == [u, v],
            Selector::Named(Part::U0v0) => u0 && v0,
            Selector::Named(Part::U1v0) => u1 && v0,
            Selector::Named(Part::U0v1) => u0 && v1,
            Selector::Named(Part::U1v1) => u1 && v1,
            Selector::Named(Part::U0) => u0,
            Selector::Named(Part::U1) => u1,
            Selector::Named(Part::V0) => v0,
            Selector::Named(Part::V1) => v1,
        })
    }
}

impl Generator for Cloth {
    fn check(&self) -> Result<(), Problem> {
        checks::vector("corner", self.corner, "metres")?;
        checks::vector("edge_u", self.edge_u, "metres")?;
        checks::vector("edge_v", self.edge_v, "metres")?;
        checks::sides(self.particles)?;
        checks::positive("mass", self.mass, "kg")?;
        checks::vector("velocity", self.velocity, "m/s")?;
        for (key, law) in [("structural", self.structural), ("shear", self.shear), ("bend", self.bend)] {
            if let Some(law) = law {
                law.check().map_err(|problem| problem.inside(key))?;
            }
        }
        self.pinned.iter().enumerate().try_for_each(|(number, pinned)| pinned.check(number, self.particles))
    }

    fn size(&self) -> Size {
        let lattice = self.lattice();
        let springs = self.families().map(|(_, offset)| lattice.pair_count(offset)).sum();
        Size { particles: lattice.particle_count(), springs }
    }

    fn particles(&self, out: &mut Vec<ModelParticle>) {
        let common = Common { mass: self.mass, velocity: self.velocity };
        self.lattice().particles(common, |[u, v, _]| self.pins(u, v), out);
    }

    fn springs(&self, first: u32, out: &mut Vec<ModelSpring>) {
        let lattice = self.lattice();
        for (law, offset) in self.families() {
            lattice.springs(first, offset, law, out);
        }
    }
}
