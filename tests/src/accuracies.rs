//! Runs to an accuracy, what they really keep to, and the cheapest run with a fixed step that would have done.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

use hooke_runner::accuracy::{Aim, Aimed, Attained, Begin, aim, run, step_cost};
use hooke_runner::bench::{MOMENTS, Probed, Reference, State, position_error, probe, steps_of};
use hooke_runner::model::Model;
use hooke_runner::record::{BoxedRecorder, Frame, RecordError, Recorder, Sample};
use hooke_runner::scene::{CollisionForm, MaxError, Precision, Scene, Settings, StepperName, TimeStep};
use hooke_runner::simulate::{Options, Start, Summary, largest_stable_step, run as simulate};

use crate::scene_runs::Silent;

/// Times at which runs with a fixed step are judged: with fewer steps than there are moments, all fall on steps.
const CHECKPOINTS: u64 = 16;
/// Each fixed step is this part of the one before.
const FINER: f64 = 0.7;
/// No longer one is tried than this part of the bound.
const EDGE: f64 = 0.95;

/// A scene, and where everything in it really goes.
pub struct Known {
    /// Its name.
    pub name: String,
    /// Its particles, springs and planes.
    pub model: Model,
    /// How it is run.
    pub settings: Settings,
    /// What is trusted.
    pub reference: Reference,
    /// How far a run of fewer steps has been from it up to each of its moments, m: from where that is more than an error,
    /// nobody knows whether it is kept to.
    pub known: Vec<f64>,
}

/// A run to an accuracy.
pub struct Kept {
    /// The largest distance from the reference at any of its moments, m: up to when the run says that it held, if it does
    /// not hold to the end, and as long as the reference can tell.
    pub error: f64,
    /// What the run says of it.
    pub attained: Attained,
    /// What happened.
    pub summary: Summary,
}

impl Known {
    /// Of a scene file.
    ///
    /// # Panics
    /// If it cannot be run.
    #[must_use]
    pub fn of(path: &Path) -> Self {
        let scene = Scene::load(path).expect("a sound scene");
        let model = scene.model().expect("a scene that fits");
        let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        Self::new(name, model, scene.settings())
    }

    /// Of its parts.
    ///
    /// # Panics
    /// If it cannot be run.
    #[must_use]
    pub fn new(name: String, model: Model, settings: &Settings) -> Self {
        let settings = Settings { frame_rate: MOMENTS as f64 / settings.duration, ..settings.clone() };
        let reference = Reference::of(&model, &settings, &AtomicBool::new(false)).expect("a run");
        let reference = reference.expect("nobody interrupts it");
        let mut known = Self { name, model, settings, reference, known: Vec::new() };
        known.known = known.doubts();
        known
    }

    fn doubts(&self) -> Vec<f64> {
        let settings = Settings {
            stepper: StepperName::Dop853,
            precision: Precision::F64,
            collision: CollisionForm::TimeOfImpact,
            ..self.settings.clone()
        };
        let steps = MOMENTS * (FEWER * self.reference.steps as f64 / MOMENTS as f64).ceil() as u64;
        let ran = probe(&self.model, &settings, steps, MOMENTS, &AtomicBool::new(false)).expect("a run");
        // What cannot be run again is not known at all.
        let Probed::Finished(other) = ran else { return vec![f64::INFINITY; MOMENTS as usize] };
        let each =
            (1..=MOMENTS as usize).map(|count| position_error(&other.states[..count], &self.reference.states[..count]));
        each.collect()
    }

    /// The moments before which it is known whether this error (m) is kept to.
    fn judged(&self, error: f64) -> usize {
        self.known.partition_point(|doubt| *doubt < SURE * error)
    }

    /// Runs it to an accuracy.
    ///
    /// # Panics
    /// If it cannot be run.
    #[must_use]
    pub fn run(&self, asked: &MaxError) -> Kept {
        let states = Keep::default();
        let interrupted = AtomicBool::new(false);
        let options =
            Options { ledger: false, digest: false, threads: Some(1), interrupted: &interrupted, progress: &Silent };
        let ran = run(&self.model, &self.settings, asked, &states, &options).expect("a run");
        let within = ran.expect("nobody interrupts it");
        let states = std::mem::take(&mut *states.0.lock().expect("nobody panics with it"));
        let until = within.attained.held_until.unwrap_or(f64::INFINITY);
        let held = (until * MOMENTS as f64 / self.settings.duration).min(MOMENTS as f64) as usize;
        let held = held.min(self.judged(asked.error));
        assert_eq!(states.len() as u64, MOMENTS, "{}: a frame at every moment", self.name);
        let error = position_error(&states[..held], &self.reference.states[..held]);
        Kept { error, attained: within.attained, summary: within.summary }
    }

    /// Runs it with its stepper and its time step left open: what was found for it, and the largest distance from the reference
    /// at any moment, m, as far as it is known to a thousandth of the scene's size.
    ///
    /// # Panics
    /// If it cannot be run, or leaves nothing open.
    #[must_use]
    pub fn aimed(&self) -> (Aimed, f64) {
        let open = Settings { stepper: StepperName::Auto, time_step: TimeStep::Auto, ..self.settings.clone() };
        let settings = Settings { precision: Precision::F64, max_error: None, ..open };
        let interrupted = AtomicBool::new(false);
        let found = match aim(&self.model, &settings, &interrupted).expect("a run") {
            Aim::Found(aimed) => Some(*aimed),
            Aim::Given | Aim::Lost | Aim::Interrupted => None,
        };
        let aimed = found.expect("a scene that leaves something open, and that can be stepped");
        let error = self.ran(&aimed.settings, aimed.error);
        (aimed, error)
    }

