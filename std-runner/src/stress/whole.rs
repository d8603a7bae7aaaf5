//! Everything that is measured of a scene, one after the other.

use std::sync::atomic::{AtomicBool, Ordering};

use super::battery::{Case, Effort, Tried, Verdict, bodies, of_scene, try_case};
use super::{Limit, Limits, Map, WORK, limits};
use crate::model::Model;
use crate::scene::{Settings, StepperName};
use crate::simulate::RunError;

/// What is to be measured.
#[derive(Clone, Debug)]
pub struct Ask {
    /// Only these steppers; all, if there are none.
    pub only: Vec<StepperName>,
    /// Of the battery.
    pub effort: Effort,
    /// Whether maps are wanted.
    pub maps: bool,
}

/// What was measured, of a scene or of the bodies beside it.
#[derive(Clone, Debug)]
pub struct Stressed {
    /// The scene's.
    pub name: String,
    /// Whether it is of a scene, and not of the bodies beside all.
    pub is_scene: bool,
    /// The largest stable steps; nothing where no spring pulls at a free particle.
    pub limits: Option<Limits>,
    /// One for each stepper that was asked for.
    pub maps: Vec<Map>,
    /// The battery.
    pub tried: Vec<Tried>,
    /// Whether it was ended before all was done: what there is holds.
    pub interrupted: bool,
}

/// How far it is.
#[derive(Clone, Copy, Debug)]
pub enum News<'a> {
    /// Limits are being looked for.
    Limits,
    /// One has been found.
    Limit(&'a Limit),
    /// A map is being drawn, so much of it is done, from 0 to 1.
    Map(StepperName, f64),
    /// References for the battery are being made.
    References,
    /// A case has been tried: the first is number 1.
    Tried(&'a Tried, usize, usize),
}

impl Stressed {
    fn nothing(name: String, is_scene: bool) -> Self {
        Self { name, is_scene, limits: None, maps: Vec::new(), tried: Vec::new(), interrupted: false }
    }

    /// Whether something went wrong in silence.
    #[must_use]
    pub fn has_defect(&self) -> bool {
        self.tried.iter().flat_map(|tried| &tried.runs).any(|run| run.judged.verdict == Verdict::Defect)
    }
}

/// Measures a scene, and tells how far it is.
///
/// # Errors
/// If the scene cannot be run in `f64`.
pub fn stress_scene(
    model: &Model,
    settings: &Settings,
    ask: &Ask,
    interrupted: &AtomicBool,
    tell: impl Fn(News<'_>) + Sync,
) -> Result<Stressed, RunError> {
    let mut stressed = Stressed::nothing(settings.name.clone(), true);
    tell(News::Limits);
    stressed.limits = limits(model, &ask.only, WORK, interrupted, |limit| tell(News::Limit(limit)))?;
    if ask.maps && stressed.limits.is_some() {
        for stepper in mapped(&ask.only) {
            let map = Map::of(model, settings, stepper, interrupted, |part| tell(News::Map(stepper, part)))?;
            stressed.maps.extend(map);
        }
    }
    tell(News::References);
    let cases = of_scene(model, settings, ask.effort, interrupted)?;
    battery(&mut stressed, cases.unwrap_or_default(), ask, interrupted, tell);
    Ok(stressed)
}

/// Measures the bodies beside all scenes.
pub fn stress_bodies(ask: &Ask, interrupted: &AtomicBool, tell: impl Fn(News<'_>) + Sync) -> Stressed {
    let mut stressed = Stressed::nothing("bodies whose motion is known".to_owned(), false);
    battery(&mut stressed, bodies(ask.effort.steps), ask, interrupted, tell);
    stressed
}

/// The steppers that have a map.
fn mapped(only: &[StepperName]) -> Vec<StepperName> {
    if only.is_empty() { vec![StepperName::SemiImplicitEuler] } else { only.to_vec() }
}

fn battery(
    stressed: &mut Stressed,
    cases: Vec<Case>,
    ask: &Ask,
    interrupted: &AtomicBool,
    tell: impl Fn(News<'_>) + Sync,
) {
    let count = cases.len();
    for (number, case) in (1..).zip(cases) {
        if interrupted.load(Ordering::Relaxed) {
            break;
        }
        let tried = try_case(case, &ask.only, ask.effort, interrupted);
        tell(News::Tried(&tried, number, count));
        stressed.tried.push(tried);
    }
    stressed.interrupted = interrupted.load(Ordering::Relaxed);
}
