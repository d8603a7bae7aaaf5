//! Whether the time step is one that the stepper can take.

use hooke::{Choice, Chosen, StabilityBound};

use super::{Advice, Subject, Topic};
use crate::model::Model;
use crate::scene::{Settings, StepperName, TimeStep};
use crate::simulate::{Start, choose_time_step, chooses_steps, largest_stable_step};
use crate::units::{seconds, times};

/// The spring and the particle that set a bound.
#[must_use]
pub fn limit_in_words(model: &Model, bound: &StabilityBound) -> String {
    let StabilityBound { spring, particle, .. } = *bound;
    let ends = model.springs.get(spring as usize).map_or_else(String::new, |spring| {
        let [first, second] = spring.between;
        format!(" between particles {first} and {second}, {} N/m", spring.stiffness)
    });
    format!("spring {spring} ({}) at particle {particle}", ends.trim_start())
}

/// Flags that make an unstable run a stable one.
#[derive(Clone, Debug, PartialEq)]
pub struct Remedy {
    /// An explicit stepper that can be stable here.
    pub stepper: StepperName,
    /// A time step for it.
    pub time_step: TimeStep,
}

impl Remedy {
    /// For a scene: its own stepper if that can be stable, semi-implicit Euler in place of the explicit one. What can choose
    /// its steps itself is to do so.
    #[must_use]
    pub fn of(settings: &Settings, start: &Start) -> Option<Self> {
        let stepper = match settings.stepper {
            StepperName::ExplicitEuler => StepperName::SemiImplicitEuler,
            other => other,
        };
        let settings = Settings { stepper, time_step: TimeStep::Auto, ..settings.clone() };
        let time_step = if chooses_steps(&settings) {
            TimeStep::Auto
        } else {
            TimeStep::Seconds(choose_time_step(&settings, &start.plan, start.bound.as_ref())?)
        };
        Some(Self { stepper, time_step })
    }

    /// The flags, as a person would type them; `--stepper` only where it changes.
    #[must_use]
    pub fn flags(&self, settings: &Settings) -> String {
        let stepper =
            if self.stepper == settings.stepper { String::new() } else { format!("--stepper {} ", self.stepper) };
        format!("{stepper}--time-step {}", self.time_step)
    }
}

/// A stepper that the user names, past its bound.
pub(super) fn unstable(subject: &Subject<'_>) -> Option<Advice> {
    let Subject { settings, start, .. } = subject;
    let (bound, time_step) = (start.bound?, start.time_step?);
    let limit = largest_stable_step(settings.stepper, &bound);
    // Explicit Euler grows slowly past its own: that is told elsewhere.
    if time_step <= limit || settings.stepper == StepperName::ExplicitEuler {
        return None;
    }
    let stepper = settings.stepper;
    let message = format!(
        "the time step of {} is {} the largest at which {stepper} is sure to be stable, {}, which {} sets: the run is \
         likely to blow up",
        seconds(time_step),
        times(time_step / limit),
        seconds(limit),
        limit_in_words(subject.model, &bound),
    );
    let remedy = Remedy::of(settings, start)?;
    let remedy = format!("use {}, or --stepper implicit-euler", remedy.flags(settings));
    Some(Advice { topic: Topic::UnstableTimeStep, message, remedy })
}

/// `auto` at a time step that no explicit stepper can take.
pub(super) fn implicit_fallback(subject: &Subject<'_>) -> Option<Advice> {
    let Subject { settings, start, .. } = subject;
    if settings.stepper != StepperName::Auto {
        return None;
    }
    let (bound, time_step) = (start.bound?, start.time_step?);
    if Choice::of(Some(bound), time_step).chosen != Chosen::ImplicitEuler {
        return None;
    }
    let message = format!(
        "auto will use implicit-euler, as the time step of {} is past every explicit stepper's bound ({} for \
         velocity-verlet, which {} sets): it is stable, but it damps fast motion, and each step takes longer",
        seconds(time_step),
        seconds(bound.velocity_verlet),
        limit_in_words(subject.model, &bound),
    );
    let remedy = Remedy::of(settings, start)?;
    let remedy = format!("to keep the energy, use {}", remedy.flags(settings));
    Some(Advice { topic: Topic::ImplicitFallback, message, remedy })
}
