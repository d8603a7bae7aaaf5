//! Bodies whose motion has a closed form: beside every scene, and the same for all.

mod balls;
mod oscillators;
mod wedges;

use super::case::{CHECKPOINTS, Case, Group, Known};
use crate::model::Model;
use crate::scene::CollisionForm;

/// All of them; `effort` is 1, or more to look longer.
pub fn bodies(effort: f64) -> Vec<Case> {
    let mut cases = balls::balls();
    cases.extend(wedges::wedges());
    cases.extend(oscillators::oscillators(effort));
    cases
}

/// A case of which all is known, in this many steps.
struct Body {
    group: Group,
    name: String,
    model: Model,
    gravity: [f64; 3],
    duration: f64,
    steps: u64,
}

impl Body {
    /// With the positions of all its particles over time (s).
    fn moving(self, position: impl Fn(f64) -> Vec<[f64; 3]>) -> Case {
        let time = |part: u64| self.duration * part as f64 / CHECKPOINTS as f64;
        let positions = (1..=CHECKPOINTS).map(|part| position(time(part))).collect();
        self.known(Known::Motion { positions, uncertainty: 0.0 })
    }

    fn known(self, known: Known) -> Case {
        let Self { group, name, model, gravity, duration, steps } = self;
        let collision = CollisionForm::TimeOfImpact;
        Case { group, name, model, gravity, duration, steps, collision, most_hits: None, known }
    }
}
