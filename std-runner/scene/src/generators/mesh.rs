//! Particles and springs from a mesh file.

use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::model::{ModelParticle, ModelSpring};

use super::super::checks;
use super::super::error::{Problem, SceneError};
use super::super::obj::Shape;
use super::super::particle::one_kilogram;
use super::super::read::{Source, Texts, Unreadable};
use super::super::size::Size;
use super::super::spring::Law;
use super::Generator;
use super::lattice::Common;

/// A mesh: every vertex becomes a particle, every edge of a face or a line one spring, at rest at the start.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MeshEntry {
    /// An OBJ file; its path is relative to the scene's folder.
    file: String,
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
    /// Springs between the two vertices across each edge that two triangles share; other polygons do not bend. They are
    /// numbered after the edges. Left out: none.
    bend: Option<Law>,
    /// The vertices that stay where they are, counted from 0 in the order of the file.
    #[serde(default)]
    pinned: Vec<u32>,
}

/// A mesh and the shape that its file holds.
#[derive(Clone, Debug)]
pub(crate) struct Mesh {
    entry: MeshEntry,
    shape: Shape,
}

impl MeshEntry {
    /// Reads the file of mesh number `index` of that scene, from the text that `text` gives of it.
    pub(crate) fn load(self, index: usize, scene: &Source, text: Texts<'_>) -> Result<Mesh, SceneError> {
        let refused = |rule: &str, remedy: &str| {
            scene.problem(Problem::new("file", &self.file, rule, remedy).inside_item("mesh", index))
        };
        let folder = scene.path().parent().unwrap_or(Path::new(""));
        let path = folder.join(&self.file);
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        if ending != "obj" {
            return Err(refused("only OBJ meshes are read, in files named `….obj`", "save the mesh as OBJ"));
        }
        let text = text(&path, "a mesh").map_err(|Unreadable { message, remedy }| {
            refused(
                &format!("{}: {message}", path.display()),
                &format!("{remedy}; paths are relative to the scene's folder"),
            )
        })?;
        let shape = Shape::parse(&path, &text)?;
        Ok(Mesh { entry: self, shape })
    }
}

impl Mesh {
    fn law(&self) -> Law {
        Law { stiffness: self.entry.stiffness, damping: self.entry.damping }
    }
}

impl Generator for Mesh {
    fn check(&self) -> Result<(), Problem> {
        checks::positive("mass", self.entry.mass, "kg")?;
        checks::vector("velocity", self.entry.velocity, "m/s")?;
        self.law().check()?;
        if let Some(bend) = self.entry.bend {
            bend.check().map_err(|problem| problem.inside("bend"))?;
        }
        let count = self.shape.vertices.len();
        for (number, &vertex) in self.entry.pinned.iter().enumerate() {
            if vertex as usize >= count {
                let rule = format!("the mesh has {count} vertices, numbers 0 to {}", count - 1);
                return Err(Problem::item("pinned", number, vertex, rule, "pin a vertex that exists"));
            }
        }
        Ok(())
    }

    fn size(&self) -> Size {
        let bends = self.entry.bend.map_or(0, |_| self.shape.across.len());
        Size { particles: self.shape.vertices.len() as u128, springs: (self.shape.edges.len() + bends) as u128 }
    }

    fn particles(&self, out: &mut Vec<ModelParticle>) {
        let start = out.len();
        let common = Common { mass: self.entry.mass, velocity: self.entry.velocity };
        out.extend(self.shape.vertices.iter().map(|&vertex| common.particle(vertex, false)));
        for &vertex in &self.entry.pinned {
            let particle = &mut out[start + vertex as usize];
            *particle = common.particle(particle.position, true);
        }
    }

    fn springs(&self, first: u32, out: &mut Vec<ModelSpring>) {
        let families = [(Some(self.law()), &self.shape.edges), (self.entry.bend, &self.shape.across)];
        for (law, pairs) in families.into_iter().filter_map(|(law, pairs)| Some((law?, pairs))) {
            out.extend(
                pairs.iter().map(|&pair| law.between(pair.map(|vertex| first + vertex), self.shape.length(pair))),
            );
        }
    }
}
