//! Hooke, run on a scene: one stepper, one response, one time step at a time.

use crate::measure;
use crate::moment::Moment;
use crate::problems::Problem;
use hooke::{Real, StepError, StepReport};
use hooke_runner::model::Model;
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_runner::simulate::{AnyResponse, AnyStepper, HeapWorld, world};

/// What implicit steppers solve to unless a run says otherwise: below every error that is measured of them.
pub const TOLERANCE: f64 = 1e-12;

/// A world on its way.
pub struct Run<R: Real> {
    /// The world.
    pub world: HeapWorld<R>,
    /// What steps it.
    pub stepper: AnyStepper<R>,
    /// What answers its collisions.
    pub response: AnyResponse<R>,
}

impl<R: Real> Run<R> {
    /// A scene at its start, under `gravity` in m/s².
    ///
    /// # Panics
    /// The model does not fit the precision.
    #[must_use]
    pub fn new(model: &Model, gravity: [f64; 3], stepper: StepperName, response: CollisionForm) -> Self {
        Self {
            world: world(model, gravity).expect("a model that fits its precision"),
            stepper: AnyStepper::named(stepper, TOLERANCE),
            response: AnyResponse::named(response),
        }
    }

    /// The same, with another tolerance for implicit steppers.
    #[must_use]
    pub fn with_tolerance(self, stepper: StepperName, tolerance: f64) -> Self {
        Self { stepper: AnyStepper::named(stepper, tolerance), ..self }
    }

    /// One step of `dt` in s.
    ///
    /// # Errors
    /// As the core says.
    pub fn try_step(&mut self, dt: f64) -> Result<StepReport, StepError> {
        self.world.step(self.stepper.any(), &mut self.response, R::from_f64(dt))
    }

    /// `count` steps of `dt` in s; returns their reports added up.
    ///
    /// # Panics
    /// One of them fails.
    pub fn steps(&mut self, count: usize, dt: f64) -> StepReport {
        let mut total = StepReport::default();
        for _ in 0..count {
            total.add(&self.try_step(dt).expect("a step that can be taken"));
        }
        total
    }

    /// Where all particles are, and how fast they go.
    pub fn moment(&mut self) -> Moment {
        let view = self.world.view();
        view.states().fold(Moment::default(), |moment, (position, velocity)| {
            let [x, v]: [[R::Coordinate; 3]; 2] = [position.into(), velocity.into()];
            moment.with(x.map(Real::to_f64), v.map(Real::to_f64))
        })
    }
}

/// The largest error in a position, m, at any of four evenly spaced times up to a part of the problem's duration, which
/// `count` steps lead to; `count` is a multiple of 4.
pub fn error<R: Real>(problem: &Problem, stepper: StepperName, part: f64, count: usize) -> f64 {
    let dt = part * problem.duration / count as f64;
    let mut run = Run::<R>::new(&problem.model, problem.gravity, stepper, CollisionForm::Reflect);
    (1..=4).fold(0.0, |largest: f64, quarter| {
        run.steps(count / 4, dt);
        let time = f64::from(quarter) * 0.25 * part * problem.duration;
        largest.max(measure::position_error(&run.moment(), &(problem.exact)(time)))
    })
}
