//! Settings that the command line puts in place of the scene's.

use super::error::SceneError;
use super::max_error::MaxError;
use super::names::{CollisionForm, Precision, StepperName};
use super::settings::Settings;
use super::time_step::TimeStep;

/// Flags named as the scene's keys; each one given wins over the scene.
#[derive(Clone, Debug, Default, PartialEq, clap::Args)]
pub struct Overrides {
    /// How long to simulate, s.
    #[arg(long, value_name = "SECONDS", value_parser = number, allow_negative_numbers = true)]
    pub duration: Option<f64>,
    /// The length of a step, s, or auto: dop853 and dormand-prince-rkn8 then choose their steps themselves, and where the stepper is auto too, both are found for errors below a thousandth of the scene's size.
    #[arg(long, value_name = "SECONDS|auto", allow_negative_numbers = true)]
    pub time_step: Option<TimeStep>,
    /// Frames per second of simulated time.
    #[arg(long, value_name = "RATE", value_parser = number, allow_negative_numbers = true)]
    pub frame_rate: Option<f64>,
    /// How the state is stepped.
    #[arg(long, value_name = "NAME")]
    pub stepper: Option<StepperName>,
    /// What the run computes with.
    #[arg(long, value_name = "NAME")]
    pub precision: Option<Precision>,
    /// The relative residual at which an implicit step counts as solved, or the largest error of a step that is chosen.
    #[arg(long, value_name = "RELATIVE", value_parser = number, allow_negative_numbers = true)]
    pub tolerance: Option<f64>,
    /// How far any particle may be from where it should be, m: the stepper, the precision and the time step are found for that, but for those that have a flag.
    #[arg(long, value_name = "METRES", value_parser = number, allow_negative_numbers = true)]
    pub max_error: Option<f64>,
    /// What happens at a plane.
    #[arg(long, value_name = "FORM")]
    pub collision: Option<CollisionForm>,
    /// Let islands slower than this for a second sleep, m/s.
    #[arg(long, value_name = "SPEED", value_parser = number, allow_negative_numbers = true)]
    pub sleep_speed: Option<f64>,
    /// Gravity, m/s², such as 0,0,-9.81.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub gravity: Option<[f64; 3]>,
}

impl Overrides {
    /// The accuracy asked for, given the one of the scene: what has a flag is not chosen for it, and a time step ends it.
    fn max_error(&self, of_scene: Option<MaxError>) -> Option<MaxError> {
        let stepper = self.stepper.filter(|stepper| *stepper != StepperName::Auto);
        if let Some(error) = self.max_error {
            return Some(MaxError { error, stepper, precision: self.precision, collision: self.collision });
        }
        let scene = of_scene.filter(|_| !matches!(self.time_step, Some(TimeStep::Seconds(_))))?;
        Some(MaxError {
            error: scene.error,
            stepper: if self.stepper.is_some() { stepper } else { scene.stepper },
            precision: self.precision.or(scene.precision),
            collision: self.collision.or(scene.collision),
        })
    }
}

impl Settings {
    /// The settings with the overrides in place, or the flag that is wrong.
    pub(super) fn with(&self, overrides: &Overrides) -> Result<Self, SceneError> {
        let settings = Self {
            duration: overrides.duration.unwrap_or(self.duration),
            // An accuracy that is asked for here takes the place of a time step that stands there.
            time_step: overrides.time_step.unwrap_or(match overrides.max_error {
                Some(_) => TimeStep::Auto,
                None => self.time_step,
            }),
            frame_rate: overrides.frame_rate.unwrap_or(self.frame_rate),
            stepper: overrides.stepper.unwrap_or(self.stepper),
            precision: overrides.precision.unwrap_or(self.precision),
            tolerance: overrides.tolerance.unwrap_or(self.tolerance),
            collision: overrides.collision.unwrap_or(self.collision),
            sleep_speed: overrides.sleep_speed.or(self.sleep_speed),
            max_error: overrides.max_error(self.max_error),
            gravity: overrides.gravity.unwrap_or(self.gravity),
            ..self.clone()
        };
        settings.check().map_err(super::error::Problem::of_flag)?;
        Ok(settings)
    }
}

fn number(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| format!("expected a number, found {text:?}"))
}

fn vector(text: &str) -> Result<[f64; 3], String> {
    let components: Vec<f64> = text.split(',').map(number).collect::<Result<_, _>>()?;
    components
        .try_into()
        .map_err(|_| format!("expected three numbers with commas between, such as 0,0,-9.81, found {text:?}"))
}
