//! How a scene is run: everything in it that is not a particle, a spring or a plane.

use crate::model::CameraChoice;

use super::checks;
use super::error::Problem;
use super::max_error::MaxError;
use super::names::{CollisionForm, Precision, StepperName};
use super::time_step::TimeStep;

/// The settings of a scene, with its defaults filled in.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The scene's name, or its file's without the ending.
    pub name: String,
    /// m/s²; zero if the scene has none.
    pub gravity: [f64; 3],
    /// s, more than 0
    pub duration: f64,
    /// s, or chosen when the scene is prepared.
    pub time_step: TimeStep,
    /// Frames per second of simulated time, more than 0.
    pub frame_rate: f64,
    /// How the state is stepped.
    pub stepper: StepperName,
    /// What it is computed with.
    pub precision: Precision,
    /// The relative residual at which an implicit step counts as solved, or the largest error of a step of a stepper that
    /// chooses its steps, relative to the scene's size; more than 0.
    pub tolerance: f64,
    /// What happens at a plane.
    pub collision: CollisionForm,
    /// m/s, more than 0: islands slower than this for a second sleep. Nothing sleeps without it.
    pub sleep_speed: Option<f64>,
    /// How far off it may be at most; the stepper, the precision and the time step are then found for it.
    pub max_error: Option<MaxError>,
    /// Where the pictures are taken from.
    pub camera: CameraChoice,
}

/// s
pub(super) const DURATION: f64 = 1.0;
/// 1/s
pub(super) const FRAME_RATE: f64 = 60.0;
/// Relative.
pub(super) const TOLERANCE: f64 = 1e-6;

/// Pixels: from what can still be seen to what drawing can still hold.
const PICTURE_SIDE: std::ops::RangeInclusive<u32> = 16..=8192;

impl Settings {
    pub(super) fn check(&self) -> Result<(), Problem> {
        if self.name.chars().any(char::is_control) {
            let rule = "it must be one line of text, without control characters";
            return Err(Problem::new("name", &self.name, rule, "write a name such as \"hanging cloth\""));
        }
        checks::vector("gravity", self.gravity, "m/s²")?;
        checks::positive("duration", self.duration, "seconds")?;
        if let TimeStep::Seconds(seconds) = self.time_step {
            checks::positive("time_step", seconds, "seconds")?;
        }
        checks::positive("frame_rate", self.frame_rate, "frames per second")?;
        checks::positive("tolerance", self.tolerance, "residual or error, relative")?;
        if let Some(speed) = self.sleep_speed {
            checks::positive("sleep_speed", speed, "metres per second")?;
        }
        if let Some(MaxError { error, .. }) = self.max_error {
            checks::positive("max_error", error, "metres")?;
            if let TimeStep::Seconds(seconds) = self.time_step {
                let rule = "it must be left out, or \"auto\", where max_error is given: time steps are chosen for that";
                return Err(Problem::new("time_step", seconds, rule, "leave out one of the two"));
            }
        }
        check_camera(&self.camera).map_err(|problem| problem.inside("camera"))
    }
}

fn check_camera(camera: &CameraChoice) -> Result<(), Problem> {
    for (key, point) in [("position", camera.position), ("target", camera.target)] {
        if let Some(point) = point {
            checks::vector(key, point, "metres")?;
        }
    }
    if let (Some(position), Some(target)) = (camera.position, camera.target)
        && position == target
    {
        let rule = "it must not be where the camera itself is";
        return Err(Problem::new("target", target, rule, "move the target, or the camera's position"));
    }
    if let Some(up) = camera.up {
        checks::direction("up", up)?;
    }
    if let Some(angle) = camera.field_of_view
        && !(angle > 0.0 && angle < 180.0)
    {
        let rule = "it must be more than 0 and less than 180 degrees";
        return Err(Problem::new("field_of_view", angle, rule, "write an angle such as 40.0"));
    }
    if let Some(size) = camera.size
        && !size.iter().all(|side| PICTURE_SIDE.contains(side))
    {
        let rule = "both must be from 16 to 8192 pixels";
        return Err(Problem::new("size", size, rule, "write a width and a height such as [960, 720]"));
    }
    Ok(())
}
