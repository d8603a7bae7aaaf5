//! A pair of runs from the start to the end, in steps as short as the error that it shows asks for.

use std::sync::atomic::Ordering;

use hooke::{StepError, StepReport};

use super::choice::Ratio;
use super::estimate::Estimate;
use super::pace::Pace;
use super::pair::{Pair, SavedPair};
use crate::record::Stopped;
use crate::scene::StepperName;
use crate::simulate::{Options, Stepped, Summary, largest_stable_step};

/// Blocks, of a few steps each, after which the stability bound is worked out anew: it costs a few force evaluations.
const BLOCKS_BETWEEN_BOUNDS: u32 = 32;
/// The part of the stability bound that steps may take: springs stretch on the way, and the Nyström and the splitting method
/// grow a little just below theirs.
pub(super) const MARGIN: f64 = 0.85;
/// An estimate beyond this part of what was asked for is too much: it is one.
const MARGIN_OF_ERROR: f64 = 0.8;
/// An error up to this part of what was asked for is well within: one can come back to here.
const WELL_WITHIN: f64 = 0.5;
/// So often one comes back to the same place.
const MOST_RETURNS: u32 = 2;
/// An error that has grown by more since half the time grows as errors of chaotic motion do.
const FAST: f64 = 5.0;
/// Beyond so many factors of such growth nothing is foreseen.
const MOST_GROWTH: f64 = 8.0;
/// Blocks after which a place to come back to is made: a copy of both worlds costs about as much as a step of one.
const BLOCKS_BETWEEN_SAVES: u32 = 4;

/// How a pair came to its end.
pub(super) enum Ended {
    /// It reached the duration.
    Finished,
    /// It was asked to stop.
    Interrupted,
    /// A frame could not be written.
    Stopped,
    /// The error got larger than what was asked for, wherever it went on from.
    Exceeded {
        /// What it is expected to be at the end in steps as they were at first, m.
        expected: f64,
    },
    /// A step could not be taken, wherever it went on from.
    Refused(StepError),
}

/// The pair, and what is known of its error.
pub(super) struct Attempt<'a, 'b, R: Stepped, Q: Stepped> {
    pub(super) pair: Pair<'a, R, Q>,
    pub(super) pace: Pace,
    pub(super) estimate: Estimate,
    pub(super) stepper: StepperName,
    /// m
    pub(super) asked: f64,
    /// s
    pub(super) duration: f64,
    /// Rounds of the ratio's steps in a block.
    pub(super) rounds: u32,
    /// Whether it ends where the error is more than was asked for and nothing helps, or goes on and says so.
    pub(super) gives_up: bool,
    pub(super) options: &'b Options<'b>,
    /// The largest error so far (m) at times (s).
    pub(super) errors: Vec<(f64, f64)>,
    /// When the error was within what was asked for last, s; nothing if it always was.
    pub(super) held_until: Option<f64>,
    /// How often it went back.
    pub(super) returns: u32,
    /// The shortest step and the longest, s.
    pub(super) time_steps: (f64, f64),
    /// Of a round of both runs.
    pub(super) round_cost: f64,
    /// Of all rounds so far.
    pub(super) cost: f64,
}

impl<R: Stepped, Q: Stepped> Attempt<'_, '_, R, Q> {
    /// Up to the end.
    pub(super) fn run(&mut self, summary: &mut Summary) -> Ended {
        self.steps(summary).unwrap_or(Ended::Stopped)
    }

