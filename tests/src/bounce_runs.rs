//! Runs of scenes with planes, in `f64`.

use hooke::{Balance, Ledger, StepReport};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_runner::simulate::{AnyResponse, AnyStepper, HeapWorld, world};

use crate::moment::Moment;
use crate::problems::Problem;

/// What a run came to.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The state at the end.
    pub moment: Moment,
    /// What all steps reported together.
    pub report: StepReport,
    /// The energy ledger at the end.
    pub balance: Balance,
}

/// Runs a problem to `time` (s) in equal steps of about `dt`, with the ledger open.
///
/// # Panics
/// If the world cannot be made or a step fails.
#[must_use]
pub fn run(problem: &Problem, stepper: StepperName, collision: CollisionForm, dt: f64, time: f64) -> Outcome {
    let mut world: HeapWorld<f64> = world(&problem.model, problem.gravity).expect("the problem is sound");
    let mut stepper = AnyStepper::named(stepper, 1e-13);
    let mut response = AnyResponse::named(collision);
    let mut ledger = Ledger::open(&world.view());
    let mut report = StepReport::default();
    let steps = (time / dt).round().max(1.0);
    for step in 1..=steps as u64 {
        let (length, end) = (time / steps, time * step as f64 / steps);
        let taken = world.view().step_to(stepper.any(), &mut response, length, end, &mut ledger);
        report.add(&taken.expect("a finite step"));
    }
    let view = world.view();
    let (position, velocity) = view.states().map(|(x, v)| (x.to_array(), v.to_array())).unzip();
    Outcome { moment: Moment { position, velocity }, report, balance: ledger.balance(&view) }
}
