//! The run itself: pilots, pairs of runs, and a new beginning where one is of no use.

use std::time::Instant;

use hooke::Compensated;

use super::attained::Attained;
use super::attempt::{Attempt, Ended};
use super::choice::{Choice, Ratio};
use super::choose::{Chosen, choose, other_precision};
use super::cost::step_cost;
use super::estimate::Estimate;
use super::frames::Frames;
use super::pace::Pace;
use super::pair::Pair;

use super::side::Side;
use crate::model::Model;
use crate::record::{BoxedRecorder, RecordError, Sample};
use crate::scene::{MaxError, Precision, Settings};
use crate::simulate::{Anchor, Ending, MOST, Options, RunError, Schedule, Start, Stepped, Summary, Threads, Tracks};

/// So often a run begins anew before it is carried to the end as it is.
const MOST_RESTARTS: u32 = 3;
/// Of what was asked for, where a run begins anew.
const AIM: f64 = 0.2;
/// Its steps become this much shorter then.
const SHORTENED: (f64, f64) = (0.2, 0.6);
/// Evaluations of all forces in a block at least, so that what is done between blocks costs little.
const BLOCK: f64 = 24.0;

/// Somebody who opens recordings: anew for each attempt, as a run that begins anew makes other frames.
pub trait Begin {
    /// The recorders of a run.
    ///
    /// # Errors
    /// If one of them cannot be opened.
    fn begin<S: Sample>(&self, start: &Start, settings: &Settings) -> Result<Vec<BoxedRecorder<S>>, RecordError>;
}

/// A run to an accuracy.
#[derive(Clone, Debug)]
pub struct Within {
    /// The scene's settings with what was chosen in their place.
    pub settings: Settings,
    /// What happened.
    pub summary: Summary,
    /// How far off it is.
    pub attained: Attained,
}

/// Runs a model so that no particle is farther from where it should be than was asked for, and records its frames.
///
/// # Errors
/// As [`crate::simulate::run`].
pub fn run(
    model: &Model,
    settings: &Settings,
    asked: &MaxError,
    begin: &impl Begin,
    options: &Options<'_>,
) -> Result<Option<Within>, RunError> {
    let began = Instant::now();
    let Some(chosen) = choose(model, settings, asked, options.interrupted)? else { return Ok(None) };
    let course = Course { model, scene: settings, asked, chosen: &chosen, options };
    let pilots = began.elapsed();
    let mut choice = chosen.choice;
    let mut cost = chosen.cost;
    for restarts in 0.. {
        // Exact flight has nothing to begin anew with once it is in f64.
        let is_best = choice.ratio == Ratio::One && choice.precision == asked.precision.unwrap_or(Precision::F64);
        let gives_up = restarts < MOST_RESTARTS && !is_best;
        let made = course.attempt(choice, gives_up, begin)?;
        if let Ended::Exceeded { expected } = made.ended {
            cost += made.cost;
            choice = finer(choice, asked, expected, model, settings.duration);
            // In steps so short another method may be the cheaper one.
            if let Some(other) =
                chosen.others.iter().find(|other| other.order > choice.order && other.cost < choice.cost)
            {
                choice = Choice { precision: choice.precision, companion: choice.companion, ..*other };
            }
            continue;
        }
        let mut summary = made.summary;
        summary.ending = match made.ended {
            Ended::Interrupted => Ending::Interrupted,
            Ended::Refused(hooke::StepError::NonFinite { particle }) => Ending::NonFinite { particle },
            Ended::Refused(error) => Ending::Refused(error),
            Ended::Finished | Ended::Stopped | Ended::Exceeded { .. } => Ending::Finished,
        };
        let attained = Attained {
            asked: asked.error,
            choice,
            others: chosen.others.clone(),
            estimate: made.estimate,
            held_until: made.held_until,
            time_steps: made.time_steps,
            returns: made.returns,
            restarts,
            prefix: chosen.prefix,
            pilots,
            cost: cost + made.cost,
        };
        return Ok(Some(Within { settings: choice.settings(settings), summary, attained }));
    }
    Ok(None)
}

/// What is chosen where a run got too far off, and would have been off by `expected` metres at its end.
fn finer(choice: Choice, asked: &MaxError, expected: f64, model: &Model, duration: f64) -> Choice {
    let change = (AIM * asked.error / expected).powf(1.0 / f64::from(choice.order)).clamp(SHORTENED.0, SHORTENED.1);
    let mut choice = Choice { time_step: choice.time_step * change, longest: choice.time_step * change, ..choice };
    // Rounding may have been what grew.
    choice.precision = asked.precision.unwrap_or(Precision::F64);
    if choice.ratio == Ratio::One {
        choice.companion = other_precision(choice.precision);
    } else {
        choice.companion = choice.precision;
        choice.ratio = Ratio::Two;
    }
    let steps = duration / choice.time_step;
    choice.cost = steps * step_cost(choice.stepper, choice.precision, model) * (1.0 + 1.0 / choice.ratio.value());
    choice
}

