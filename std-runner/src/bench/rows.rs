//! Measurements as a table: a row for each run, as CSV, to write and to read again.

use std::io::Write;
use std::path::Path;

use super::Bench;
use super::asked::Asked;
use super::contender::Contender;
use super::kept::Kept;
use super::point::Point;
use super::stamp::Stamp;
use crate::scene::{CollisionForm, Precision, StepperName};

/// A table could not be written or read.
#[derive(Debug, thiserror::Error)]
#[error(transparent)]
pub struct RowError(#[from] csv::Error);

impl From<std::io::Error> for RowError {
    fn from(error: std::io::Error) -> Self {
        Self(error.into())
    }
}

/// One run. What a run does not have is left empty: one that diverged has no error.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
struct Row {
    scene: String,
    stamp: String,
    stepper: StepperName,
    precision: Precision,
    collision: Option<CollisionForm>,
    /// Of contenders that choose their steps.
    tolerance: Option<f64>,
    steps: u64,
    time_step: f64,
    error: Option<f64>,
    velocity_error: Option<f64>,
    energy_residual: Option<f64>,
    bounce_time_error: Option<f64>,
    penetration: Option<f64>,
    survived: f64,
    seconds: f64,
    force_evaluations: u64,
    iterations: u64,
    linear_work: u64,
    workspace: usize,
}

impl Row {
    fn new(bench: &Bench, contender: Contender, point: &Point) -> Self {
        let Contender { stepper, precision, collision, .. } = contender;
        let Point { steps, time_step, error, velocity_error, energy_residual, bounce_time_error, .. } = *point;
        let Point { penetration, survived, seconds, force_evaluations, iterations, linear_work, workspace, .. } =
            *point;
        let (scene, stamp) = (bench.name.clone(), bench.stamp.to_string());
        Self {
            scene,
            stamp,
            stepper,
            precision,
            collision,
            tolerance: point.asked.tolerance(),
            steps,
            time_step,
            error,
            velocity_error,
            energy_residual,
            bounce_time_error,
            penetration,
            survived,
            seconds,
            force_evaluations,
            iterations,
            linear_work,
            workspace,
        }
    }

    fn measured(self) -> (Contender, Point) {
        let Self {
            stepper,
            precision,
            collision,
            tolerance,
            steps,
            time_step,
            error,
            velocity_error,
            energy_residual,
            ..
        } = self;
        let Self { bounce_time_error, penetration, survived, seconds, force_evaluations, .. } = self;
        let Self { iterations, linear_work, workspace, .. } = self;
        let point = Point {
            asked: Asked::read(tolerance, steps),
            steps,
            time_step,
            error,
            velocity_error,
            energy_residual,
            bounce_time_error,
            penetration,
            survived,
            seconds,
            force_evaluations,
            iterations,
            linear_work,
            workspace,
        };
        (Contender { stepper, is_adaptive: tolerance.is_some(), precision, collision }, point)
    }
}

/// All runs of all scenes, below a line for each scene that says what its errors are measured against.
///
/// # Errors
/// If they cannot be written.
pub fn write_rows(benches: &[Bench], mut out: impl Write) -> Result<(), RowError> {
    for bench in benches {
        let reference = &bench.reference;
        writeln!(
            out,
            "# {}: errors (m) against dop853 in f64, {} steps, settled to {:e} m; growth {:e}",
            bench.name, reference.steps, reference.settled, reference.growth
        )?;
    }
    let mut writer = csv::Writer::from_writer(out);
    for bench in benches {
        for swept in &bench.swept {
            for point in &swept.points {
                writer.serialize(Row::new(bench, swept.contender, point))?;
            }
        }
    }
    Ok(writer.flush()?)
}

/// The runs in a table that have the same stamp, and how many others there are.
///
/// # Errors
/// If it is no such table.
pub fn kept(path: &Path, stamp: Stamp) -> Result<(Kept, usize), RowError> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path)?;
    let rows: Vec<Row> = reader.deserialize().collect::<Result<_, _>>()?;
    let stamp = stamp.to_string();
    let count = rows.len();
    let kept: Kept = rows.into_iter().filter(|row| row.stamp == stamp).map(Row::measured).collect();
    let others = count - kept.count();
    Ok((kept, others))
}
