//! What a step tells of itself.

/// What happened in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepReport {
    /// Whether every equation that the step had to solve was solved to the tolerance; true for explicit steppers.
    pub converged: bool,
    /// Newton iterations; 0 for explicit steppers.
    pub iterations: u32,
    /// Iterations of the linear solver inside Newton's, each a product with its matrix; 0 for explicit steppers.
    pub linear_iterations: u32,
    /// Factorisations of its matrix; 0 where conjugate gradients did without.
    pub factorisations: u32,
    /// The largest remaining residual of those equations, relative to the size of their terms.
    pub residual: f64,
    /// Evaluations of all spring forces.
    pub force_evaluations: u32,
    /// Parts that a stepper which chooses the lengths of its steps has taken, without those taken anew; 0 for others.
    pub parts: u32,
    /// Parts of steps that were taken anew, shorter, because their error was too large.
    pub rejected: u32,
    /// Bounces on planes.
    pub hits: u32,
    /// The parts that hits cut the step into: 1 without any.
    pub substeps: u32,
    /// Particles whose hits were too many to follow one by one: they were stopped on the planes they touch,
    /// until the end of the step.
    pub capped: u32,
    /// Springs of length 0, which have no direction and so exerted no force, in the last evaluation.
    pub degenerate_springs: u32,
    /// Islands that slept through the step.
    pub islands_asleep: u32,
}

impl Default for StepReport {
    fn default() -> Self {
        Self {
            converged: true,
            iterations: 0,
            linear_iterations: 0,
            factorisations: 0,
            residual: 0.0,
            force_evaluations: 0,
            parts: 0,
            rejected: 0,
            hits: 0,
            substeps: 0,
            capped: 0,
            degenerate_springs: 0,
            islands_asleep: 0,
        }
    }
}

impl StepReport {
    /// Adds what happened in a later part of the same step.
    pub fn add(&mut self, later: &Self) {
        self.converged &= later.converged;
        self.iterations = self.iterations.saturating_add(later.iterations);
        self.linear_iterations = self.linear_iterations.saturating_add(later.linear_iterations);
        self.factorisations = self.factorisations.saturating_add(later.factorisations);
        self.residual = if later.residual > self.residual { later.residual } else { self.residual };
        self.force_evaluations = self.force_evaluations.saturating_add(later.force_evaluations);
        self.parts = self.parts.saturating_add(later.parts);
        self.rejected = self.rejected.saturating_add(later.rejected);
        self.hits = self.hits.saturating_add(later.hits);
        self.substeps = self.substeps.saturating_add(later.substeps);
        self.capped = self.capped.saturating_add(later.capped);
        self.degenerate_springs = later.degenerate_springs;
    }
}
