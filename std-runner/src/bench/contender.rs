//! Who is measured.

use std::fmt::{Display, Formatter, Result};

use crate::model::Model;
use crate::scene::{CollisionForm, Precision, Settings, StepperName};

/// A way to step a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Contender {
    /// How it steps.
    pub stepper: StepperName,
    /// In which numbers.
    pub precision: Precision,
    /// What it does at planes; nothing where there are none.
    pub collision: Option<CollisionForm>,
}

impl Contender {
    /// All that can step a scene.
    pub(super) fn all(model: &Model) -> Vec<Self> {
        let is_damped = model.damped_springs() > 0;
        let forms: Vec<Option<CollisionForm>> = match model.planes.as_slice() {
            [] => vec![None],
            _ => CollisionForm::ALL.iter().copied().map(Some).collect(),
        };
        let mut contenders = Vec::new();
        for stepper in StepperName::ALL.iter().copied().filter(|stepper| !is_damped || stepper.knows_damping()) {
            for precision in Precision::ALL.iter().copied() {
                contenders.extend(forms.iter().map(|collision| Self { stepper, precision, collision: *collision }));
            }
        }
        contenders
    }

    /// A scene's settings with these in place of its own.
    #[must_use]
    pub fn settings(&self, scene: &Settings) -> Settings {
        let Self { stepper, precision, collision } = *self;
        Settings { stepper, precision, collision: collision.unwrap_or(scene.collision), ..scene.clone() }
    }
}

impl Display for Contender {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        write!(formatter, "{} {}", self.stepper, self.precision)?;
        self.collision.map_or(Ok(()), |collision| write!(formatter, " {collision}"))
    }
}
