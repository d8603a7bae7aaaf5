//! What is told of steps and energies.

use hooke::{Balance, StepReport};

/// What happened in some steps.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HookeReport {
    /// The time after them, s.
    pub time: f64,
    /// The largest remaining residual of an implicit step, relative to the size of its terms.
    pub residual: f64,
    /// Steps that were taken.
    pub steps: u32,
    /// 1 if every equation was solved to the tolerance, as it always is where there are none; else 0.
    pub converged: u32,
    /// Newton iterations.
    pub iterations: u32,
    /// Iterations of the linear solver inside those.
    pub linear_iterations: u32,
    /// Factorisations of its matrix.
    pub factorisations: u32,
    /// Evaluations of all spring forces.
    pub force_evaluations: u32,
    /// Bounces on planes.
    pub hits: u32,
    /// Particles with too many hits to follow one by one: they were stopped until the end of their step.
    pub capped: u32,
    /// Springs of length 0, which have no direction and exerted no force, in the last evaluation.
    pub degenerate_springs: u32,
    /// 1 if a factor had no room in the workspace, and conjugate gradients took its place.
    pub without_factor: u32,
}

/// Where the energy is, and where it went, J.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HookeLedger {
    /// The sum of m v^2 / 2.
    pub kinetic: f64,
    /// The sum of k (l - l_rest)^2 / 2.
    pub elastic: f64,
    /// The sum of -m g.x.
    pub gravitational: f64,
    /// Since the ledger was opened.
    pub lost_to_damping: f64,
    /// In all bounces since then; putting a particle back on a plane counts with them.
    pub lost_in_impacts: f64,
    /// What it took since then to move kinematic particles against their springs.
    pub work_of_pins: f64,
    /// The first three when it was opened.
    pub opened_with: f64,
    /// What the stepper has added (positive) or lost (negative) since then: 0 for the exact solution. Whatever is changed from
    /// outside counts into it, until the ledger is opened anew.
    pub remainder: f64,
}

impl HookeReport {
    pub(crate) fn of(report: &StepReport, steps: u32, time: f64, without_factor: bool) -> Self {
        Self {
            time,
            residual: report.residual,
            steps,
            converged: u32::from(report.converged),
            iterations: report.iterations,
            linear_iterations: report.linear_iterations,
            factorisations: report.factorisations,
            force_evaluations: report.force_evaluations,
            hits: report.hits,
            capped: report.capped,
            degenerate_springs: report.degenerate_springs,
            without_factor: u32::from(without_factor),
        }
    }
}

impl HookeLedger {
    pub(crate) fn of(balance: &Balance) -> Self {
        Self {
            kinetic: balance.kinetic,
            elastic: balance.elastic,
            gravitational: balance.gravitational,
            lost_to_damping: balance.lost_to_damping,
            lost_in_impacts: balance.lost_in_impacts,
            work_of_pins: balance.work_of_pins,
            opened_with: balance.opened_with,
            remainder: balance.remainder(),
        }
    }
}
