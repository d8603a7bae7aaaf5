//! A scene from a file, with the flags of the command line in it.

use std::path::Path;
use std::time::Duration;

use hooke::{Compensated, Real};

use super::failure::Failure;
use super::print;
use crate::advice::{Advice, vanishing_time_step};
use crate::model::Model;
use crate::scene::{Overrides, Precision, Scene, Settings, Texts, TimeStep, text_of_file};
use crate::simulate::{BuildError, MOST, RunError, Start};
use crate::units::{count, counted};

/// A scene that can be run.
pub(super) struct Loaded {
    pub(super) scene: Scene,
    pub(super) model: Model,
}

impl Loaded {
    pub(super) fn load(path: &Path, overrides: &Overrides) -> Result<Self, Failure> {
        Self::of(path, overrides, &mut text_of_file)
    }

    /// Of texts, by their paths.
    pub(super) fn of(path: &Path, overrides: &Overrides, text: Texts<'_>) -> Result<Self, Failure> {
        let mut scene = Scene::of(path, text)?;
        scene.apply(overrides)?;
        if let TimeStep::Seconds(time_step) = scene.settings().time_step
            && vanishing_time_step(scene.settings(), time_step)
        {
            let message = format!("the time step of {time_step:e} s is outside what f32 can hold");
            return Err(Failure::input(message, "use --precision f64, or a time step nearer to 1 s"));
        }
        let model = scene.model()?;
        refuse_damping(scene.settings(), &model)?;
        Ok(Self { scene, model })
    }

    /// What is known before the first step, in the scene's own precision.
    pub(super) fn start(&self) -> Result<Start, Failure> {
        fn of<R: Real>(loaded: &Loaded) -> Result<Start, BuildError> {
            Start::of::<R>(&loaded.model, loaded.scene.settings())
        }
        let start = match self.scene.settings().precision {
            Precision::F32 => of::<f32>(self),
            Precision::F32Compensated => of::<Compensated>(self),
            Precision::F64 => of::<f64>(self),
        };
        let start = start.map_err(|error| out_of_range(&error))?;
        let settings = self.scene.settings();
        if start.schedule.is_countable() { Ok(start) } else { Err(endless(settings, &start)) }
    }
}

/// A stepper that knows no damping, and a scene that has some.
fn refuse_damping(settings: &Settings, model: &Model) -> Result<(), Failure> {
    let damped = model.damped_springs();
    if settings.stepper.knows_damping() || damped == 0 {
        return Ok(());
    }
    let message = format!(
        "{} is for scenes without damping, and {} of {} are damped",
        settings.stepper,
        count(damped as u64),
        counted(model.springs.len() as u64, "spring")
    );
    Err(Failure::input(message, "use --stepper dop853, or set their damping to 0"))
}

/// A run of more steps or frames than can be counted.
pub(super) fn endless(settings: &Settings, start: &Start) -> Failure {
    let Settings { duration, frame_rate, .. } = settings;
    let steps = start.time_step.map_or_else(String::new, |time_step| format!(" in steps of {time_step:?} s"));
    let message = format!(
        "a duration of {duration:?} s{steps}, at {frame_rate:?} frames per second, makes more steps or frames than can \
         be counted: {MOST}"
    );
    Failure::input(message, "use a shorter --duration, a longer --time-step, or a lower --frame-rate")
}

/// What the precision of the run cannot hold.
pub(super) fn out_of_range(error: &BuildError) -> Failure {
    let message = format!("{} cannot be stepped in this precision: {}", error.place, error.reason);
    Failure::input(message, "use --precision f64, or values nearer to 1")
}

/// A scene that could not be measured.
pub(super) fn not_measured(error: &RunError) -> Failure {
    match error {
        RunError::Build(error) => out_of_range(error),
        other => Failure::failed(other.to_string(), "run it alone first: hooke run SCENE"),
    }
}

/// `--longest`, in seconds.
pub(super) fn longest(seconds: f64) -> Result<Duration, Failure> {
    Duration::try_from_secs_f64(seconds).map_err(|error| {
        Failure::input(format!("--longest {seconds}: {error}"), "write a number of seconds, such as 1")
    })
}

/// One piece of advice, as a warning.
pub(super) fn warning(advice: &Advice) -> String {
    format!("warning: {}\n    help: {}", advice.message, advice.remedy)
}

/// Every piece, before a run.
pub(super) fn warn(advice: &[Advice]) {
    advice.iter().for_each(|advice| print::message(&warning(advice)));
}
