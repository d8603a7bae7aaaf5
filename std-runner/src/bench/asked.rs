//! What a run is asked for: so many steps, or errors of so much.

use std::fmt::{Display, Formatter, Result};

use crate::scene::{Settings, TimeStep};

/// The loosest and the tightest tolerance, as exponents.
const TOLERANCES: [u32; 2] = [2, 13];

/// What a run is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Asked {
    /// So many steps, each as long as the others.
    Steps(u64),
    /// Steps whose errors are at most 10 to the power of minus this of the scene's size.
    Tolerance(u32),
}

impl From<u64> for Asked {
    fn from(steps: u64) -> Self {
        Self::Steps(steps)
    }
}

impl Asked {
    /// What is asked first of a stepper that chooses its steps.
    pub(super) const LOOSEST: Self = Self::Tolerance(TOLERANCES[0]);

    /// Twice as many steps, or a tenth of the error; nothing where that would be below rounding.
    pub(super) fn finer(self) -> Option<Self> {
        match self {
            Self::Steps(steps) => steps.checked_mul(2).map(Self::Steps),
            Self::Tolerance(exponent) => (exponent < TOLERANCES[1]).then_some(Self::Tolerance(exponent + 1)),
        }
    }

    /// Relative; nothing where steps are given.
    #[must_use]
    pub fn tolerance(self) -> Option<f64> {
        match self {
            Self::Steps(_) => None,
            // Read from text, so that it is the number that its digits name.
            Self::Tolerance(exponent) => format!("1e-{exponent}").parse().ok(),
        }
    }

    /// As a table has it: the tolerance, or else the steps.
    pub(super) fn read(tolerance: Option<f64>, steps: u64) -> Self {
        tolerance.map_or(Self::Steps(steps), |tolerance| Self::Tolerance((-tolerance.log10()).round() as u32))
    }

    /// A scene's settings with this, and with so many evenly spaced frames.
    pub(super) fn settings(self, settings: &Settings, frames: u64) -> Settings {
        let (time_step, tolerance) = match self {
            Self::Steps(steps) => (TimeStep::Seconds(settings.duration / steps as f64), settings.tolerance),
            Self::Tolerance(_) => (TimeStep::Auto, self.tolerance().unwrap_or(settings.tolerance)),
        };
        Settings { time_step, tolerance, frame_rate: frames as f64 / settings.duration, ..settings.clone() }
    }
}

impl Display for Asked {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        match self {
            Self::Steps(steps) => write!(formatter, "{}", crate::units::counted(*steps, "step")),
            Self::Tolerance(exponent) => write!(formatter, "tolerance 1e-{exponent}"),
        }
    }
}
