//! Who is measured.

use std::fmt::{Display, Formatter, Result};

use crate::model::Model;
use crate::scene::{CollisionForm, Precision, Settings, StepperName};

/// A way to step a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Contender {
    /// How it steps.
    pub stepper: StepperName,
    /// Whether it chooses its steps by a tolerance; else they are all of one length.
    pub is_adaptive: bool,
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
        let steppers = StepperName::ALL.iter().copied().filter(|stepper| !is_damped || stepper.knows_damping());
        let ways =
            steppers.flat_map(|stepper| [false, true].into_iter().map(move |is_adaptive| (stepper, is_adaptive)));
        let mut contenders = Vec::new();
        for (stepper, is_adaptive) in ways.filter(|(stepper, is_adaptive)| stepper.estimates_errors() || !is_adaptive) {
            // The other forms look for hits at the ends of steps, which have none of their own then.
            let answers = |form: &Option<CollisionForm>| form.is_none_or(|form| form == CollisionForm::TimeOfImpact);
            for precision in Precision::ALL.iter().copied() {
                let forms = forms.iter().copied().filter(|form| !is_adaptive || answers(form));
                contenders.extend(forms.map(|collision| Self { stepper, is_adaptive, precision, collision }));
            }
        }
        contenders
    }

    /// How it steps, by name.
    #[must_use]
    pub fn method(&self) -> String {
        let adaptive = if self.is_adaptive { " adaptive" } else { "" };
        format!("{}{adaptive}", self.stepper)
    }

    /// A scene's settings with these in place of its own, but for what runs are asked for.
    #[must_use]
    pub fn settings(&self, scene: &Settings) -> Settings {
        let Self { stepper, precision, collision, .. } = *self;
        Settings { stepper, precision, collision: collision.unwrap_or(scene.collision), ..scene.clone() }
    }
}

impl Display for Contender {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        write!(formatter, "{} {}", self.method(), self.precision)?;
        self.collision.map_or(Ok(()), |collision| write!(formatter, " {collision}"))
    }
}
