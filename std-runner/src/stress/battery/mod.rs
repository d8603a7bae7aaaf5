//! Scenes and bodies that are hard on steppers, each run judged by something that the stepper has no part in.

mod bodies;
mod case;
mod conserved;
mod distance;
mod known;
mod observe;
mod runner;
mod scenes;
mod verdict;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use rayon::prelude::*;

use crate::model::Model;
use crate::scene::{Precision, Settings, StepperName};
use crate::simulate::RunError;
use crate::stress::steppers;

pub use bodies::bodies;
pub use case::{Case, Group, Known};
pub use distance::size;
pub use observe::{End, Moment, Observed, observe};
pub use runner::Runner;
pub use verdict::{Judged, Verdict, judge};

/// How long and how hard to look.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// A run that takes longer is ended.
    pub longest: Duration,
    /// 1, or by how much more steps are taken.
    pub steps: f64,
}

/// One run of a case.
#[derive(Clone, Debug)]
pub struct Run {
    /// Who.
    pub runner: Runner,
    /// What it is worth.
    pub judged: Judged,
    /// Time that it took, s.
    pub seconds: f64,
}

/// All runs of a case.
#[derive(Clone, Debug)]
pub struct Tried {
    /// Which.
    pub case: Arc<Case>,
    /// In the order of steppers and precisions.
    pub runs: Vec<Run>,
}

/// All cases of a scene, nothing known yet of those that follow from it; nothing if it was interrupted.
///
/// # Errors
/// If the scene cannot be run.
pub fn of_scene(
    model: &Model,
    settings: &Settings,
    effort: Effort,
    interrupted: &AtomicBool,
) -> Result<Option<Vec<Case>>, RunError> {
    let start = scenes::Start::of(model, settings, effort.steps);
    let Some(itself) = start.as_it_is().with_known(interrupted)? else { return Ok(None) };
    let mut cases = start.derived(&itself.known);
    cases.insert(0, itself);
    for case in start.unknown() {
        let Some(case) = case.with_known(interrupted)? else { return Ok(None) };
        cases.push(case);
    }
    cases.sort_by_key(|case| case.group);
    Ok(Some(cases))
}

/// Runs a case by all that can step it, or by `only` those; as far as nobody interrupts.
pub fn try_case(case: Case, only: &[StepperName], effort: Effort, interrupted: &AtomicBool) -> Tried {
    let case = Arc::new(case);
    let runners: Vec<Runner> = steppers(&case.model, only)
        .flat_map(|stepper| Precision::ALL.iter().map(move |precision| Runner { stepper, precision: *precision }))
        .collect();
    let runs = runners.into_par_iter().filter_map(|runner| {
        let begun = Instant::now();
        let observed = observe(&case, runner, effort.longest, interrupted);
        let judged = judge(&case, runner.precision, &observed);
        let is_whole = !interrupted.load(Ordering::Relaxed) && !matches!(observed, Observed::Interrupted);
        is_whole.then(|| Run { runner, judged, seconds: begun.elapsed().as_secs_f64() })
    });
    let mut runs: Vec<Run> = runs.collect();
    blame_rounding(&mut runs);
    Tried { case, runs }
}

/// Says of a run that is wrong in one precision that the same steps are right in `f64`.
fn blame_rounding(runs: &mut [Run]) {
    let is_right = |run: &&Run| run.runner.precision == Precision::F64 && run.judged.verdict <= Verdict::Accurate;
    let right: Vec<StepperName> = runs.iter().filter(is_right).map(|run| run.runner.stepper).collect();
    for run in runs {
        let is_wrong = matches!(run.judged.verdict, Verdict::Wrong | Verdict::Exploded);
        if is_wrong && run.runner.precision != Precision::F64 && right.contains(&run.runner.stepper) {
            run.judged.reason += "; by rounding, for f64 is right";
        }
    }
}
