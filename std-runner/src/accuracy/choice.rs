//! What a run to an accuracy is made with.

use crate::scene::{CollisionForm, Precision, Settings, StepperName, TimeStep};

/// How much longer the steps of the coarser run of a pair are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ratio {
    /// As long: exact flight has no steps, and only the precision differs.
    One,
    /// 5/4, where stability allows no longer ones: it costs four fifths of the finer run.
    FiveFourths,
    /// 2, which costs half of the finer run.
    Two,
}

impl Ratio {
    /// Steps of the finer and of the coarser run that take the same time.
    #[must_use]
    pub fn steps(self) -> (u32, u32) {
        match self {
            Self::One => (1, 1),
            Self::FiveFourths => (5, 4),
            Self::Two => (2, 1),
        }
    }

    /// As a number.
    #[must_use]
    pub fn value(self) -> f64 {
        let (fine, coarse) = self.steps();
        f64::from(fine) / f64::from(coarse)
    }
}

/// A stepper, its precision and its time step, and the run beside it that tells its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// How both step.
    pub stepper: StepperName,
    /// Of the finer run, the one that counts.
    pub precision: Precision,
    /// Of the coarser.
    pub companion: Precision,
    /// How much coarser it is.
    pub ratio: Ratio,
    /// What happens at planes.
    pub collision: CollisionForm,
    /// The finer run's steps, s, to begin with.
    pub time_step: f64,
    /// The longest that are tried, s.
    pub longest: f64,
    /// The order of the stepper, as far as collisions let it be.
    pub order: u32,
    /// What it is expected to cost with its companion; [`step_cost`](super::step_cost) tells in what.
    pub cost: f64,
}

impl Choice {
    /// A scene's settings with these in place of its own.
    #[must_use]
    pub fn settings(&self, scene: &Settings) -> Settings {
        Settings {
            stepper: self.stepper,
            precision: self.precision,
            collision: self.collision,
            time_step: TimeStep::Seconds(self.time_step),
            ..scene.clone()
        }
    }
}