struct Course<'a> {
    model: &'a Model,
    scene: &'a Settings,
    asked: &'a MaxError,
    chosen: &'a Chosen,
    options: &'a Options<'a>,
}

/// One attempt, after its end.
struct Made {
    ended: Ended,
    summary: Summary,
    estimate: f64,
    held_until: Option<f64>,
    time_steps: (f64, f64),
    returns: u32,
    cost: f64,
}

impl Course<'_> {
    fn attempt(&self, choice: Choice, gives_up: bool, begin: &impl Begin) -> Result<Made, RunError> {
        match (choice.precision, choice.companion) {
            (Precision::F32, Precision::F64) => self.pair::<f32, f64>(choice, gives_up, begin),
            (Precision::F32, _) => self.pair::<f32, f32>(choice, gives_up, begin),
            (Precision::F32Compensated, _) => self.pair::<Compensated, Compensated>(choice, gives_up, begin),
            (Precision::F64, Precision::F64) => self.pair::<f64, f64>(choice, gives_up, begin),
            (Precision::F64, _) => self.pair::<f64, f32>(choice, gives_up, begin),
        }
    }

    fn pair<R: Stepped, Q: Stepped>(
        &self,
        choice: Choice,
        gives_up: bool,
        begin: &impl Begin,
    ) -> Result<Made, RunError> {
        let settings = choice.settings(self.scene);
        let start = Start::of::<R>(self.model, &settings)?;
        let schedule = Schedule::new(settings.duration, None, settings.frame_rate);
        if !start.schedule.is_countable() || schedule.frames() > MOST {
            return Err(RunError::Endless(Box::new(start)));
        }
        let threads = Threads::of(self.options.threads, &start.plan)?;
        let anchor = Anchor::of(self.model);
        let relative = anchor.relative(self.model);
        let tracks = Tracks::of(&relative);
        let recorders = begin.begin::<R::Coordinate>(&start, &settings).map_err(RunError::Begin)?;
        let frames = Frames::new(schedule, anchor, recorders, self.model.particles.len()).map_err(RunError::Thread)?;
        let pair: Pair<'_, R, Q> = Pair {
            main: Side::new(self.model, settings.clone(), &tracks, threads.as_ref(), self.options.ledger)?,
            companion: Side::new(self.model, settings.clone(), &tracks, threads.as_ref(), false)?,
            frames,
            ratio: choice.ratio,
            is_smooth: self.model.planes.is_empty() && settings.sleep_speed.is_none(),
            sees_between: choice.order >= 6,
            before: Vec::new(),
            after: Vec::new(),
            within: Vec::new(),
            places: [Vec::new(), Vec::new()],
        };
        let evaluations = step_cost(choice.stepper, Precision::F32, self.model);
        let (fine, coarse) = choice.ratio.steps();
        let mut attempt = Attempt {
            pair,
            pace: Pace::new(choice.time_step, choice.longest, choice.order, self.asked.error, settings.duration),
            estimate: Estimate::of(&choice, self.chosen.size, !self.model.planes.is_empty()),
            stepper: choice.stepper,
            asked: self.asked.error,
            duration: settings.duration,
            rounds: (BLOCK / (evaluations * f64::from(fine))).ceil() as u32,
            gives_up,
            options: self.options,
            errors: Vec::new(),
            held_until: None,
            returns: 0,
            time_steps: (f64::INFINITY, 0.0),
            round_cost: f64::from(fine) * step_cost(choice.stepper, choice.precision, self.model)
                + f64::from(coarse) * step_cost(choice.stepper, choice.companion, self.model),
            cost: 0.0,
        };
        let mut summary = Summary::before(Start { schedule, time_step: None, ..start });
        let began = Instant::now();
        let ended = match &threads {
            Some(threads) => threads.during(|| attempt.run(&mut summary)),
            None => attempt.run(&mut summary),
        };
        let Attempt { pair, errors, held_until, time_steps, returns, cost, .. } = attempt;
        let Pair { mut main, frames, .. } = pair;
        let taken = frames.finish();
        let audit = main.walk.audit.as_ref();
        summary.close(taken, began.elapsed(), threads.as_ref(), &main.world.view(), audit)?;
        summary.digest = self.options.digest.then(|| hooke_digest::of(&main.world.view()));
        let estimate = errors.last().map_or(0.0, |(_, error)| *error);
        Ok(Made { ended, summary, estimate, held_until, time_steps, returns, cost })
    }
}
