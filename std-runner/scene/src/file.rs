//! A scene as it is written: every key, its meaning and its default.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::model::CameraChoice;

use super::generators::{Block, Cloth, Cloud, MeshEntry, Rope};
use super::max_error::MaxError;
use super::names::{CollisionForm, Precision, StepperName};
use super::particle::Particle;
use super::plane::Plane;
use super::settings::{DURATION, FRAME_RATE, Settings, TOLERANCE};
use super::spring::Spring;
use super::time_step::TimeStep;

/// A scene for Hooke: particles joined by springs. Units are SI; every part is optional.
///
/// Particles are numbered from 0: those of `particle`, then those of ropes, cloths, blocks, clouds and meshes, each in
/// file order.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(title = "Hooke scene")]
pub(super) struct SceneFile {
    /// What the scene is called. Default: the file's name without its ending.
    pub(super) name: Option<String>,
    /// The acceleration of gravity, m/s².
    pub(super) gravity: [f64; 3],
    /// How long to simulate, s, more than 0.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub(super) duration: f64,
    /// The length of a step, s, more than 0, or "auto": "dop853" and "dormand-prince-rkn8" then choose their steps themselves,
    /// and where the stepper is "auto" too, both are found for errors below a thousandth of the scene's size.
    pub(super) time_step: TimeStep,
    /// Frames per second of simulated time, more than 0.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub(super) frame_rate: f64,
    /// How the state is stepped.
    pub(super) stepper: StepperName,
    /// The numbers that the run computes with.
    #[schemars(with = "Precision", extend("default" = "f32"))]
    pub(super) precision: Option<Precision>,
    /// Implicit steppers: the relative residual at which a step counts as solved. "dop853" and "dormand-prince-rkn8" where
    /// they choose their steps: the largest error of one, relative to the scene's size. More than 0.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub(super) tolerance: f64,
    /// The largest distance of any particle from where it should be, m, more than 0. The time step is then found for it, and
    /// so are the stepper, where it is "auto", and the precision, where it is left out.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub(super) max_error: Option<f64>,
    /// What happens to a particle that meets a plane.
    pub(super) collision: CollisionForm,
    /// Islands, the parts that springs connect, whose particles have all been slower than this for a second sleep:
    /// they stay where they are and cost nothing, until a keyframed particle that they hang on moves. m/s, more than 0.
    /// Default: nothing sleeps.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub(super) sleep_speed: Option<f64>,
    /// Where the pictures are taken from. What is left out is chosen to show everything.
    pub(super) camera: CameraChoice,
    /// Single particles.
    pub(super) particle: Vec<Particle>,
    /// Single springs.
    pub(super) spring: Vec<Spring>,
    /// Planes that particles bounce on.
    pub(super) plane: Vec<Plane>,
    /// Straight rows of particles, neighbours joined.
    pub(super) rope: Vec<Rope>,
    /// Flat grids of particles.
    pub(super) cloth: Vec<Cloth>,
    /// Solid grids of particles.
    pub(super) block: Vec<Block>,
    /// Free particles, evenly spread.
    pub(super) cloud: Vec<Cloud>,
    /// Particles and springs from the vertices and edges of a mesh file.
    pub(super) mesh: Vec<MeshEntry>,
}

impl Default for SceneFile {
    fn default() -> Self {
        Self {
            name: None,
            gravity: [0.0; 3],
            duration: DURATION,
            time_step: TimeStep::default(),
            frame_rate: FRAME_RATE,
            stepper: StepperName::default(),
            precision: None,
            max_error: None,
            tolerance: TOLERANCE,
            collision: CollisionForm::default(),
            sleep_speed: None,
            camera: CameraChoice::default(),
            particle: Vec::new(),
            spring: Vec::new(),
            plane: Vec::new(),
            rope: Vec::new(),
            cloth: Vec::new(),
            block: Vec::new(),
            cloud: Vec::new(),
            mesh: Vec::new(),
        }
    }
}

impl SceneFile {
    /// The settings, with `stem` for a name that is left out.
    pub(super) fn settings(&self, stem: &str) -> Settings {
        Settings {
            name: self.name.clone().unwrap_or_else(|| stem.to_owned()),
            gravity: self.gravity,
            duration: self.duration,
            time_step: self.time_step,
            frame_rate: self.frame_rate,
            stepper: self.stepper,
            precision: self.precision.unwrap_or_default(),
            tolerance: self.tolerance,
            collision: self.collision,
            sleep_speed: self.sleep_speed,
            max_error: self.max_error.map(|error| MaxError {
                error,
                stepper: Some(self.stepper).filter(|stepper| *stepper != StepperName::Auto),
                precision: self.precision,
                collision: Some(self.collision),
            }),
            camera: self.camera.clone(),
        }
    }
}
