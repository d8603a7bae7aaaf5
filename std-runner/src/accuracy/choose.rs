//! What a run to an accuracy is made with.

use std::sync::atomic::AtomicBool;

use super::choice::{Choice, Ratio};
use super::cost::step_cost;
use super::estimate::Estimate;
use super::pace::aim;
use super::pilot::{FLIGHT_ROUNDING, Pilots, UNLIMITED, highest};
use super::shown::{Seen, Shown, show};
use crate::model::Model;
use crate::scene::{CollisionForm, MaxError, Precision, Settings, StepperName};
use crate::simulate::{RunError, Start};

/// Rounding may be this part of what was asked for; and this part of what may lie between two runs, where only the coarser
/// one rounds: to begin anew as rounding has grown costs far more than the other precision does.
const ROUNDING: (f64, f64) = (0.3, 0.02);

/// What was found.
pub(super) struct Chosen {
    pub(super) choice: Choice,
    /// What could have been taken too, the cheapest first.
    pub(super) others: Vec<Choice>,
    /// s of simulated time; 0 where there were no pilots.
    pub(super) prefix: f64,
    /// What it cost.
    pub(super) cost: f64,
    /// Of the scene, m.
    pub(super) size: f64,
}

/// The cheapest way to step a scene that is expected to keep to an accuracy; nothing if it was interrupted.
///
/// # Errors
/// If it cannot be run at all.
pub(super) fn choose(
    model: &Model,
    settings: &Settings,
    asked: &MaxError,
    interrupted: &AtomicBool,
) -> Result<Option<Chosen>, RunError> {
    let collision = asked.collision.unwrap_or(CollisionForm::TimeOfImpact);
    let settings = Settings { collision, ..settings.clone() };
    let start = Start::of::<f64>(model, &Settings { precision: Precision::F64, ..settings.clone() })?;
    let size = model.size();
    if start.plan.attached == 0 && collision == CollisionForm::TimeOfImpact && asked.stepper.is_none() {
        let choice = flight(model, &settings, asked, size);
        return Ok(Some(Chosen { choice, others: Vec::new(), prefix: 0.0, cost: 0.0, size }));
    }
    let pilots = Pilots::new(model, settings, start.bound, interrupted);
    Chooser { pilots, asked, size, choices: Vec::new() }.choose()
}

/// Free particles fly exactly; all there is to choose is what they round to.
fn flight(model: &Model, settings: &Settings, asked: &MaxError, size: f64) -> Choice {
    let suffices = FLIGHT_ROUNDING * size <= asked.error;
    let precision = asked.precision.unwrap_or(if suffices { Precision::F32 } else { Precision::F64 });
    let time_step = UNLIMITED * settings.duration;
    Choice {
        stepper: StepperName::Auto,
        precision,
        companion: other_precision(precision),
        ratio: Ratio::One,
        collision: settings.collision,
        time_step,
        longest: time_step,
        order: 2,
        cost: step_cost(StepperName::Auto, precision, model) / UNLIMITED,
    }
}

/// What exact flight is compared with.
pub(super) fn other_precision(precision: Precision) -> Precision {
    if precision == Precision::F64 { Precision::F32 } else { Precision::F64 }
}

struct Chooser<'a> {
    pilots: Pilots<'a>,
    asked: &'a MaxError,
    size: f64,
    choices: Vec<Choice>,
}

impl Chooser<'_> {
    fn choose(mut self) -> Result<Option<Chosen>, RunError> {
        let best = highest(self.pilots.model);
        match show(&mut self.pilots, self.asked.stepper.as_slice(), self.size)? {
            Seen::Steppers(shown) => shown.iter().for_each(|shown| self.consider(shown)),
            // Whatever is chosen will diverge as well, and say where.
            Seen::Diverged => {}
            Seen::Interrupted => return Ok(None),
        }
        let stepper = self.asked.stepper.unwrap_or(best);
        Ok(Some(self.chosen(stepper)))
    }

    /// The cheapest; a cautious one of that stepper if there is none.
    fn chosen(mut self, stepper: StepperName) -> Chosen {
        self.choices.sort_by(|one, other| one.cost.total_cmp(&other.cost));
        let choice = self.choices.first().copied().unwrap_or_else(|| self.cautious(stepper));
        let others = self.choices.into_iter().filter(|other| other.stepper != choice.stepper).collect();
        Chosen { choice, others, prefix: self.pilots.settings.duration, cost: self.pilots.cost, size: self.size }
    }

    /// Adds the ways in which a stepper may keep to what was asked for.
    fn consider(&mut self, shown: &Shown) {
        let asked = self.asked.error;
        // Of a low order a quarter of the step makes too little difference to read an error from.
        let ratios: &[Ratio] =
            if self.pilots.order(shown.stepper) < 4 { &[Ratio::Two] } else { &[Ratio::Two, Ratio::FiveFourths] };
        for (precision, companion) in [
            (Precision::F32, Precision::F32),
            (Precision::F32Compensated, Precision::F32Compensated),
            (Precision::F64, Precision::F32),
            (Precision::F64, Precision::F64),
        ] {
            match self.asked.precision {
                Some(only) if only != precision => continue,
                // It is for machines that have no f64.
                None if precision == Precision::F32Compensated => continue,
                None if precision == Precision::F32 && shown.rounding > ROUNDING.0 * asked => continue,
                _ => {}
            }
            for ratio in ratios {
                let choice = self.choice(shown, precision, companion, *ratio);
                let drowns = shown.rounding > ROUNDING.1 * self.estimate(&choice).difference(asked);
                if !(drowns && precision != companion) {
                    self.choices.push(choice);
                }
            }
        }
    }

    fn estimate(&self, choice: &Choice) -> Estimate {
        Estimate::of(choice, self.size, !self.pilots.model.planes.is_empty())
    }

    fn choice(&self, shown: &Shown, precision: Precision, companion: Precision, ratio: Ratio) -> Choice {
        let &Shown { stepper, time_step, .. } = shown;
        let Pilots { model, duration, .. } = &self.pilots;
        let (order, longest) = (self.pilots.order(stepper), self.pilots.limit(stepper) / ratio.value());
        let collision = self.pilots.settings.collision;
        let mut choice =
            Choice { stepper, precision, companion, ratio, collision, time_step, longest, order, cost: f64::INFINITY };
        let allowed = aim(order) * self.estimate(&choice).difference(self.asked.error);
        let apart = ratio.value().powi(order as i32) - 1.0;
        let [first, likely] = shown.steps_for(allowed / apart, order).map(|step| step.min(longest));
        choice.time_step = first;
        let steps = duration / likely;
        let cost = |precision: Precision| step_cost(stepper, precision, model);
        choice.cost = steps * (cost(precision) + cost(companion) / ratio.value());
        choice
    }

    /// Where nothing is known.
    fn cautious(&self, stepper: StepperName) -> Choice {
        let time_step = 0.25 * self.pilots.limit(stepper);
        let precision = self.asked.precision.unwrap_or(Precision::F64);
        let cost = step_cost(stepper, precision, self.pilots.model) * self.pilots.duration / time_step;
        Choice {
            stepper,
            precision,
            companion: precision,
            ratio: Ratio::Two,
            collision: self.pilots.settings.collision,
            time_step,
            longest: time_step,
            order: self.pilots.order(stepper),
            cost: 1.5 * cost,
        }
    }
}
