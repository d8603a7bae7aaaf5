//! Two runs side by side, one in longer steps.

use hooke::{StepError, StepReport};

use super::choice::Ratio;
use super::frames::Frames;
use super::quintic::{Knot, quintic};
use super::side::{Saved, Side};
use crate::simulate::Stepped;

/// The run that counts, the one beside it, and the frames of the first.
pub(super) struct Pair<'a, R: Stepped, Q: Stepped> {
    pub(super) main: Side<'a, R>,
    pub(super) companion: Side<'a, Q>,
    pub(super) frames: Frames<R::Coordinate>,
    pub(super) ratio: Ratio,
    /// Whether motion is smooth within a step: nothing bounces.
    pub(super) is_smooth: bool,
    /// Whether what is interpolated may be worse than what is stepped.
    pub(super) sees_between: bool,
    pub(super) before: Vec<Knot>,
    pub(super) after: Vec<Knot>,
    /// Of the finer run after its steps that end within one of the coarser.
    pub(super) within: Vec<Vec<[f64; 3]>>,
    pub(super) places: [Vec<[f64; 3]>; 2],
}

/// Where a pair can come back to.
pub(super) struct SavedPair<R: Stepped, Q: Stepped> {
    main: Saved<R>,
    companion: Saved<Q>,
}

impl<R: Stepped, Q: Stepped> SavedPair<R, Q> {
    /// s
    pub(super) fn time(&self) -> f64 {
        self.main.time
    }
}

impl<R: Stepped, Q: Stepped> Pair<'_, R, Q> {
    /// Both up to a time (s), in so many rounds of the ratio's steps; the largest distance between a particle of one and
    /// of the other at the end, and within each step of the coarser, m.
    pub(super) fn advance(
        &mut self,
        to: f64,
        rounds: u32,
        count: &mut dyn FnMut(&StepReport),
    ) -> Result<f64, StepError> {
        let from = self.main.time;
        let mut difference = 0.0;
        for round in 1..=rounds {
            let end = if round == rounds { to } else { from + (to - from) * f64::from(round) / f64::from(rounds) };
            difference = farther(difference, self.round(end, count)?);
        }
        Ok(farther(difference, self.distance()))
    }

    /// One round of the ratio's steps, up to a time (s); what lies between the two within the steps, m.
    fn round(&mut self, to: f64, count: &mut dyn FnMut(&StepReport)) -> Result<f64, StepError> {
        let span = self.main.time..to;
        let (fine, coarse) = self.ratio.steps();
        let end_of = |step: u32, of: u32| {
            if step == of { to } else { span.start + (to - span.start) * f64::from(step) / f64::from(of) }
        };
        let sees_between = self.sees_between && self.is_smooth && !self.companion.has_keys_in(&span);
        self.within.resize(coarse as usize, Vec::new());
        for step in 1..=fine {
            self.main_step(end_of(step, fine), count)?;
            if sees_between && let Some(places) = self.within.get_mut(step as usize - 1) {
                self.main.positions(places);
            }
        }
        if !sees_between {
            (1..=coarse).try_for_each(|step| self.companion.step(end_of(step, coarse), &mut |_| ()))?;
            return Ok(0.0);
        }
        let mut difference = 0.0;
        self.companion.knots(&mut self.before);
        for (step, places) in (1..=coarse).zip(&self.within) {
            self.companion.step(end_of(step, coarse), &mut |_| ())?;
            self.companion.knots(&mut self.after);
            // The finer run's step of that number ends within this one, by so much of it.
            let part = f64::from(step) / self.ratio.value() - f64::from(step - 1);
            let length = (to - span.start) / f64::from(coarse);
            let curves = self.before.iter().zip(&self.after).map(|(start, end)| quintic(start, end, length, part).0);
            let distances = curves.zip(places).map(|(curve, place)| distance(curve, *place));
            difference = distances.fold(difference, farther);
            std::mem::swap(&mut self.before, &mut self.after);
        }
        Ok(difference)
    }

    fn distance(&mut self) -> f64 {
        let [main, companion] = &mut self.places;
        self.main.positions(main);
        self.companion.positions(companion);
        main.iter().zip(companion).map(|(one, other)| distance(*one, *other)).fold(0.0, farther)
    }

    /// One step of the run that counts, with its frames.
    fn main_step(&mut self, to: f64, count: &mut dyn FnMut(&StepReport)) -> Result<(), StepError> {
        let span = self.main.time..to;
        let (times, at_end) = self.frames.within(&span);
        if !self.frames.are_recorded() {
            self.frames.skip(times.len() + usize::from(at_end));
            return self.main.step(to, count);
        }
        if times.is_empty() {
            self.main.step(to, count)?;
        } else if self.is_smooth && !self.main.has_keys_in(&span) {
            self.main.knots(&mut self.before);
            self.main.step(to, count)?;
            self.main.knots(&mut self.after);
            let length = span.end - span.start;
            for time in times {
                let curves = self.before.iter().zip(&self.after);
                let part = (time - span.start) / length;
                self.frames.hold(curves.map(|(start, end)| quintic(start, end, length, part)));
            }
        } else {
            // Up to a hit motion is known by steps alone: some that lead nowhere else.
            let mut branch = self.main.branch();
            for time in times {
                branch.step(time, &mut |_| ())?;
                branch.show(&mut self.frames);
            }
            self.main.step(to, count)?;
        }
        if at_end {
            self.main.show(&mut self.frames);
        }
        Ok(())
    }

    pub(super) fn save(&self) -> SavedPair<R, Q> {
        SavedPair { main: self.main.save(), companion: self.companion.save() }
    }

    /// Back to where it was, with the frames since then taken back.
    pub(super) fn restore(&mut self, saved: &SavedPair<R, Q>) {
        self.main.restore(&saved.main);
        self.companion.restore(&saved.companion);
        self.frames.take_back(saved.time());
    }
}

fn distance(one: [f64; 3], other: [f64; 3]) -> f64 {
    one.iter().zip(other).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The larger; what is not a number is as far as can be.
fn farther(one: f64, other: f64) -> f64 {
    if one.is_nan() || other.is_nan() { f64::INFINITY } else { one.max(other) }
}