    fn steps(&mut self, summary: &mut Summary) -> Result<Ended, Stopped> {
        self.first_frame();
        let mut saved = self.keep()?;
        let (mut returns, mut steps, mut pace) = (0, 0, self.pace);
        let mut blocks = 0;
        while self.pair.main.time < self.duration {
            if self.options.interrupted.load(Ordering::Relaxed) {
                self.pair.frames.hand_over()?;
                return Ok(Ended::Interrupted);
            }
            if self.pair.frames.have_stopped() {
                return Err(Stopped);
            }
            if blocks % BLOCKS_BETWEEN_BOUNDS == BLOCKS_BETWEEN_BOUNDS - 1 {
                self.renew_bound();
            }
            blocks += 1;
            let advanced = self.block(summary);
            let error = advanced.as_ref().map_or(f64::INFINITY, |difference| self.estimate.error(*difference));
            if error > MARGIN_OF_ERROR * self.asked && self.held_until.is_none() {
                if self.has_steps()
                    && returns < MOST_RETURNS
                    && (saved.time() < self.pair.main.time || advanced.is_err())
                {
                    returns += 1;
                    self.returns += 1;
                    self.pair.restore(&saved);
                    summary.steps = steps;
                    self.errors.retain(|(time, _)| *time <= saved.time());
                    let failed = self.pace.time_step();
                    self.pace = pace;
                    self.pace.come_back(error, failed);
                    continue;
                }
                if let Err(refused) = advanced {
                    return Ok(Ended::Refused(refused));
                }
                if self.gives_up {
                    return Ok(Ended::Exceeded { expected: self.expected(error) });
                }
                self.held_until = Some(self.errors.last().map_or(0.0, |(time, _)| *time));
            } else if let Err(refused) = advanced {
                return Ok(Ended::Refused(refused));
            }
            self.hear(error);
            let is_good = error <= WELL_WITHIN * self.asked || self.held_until.is_some();
            if is_good && (returns > 0 || blocks % BLOCKS_BETWEEN_SAVES == 0) || self.pair.frames.are_full() {
                saved = self.keep()?;
                (returns, steps, pace) = (0, summary.steps, self.pace);
            }
        }
        self.pair.frames.hand_over()?;
        Ok(Ended::Finished)
    }

    fn first_frame(&mut self) {
        let Pair { main, frames, .. } = &mut self.pair;
        main.show(frames);
    }

    /// From here on nothing before is taken back.
    fn keep(&mut self) -> Result<SavedPair<R, Q>, Stopped> {
        self.pair.frames.hand_over()?;
        Ok(self.pair.save())
    }

    fn block(&mut self, summary: &mut Summary) -> Result<f64, StepError> {
        let from = self.pair.main.time;
        let (fine, _) = self.pair.ratio.steps();
        let length = self.pace.time_step() * f64::from(fine);
        let left = self.duration - from;
        let rounds = (left / length).ceil().clamp(1.0, f64::from(self.rounds));
        let to = match (left / (length * rounds)).ceil() {
            blocks if blocks <= 1.0 => self.duration,
            // The last two share what is left.
            2.0 => from + 0.5 * left,
            _ => from + length * rounds,
        };
        let steps = f64::from(fine) * rounds;
        let time_step = (to - from) / steps;
        self.cost += rounds * self.round_cost;
        let difference = self.pair.advance(to, rounds as u32, &mut |report: &StepReport| summary.count(report))?;
        self.time_steps = (self.time_steps.0.min(time_step), self.time_steps.1.max(time_step));
        summary.steps += steps as u64;
        self.options.progress.reached(to, self.duration);
        Ok(difference)
    }

    /// Notes the error at the end of a block.
    fn hear(&mut self, error: f64) {
        let time = self.pair.main.time;
        let largest = self.errors.last().map_or(error, |(_, before)| error.max(*before));
        self.errors.push((time, largest));
        if self.has_steps() {
            self.pace.hear(largest, time);
        }
    }

    /// Whether shorter steps make errors smaller: exact flight has only rounding.
    fn has_steps(&self) -> bool {
        self.pair.ratio != Ratio::One
    }

    fn renew_bound(&mut self) {
        if let Some(bound) = self.pair.main.world.view().stability() {
            let longest = MARGIN * largest_stable_step(self.stepper, &bound) / self.pair.ratio.value();
            if longest > 0.0 {
                self.pace.limit(longest);
            }
        }
    }

    /// The error at the end (m), if it goes on to grow as it has since half the time that has passed: by a power of the time,
    /// or where that would be a high one, by the same factor in the same time.
    fn expected(&self, error: f64) -> f64 {
        let time = self.pair.main.time;
        let half = self.errors.iter().rfind(|(at, _)| *at <= 0.5 * time).map_or(0.0, |(_, error)| *error);
        let growth = if half > 0.0 { (error / half).max(2.0) } else { 2.0 };
        if growth > FAST {
            error * growth.powf(((self.duration - time) / (0.5 * time)).min(MOST_GROWTH))
        } else {
            error * (self.duration / time).powf(growth.log2())
        }
    }
}