    /// The largest distance from the reference (m) at any moment of a run with these settings, as far as `error` is known.
    ///
    /// # Panics
    /// If it cannot be run.
    #[must_use]
    pub fn ran(&self, settings: &Settings, error: f64) -> f64 {
        let states = Keep::default();
        let interrupted = AtomicBool::new(false);
        let options =
            Options { ledger: false, digest: false, threads: Some(1), interrupted: &interrupted, progress: &Silent };
        let begin = |start: &Start| states.begin::<f64>(start, settings);
        simulate::<f64>(&self.model, settings, begin, &options).expect("a run");
        let states = std::mem::take(&mut *states.0.lock().expect("nobody panics with it"));
        let judged = self.judged(error);
        position_error(&states[..judged], &self.reference.states[..judged])
    }

    /// The cheapest fixed stepper, precision and time step whose error is no more than each of `errors` (m), if there is
    /// one, and its cost as [`step_cost`] counts.
    #[must_use]
    pub fn cheapest(
        &self,
        errors: &[f64],
        precisions: &[Precision],
    ) -> Vec<Option<(StepperName, Precision, f64, f64)>> {
        let mut best = vec![None; errors.len()];
        // What is not known cannot be kept to.
        let errors: Vec<f64> = errors.iter().map(|error| error.max(self.reference.floor())).collect();
        if self.reference.floor() > 0.1 * self.reference.size {
            return best;
        }
        // The best first: what costs more by the steps it takes needs no run.
        for stepper in StepperName::ALL.iter().rev().copied().filter(|stepper| *stepper != StepperName::ExplicitEuler) {
            if !stepper.knows_damping() && self.model.damped_springs() > 0 {
                continue;
            }
            for precision in precisions {
                self.sweep(stepper, *precision, &errors, &mut best);
            }
        }
        best
    }

    fn sweep(
        &self,
        stepper: StepperName,
        precision: Precision,
        errors: &[f64],
        best: &mut [Option<(StepperName, Precision, f64, f64)>],
    ) {
        let collision = CollisionForm::TimeOfImpact;
        let settings = Settings { stepper, precision, collision, ..self.settings.clone() };
        let bound = Start::of::<f64>(&self.model, &settings).expect("a scene that f64 holds").bound;
        let limit = bound.map_or(f64::INFINITY, |bound| EDGE * largest_stable_step(stepper, &bound));
        let longest = limit.min(settings.duration / CHECKPOINTS as f64);
        let (mut steps, mut least) = (steps_of(settings.duration, longest, CHECKPOINTS), f64::INFINITY);
        loop {
            let cost = steps as f64 * step_cost(stepper, precision, &self.model);
            // Whatever it reaches with so many steps is reached for less.
            let costs_most = |found: &Option<(_, _, _, f64)>| found.is_some_and(|(.., other)| other <= cost);
            let wanted = best.iter().zip(errors).filter(|(found, error)| !costs_most(found) && **error < least).count();
            if wanted == 0 || steps > MOST_STEPS {
                return;
            }
            let ran = probe(&self.model, &settings, steps, CHECKPOINTS, &AtomicBool::new(false)).expect("a run");
            let error = match &ran {
                Probed::Finished(probe) => position_error(&probe.states, &self.reference.at(CHECKPOINTS)),
                _ => f64::INFINITY,
            };
            for (found, wanted) in best.iter_mut().zip(errors) {
                if error <= *wanted && !costs_most(found) {
                    *found = Some((stepper, precision, settings.duration / steps as f64, cost));
                }
            }
            if error >= least && least < 1e-3 * self.reference.size && precision != Precision::F64 {
                // Rounding has taken over.
                return;
            }
            least = least.min(error);
            let next = CHECKPOINTS * ((steps as f64 / FINER / CHECKPOINTS as f64).round() as u64);
            steps = next.max(steps + CHECKPOINTS);
        }
    }
}

/// A reference is known as far as one with this part of its steps is with it, within this part of an error.
const FEWER: f64 = 0.7;
const SURE: f64 = 0.2;

/// More steps are not worth the wait.
const MOST_STEPS: u64 = 400_000;

/// The last attempt's frames but the first, by moments.
#[derive(Default)]
struct Keep(Arc<Mutex<Vec<State>>>);

impl Begin for Keep {
    fn begin<S: Sample>(&self, _: &Start, _: &Settings) -> Result<Vec<BoxedRecorder<S>>, RecordError> {
        self.0.lock().expect("nobody panics with it").clear();
        Ok(vec![Box::new(Keep(Arc::clone(&self.0)))])
    }
}

impl<R: Sample> Recorder<R> for Keep {
    fn record(&mut self, frame: &Frame<'_, R>) -> Result<(), RecordError> {
        let wide = |vectors: &[[R; 3]]| vectors.iter().map(|vector| vector.map(R::to_f64)).collect();
        if frame.number > 0 {
            let state = State { positions: wide(frame.position), velocities: wide(frame.velocity) };
            self.0.lock().expect("nobody panics with it").push(state);
        }
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Ok(())
    }
}
