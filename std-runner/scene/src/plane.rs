//! A plane that particles bounce on.

use glam::DVec3;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::model::ModelPlane;

use super::checks;
use super::error::Problem;

/// One plane; particles stay on the side that its normal points to.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Plane {
    /// Any point on it, m.
    point: [f64; 3],
    /// Its direction, of any length but 0.
    normal: [f64; 3],
    /// How much of the speed a bounce keeps: 0 for none to 1 for all of it.
    #[serde(default = "elastic")]
    #[schemars(extend("minimum" = 0, "maximum" = 1))]
    restitution: f64,
}

const fn elastic() -> f64 {
    1.0
}

impl Plane {
    pub(super) fn check(&self) -> Result<(), Problem> {
        checks::vector("point", self.point, "metres")?;
        checks::direction("normal", self.normal)?;
        checks::fraction("restitution", self.restitution)
    }

    pub(super) fn expand(&self) -> ModelPlane {
        let normal = DVec3::from(self.normal);
        // The square of a very short normal would be rounded to nothing.
        let normal = (normal / normal.abs().max_element()).normalize();
        ModelPlane { point: self.point, normal: normal.to_array(), restitution: self.restitution }
    }
}
