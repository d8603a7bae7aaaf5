//! A spring written out by itself.

use glam::DVec3;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::model::{ModelParticle, ModelSpring};

use super::checks;
use super::error::Problem;

/// One spring. Two springs between the same particles are allowed: their forces add up.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Spring {
    /// The numbers of the two particles that it joins.
    between: [u32; 2],
    /// N/m, 0 or more.
    #[schemars(extend("minimum" = 0))]
    stiffness: f64,
    /// N·s/m, 0 or more.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    damping: f64,
    /// m, 0 or more. Default: the distance between the two at the start.
    #[schemars(extend("minimum" = 0))]
    rest_length: Option<f64>,
}

impl Spring {
    /// In a scene of that many particles.
    pub(super) fn check(&self, particles: u64) -> Result<(), Problem> {
        checks::not_negative("stiffness", self.stiffness, "N/m")?;
        checks::not_negative("damping", self.damping, "N·s/m")?;
        if let Some(rest_length) = self.rest_length {
            checks::not_negative("rest_length", rest_length, "metres")?;
        }
        let between = |rule, remedy| Err(Problem::new("between", self.between, rule, remedy));
        if let Some(missing) = self.between.iter().find(|&&number| u64::from(number) >= particles) {
            let there_are = match particles {
                0 => "the scene has no particles".to_owned(),
                1 => "the scene has 1 particle, number 0".to_owned(),
                _ => format!("the scene has {particles} particles, numbers 0 to {}", particles - 1),
            };
            let rule = format!("there is no particle {missing}; {there_are}");
            return between(rule, "join two particles that exist, or add the one that is missing".to_owned());
        }
        if self.between[0] == self.between[1] {
            let rule = format!("it joins particle {} to itself", self.between[0]);
            return between(rule, "join two different particles".to_owned());
        }
        Ok(())
    }

    pub(super) fn expand(&self, particles: &[ModelParticle]) -> ModelSpring {
        let [from, to] = self.between.map(|number| particles[number as usize].position);
        ModelSpring {
            between: self.between,
            stiffness: self.stiffness,
            damping: self.damping,
            rest_length: self.rest_length.unwrap_or_else(|| distance(from, to)),
        }
    }
}

/// Between two points, m.
pub(super) fn distance(from: [f64; 3], to: [f64; 3]) -> f64 {
    (DVec3::from(to) - DVec3::from(from)).length()
}

/// A spring's law, for springs made by the hundred.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Law {
    /// N/m, 0 or more.
    #[schemars(extend("minimum" = 0))]
    pub(super) stiffness: f64,
    /// N·s/m, 0 or more.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub(super) damping: f64,
}

impl Law {
    pub(super) fn check(&self) -> Result<(), Problem> {
        checks::not_negative("stiffness", self.stiffness, "N/m")?;
        checks::not_negative("damping", self.damping, "N·s/m")
    }

    pub(super) fn between(&self, between: [u32; 2], rest_length: f64) -> ModelSpring {
        let Self { stiffness, damping } = *self;
        ModelSpring { between, stiffness, damping, rest_length }
    }
}
