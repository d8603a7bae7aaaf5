//! One hard case: a model, how it is stepped, and what is known of its motion.

use crate::bench::Vectors;
use crate::model::Model;
use crate::scene::CollisionForm;

/// Moments at which a case is looked at, evenly spaced, the last at its end; it has a multiple of so many steps.
pub const CHECKPOINTS: u64 = 4;

/// A model that is hard to step.
#[derive(Clone, Debug)]
pub struct Case {
    /// What is hard about it.
    pub group: Group,
    /// How hard.
    pub name: String,
    /// What is stepped. Nothing in it follows a track.
    pub model: Model,
    /// m/s²
    pub gravity: [f64; 3],
    /// s
    pub duration: f64,
    /// A multiple of 4, as it is looked at four times.
    pub steps: u64,
    /// What happens at planes.
    pub collision: CollisionForm,
    /// As many bounces as there can be, where that is known.
    pub most_hits: Option<u64>,
    /// What is known of it.
    pub known: Known,
}

/// What a case is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// As it is.
    AsItIs,
    /// Springs of very different stiffness.
    Stiffness,
    /// Particles of very different mass.
    Mass,
    /// Springs without length, or on the way to it.
    Collapse,
    /// Very short and very long steps.
    TimeStep,
    /// Far from the origin.
    Offset,
    /// Next to 0.
    Tiny,
    /// Many steps.
    Drift,
    /// Bounces, and rest.
    Bounces,
    /// Between two planes.
    Wedges,
    /// A damped oscillator.
    Oscillator,
}

/// What a run is judged by: nothing in it comes from the stepper.
#[derive(Clone, Debug)]
pub enum Known {
    /// Where all particles are, at each checkpoint.
    Motion {
        /// m
        positions: Vec<Vectors>,
        /// How far these may be wrong themselves, m.
        uncertainty: f64,
    },
    /// Kinetic, elastic and gravitational energy stay what they are: nothing is damped, and every bounce is elastic.
    Energy,
    /// Kinetic, elastic and gravitational energy do not grow: that is all.
    NoMoreEnergy,
    /// Energy stays what it is, and the sum of all m v: nothing pulls from outside.
    EnergyAndMomentum,
}

impl Group {
    /// As a person would say it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::AsItIs => "as it is",
            Self::Stiffness => "stiffness ratios",
            Self::Mass => "mass ratios",
            Self::Collapse => "springs without length",
            Self::TimeStep => "time steps",
            Self::Offset => "far from the origin",
            Self::Tiny => "numbers next to 0",
            Self::Drift => "drift",
            Self::Bounces => "bounces and rest",
            Self::Wedges => "wedges",
            Self::Oscillator => "oscillator",
        }
    }
}

impl Case {
    /// s
    #[must_use]
    pub fn time_step(&self) -> f64 {
        self.duration / self.steps as f64
    }
}

/// A multiple of the checkpoints, of about so many steps.
pub fn whole(steps: f64) -> u64 {
    CHECKPOINTS * ((steps / CHECKPOINTS as f64).ceil().max(1.0) as u64)
}
