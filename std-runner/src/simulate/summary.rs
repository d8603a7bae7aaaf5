//! What a run tells of itself.

use std::time::Duration;

use hooke::{Balance, Choice, LinearSolver, Plan, Real, StabilityBound, StepError, StepReport, View, Workers};

use super::audit::Audit;
use super::run::{RunError, Start};
use super::schedule::Schedule;
use super::taken::Taken;
use super::threads::Threads;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending {
    /// It reached its duration.
    Finished,
    /// It was asked to stop.
    Interrupted,
    /// A step would have made a particle's state infinite or NaN.
    NonFinite {
        /// The first such particle by number.
        particle: u32,
    },
    /// A step could not be taken for another reason.
    Refused(StepError),
}

/// What happened in a run.
#[derive(Clone, Debug)]
pub struct Summary {
    /// How it ended.
    pub ending: Ending,
    /// The simulated time that it reached, s.
    pub time: f64,
    /// Its steps and frames, as planned.
    pub schedule: Schedule,
    /// Steps taken.
    pub steps: u64,
    /// Frames made.
    pub frames: u64,
    /// Threads that shared the work of each step.
    pub threads: u32,
    /// What the world needed, and so what was left out.
    pub plan: Plan,
    /// The stability bounds at the start.
    pub bound: Option<StabilityBound>,
    /// The time step, s; nothing where particles flew from frame to frame, and where the stepper chose its steps.
    pub time_step: Option<f64>,
    /// What `auto` chose, each choice that it made in the order in which it made them first.
    pub choices: Vec<Choice>,
    /// Time spent stepping.
    pub stepping: Duration,
    /// Time that stepping stood still for frames: to copy them, for room to put them, and for the last ones to be written.
    pub waiting: Duration,
    /// Time that recorders took, beside stepping.
    pub recording: Duration,
    /// The energy ledger, if it was kept.
    pub balance: Option<Balance>,
    /// The digest of the last state, if it was asked for: of positions and velocities as they are stepped, relative to the
    /// place in the middle of a scene far from the origin.
    pub digest: Option<u64>,
    /// Islands that slept at the end; the plan says how many there are.
    pub islands_asleep: u32,
    /// Steps that the stepper chose itself, bounces' own among them, without those taken again; 0 where it did not.
    pub parts: u64,
    /// Steps that it took again, shorter.
    pub rejected: u64,
    /// Bounces.
    pub hits: u64,
    /// Particles that were stopped on planes because their bounces were too many to follow.
    pub capped: u64,
    /// The most springs of length 0 in any step.
    pub degenerate_springs: u32,
    /// Evaluations of all forces.
    pub force_evaluations: u64,
    /// Newton iterations.
    pub iterations: u64,
    /// Iterations of the linear solver.
    pub linear_iterations: u64,
    /// Factorisations of its matrix.
    pub factorisations: u64,
    /// What solves the linear systems of whole steps, as known at the start; nothing for explicit steppers.
    pub linear_solver: Option<LinearSolver>,
    /// Steps whose equation was not solved to the tolerance.
    pub unconverged: u64,
    /// What the stepper and the collision form own besides the world, bytes.
    pub workspace: usize,
    /// The largest relative residual of any step.
    pub residual: f64,
}

impl Summary {
    /// Before the first step.
    pub(crate) fn before(start: Start) -> Self {
        Self {
            ending: Ending::Finished,
            time: 0.0,
            schedule: start.schedule,
            steps: 0,
            frames: 0,
            plan: start.plan,
            threads: 1,
            bound: start.bound,
            time_step: start.time_step,
            choices: Vec::new(),
            stepping: Duration::ZERO,
            waiting: Duration::ZERO,
            recording: Duration::ZERO,
            balance: None,
            digest: None,
            islands_asleep: 0,
            parts: 0,
            rejected: 0,
            hits: 0,
            capped: 0,
            degenerate_springs: 0,
            force_evaluations: 0,
            iterations: 0,
            linear_iterations: 0,
            factorisations: 0,
            linear_solver: start.linear_solver,
            unconverged: 0,
            workspace: 0,
            residual: 0.0,
        }
    }

    /// Adds what a step, or a part of one, reports.
    pub(crate) fn count(&mut self, report: &StepReport) {
        self.parts += u64::from(report.parts);
        self.rejected += u64::from(report.rejected);
        self.hits += u64::from(report.hits);
        self.capped += u64::from(report.capped);
        self.degenerate_springs = self.degenerate_springs.max(report.degenerate_springs);
        self.force_evaluations += u64::from(report.force_evaluations);
        self.iterations += u64::from(report.iterations);
        self.linear_iterations += u64::from(report.linear_iterations);
        self.factorisations += u64::from(report.factorisations);
        self.unconverged += u64::from(!report.converged);
        self.residual = self.residual.max(report.residual);
    }

    /// After the last step, which left the world as `view` shows it; `took` is all the time since the first.
    ///
    /// # Errors
    /// If a frame could not be written.
    pub(crate) fn close<R: Real>(
        &mut self,
        taken: Taken,
        took: Duration,
        threads: Option<&Threads>,
        view: &View<'_, R>,
        audit: Option<&Audit>,
    ) -> Result<(), RunError> {
        taken.result.map_err(|error| RunError::Record { error, frames: taken.frames })?;
        self.threads = threads.map_or(1, Workers::count);
        self.frames = taken.frames;
        self.waiting = taken.waiting;
        self.recording = taken.recording;
        self.stepping = took.saturating_sub(taken.waiting);
        self.time = view.time();
        self.islands_asleep = view.plan().islands_asleep;
        self.balance = audit.map(|audit| audit.balance(view));
        Ok(())
    }

    /// Whether the run is what was asked for.
    #[must_use]
    pub fn succeeded(&self) -> bool {
        self.ending == Ending::Finished && self.unconverged == 0
    }

    /// Time a spring and step, ns; nothing without springs.
    #[must_use]
    pub fn nanoseconds_per_spring_step(&self) -> Option<f64> {
        let steps = if self.parts > 0 { self.parts + self.rejected } else { self.steps };
        let spring_steps = f64::from(self.plan.springs) * steps as f64;
        (spring_steps > 0.0).then(|| self.stepping.as_secs_f64() * 1e9 / spring_steps)
    }
}
