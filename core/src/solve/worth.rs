//! Whether a factor is worth its work.
//!
//! Works are in units of one product of two blocks in a factorisation; the numbers were measured, on ropes of 10 to
//! 100,000 particles and cloths of 8 x 8 to 64 x 64 with stiffnesses from 100 to 100,000 N/m in steps of 1/60 s.

use core::fmt;

use crate::Real;
use crate::vectors::at;
use crate::world::{Plan, System};

/// An iteration of the conjugate gradients: for each spring and for each particle.
const ITERATION: [f64; 2] = [0.7, 1.2];
/// Assembling the matrix: for each spring and for each particle.
const ASSEMBLY: [f64; 2] = [0.8, 0.8];
/// A solution by a factor: for each of its blocks and for each particle.
const SOLUTION: [f64; 2] = [1.0, 0.8];
/// Newton iterations of a step, and the iterations of conjugate gradients that each needs around the factor of the first.
const NEWTON: f64 = 4.0;
const AROUND: f64 = 5.0;
/// Iterations that conjugate gradients need for a residual a hundred times smaller: over the square root of 1 + the
/// stiffness in a large system, and over the particles from one end to the other in a stiff one.
const LARGE: f64 = 2.0;
const STIFF: f64 = 4.0;

/// What the factorisation of an implicit step's matrix takes: the same for all matrices of the same springs and held
/// particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elimination {
    /// Particles that are eliminated: those that springs pull at and that are not held.
    pub particles: u32,
    /// Blocks of 3 × 3 below the factor's diagonal.
    pub blocks: u32,
    /// Products of two blocks.
    pub products: f64,
}

/// What solves the linear systems of an implicit step, and why: its `Display` says so in words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearSolver {
    /// What a factorisation takes, or would take at least if it is not worth looking into.
    pub elimination: Elimination,
    /// The iterations of conjugate gradients that take as much time as a solution by a factor that is kept as long as it
    /// is near enough; infinite if there is no room for one.
    pub price: f64,
    /// The iterations that conjugate gradients are expected to need for a residual a hundred times smaller.
    pub expected: f64,
    /// The iterations of conjugate gradients that take as much time as making a factor for one solution.
    pub(crate) patience: f64,
    /// The iterations around a factor that take as much time as making it anew.
    pub(crate) renewal: f64,
}

impl Elimination {
    /// One with more blocks than there is room for.
    pub(crate) const IMPOSSIBLE: Self = Self { particles: 0, blocks: u32::MAX, products: f64::INFINITY };

    /// The cheapest that there can be: that of a chain, which leaves no more blocks than there are springs.
    pub(crate) fn without_fill(plan: &Plan) -> Self {
        let products = 3.0 * f64::from(plan.attached);
        Self { particles: plan.attached, blocks: plan.springs.min(plan.attached), products }
    }
}

impl LinearSolver {
    /// Of no world.
    pub(crate) const NOTHING: Self = Self {
        elimination: Elimination::IMPOSSIBLE,
        price: f64::INFINITY,
        expected: 0.0,
        patience: f64::INFINITY,
        renewal: 0.0,
    };

    /// Of a world of which so much is known.
    pub(crate) fn of(plan: &Plan, elimination: Elimination, stiffness: f64) -> Self {
        let (springs, particles) = (f64::from(plan.springs), f64::from(plan.attached));
        let of = |[a, b]: [f64; 2], number: f64| a * number + b * particles;
        let (iteration, solution) = (of(ITERATION, springs), of(SOLUTION, f64::from(elimination.blocks)));
        let making = of(ASSEMBLY, springs) + elimination.products;
        let around = solution + iteration;
        let renewed = making + around;
        let kept = making / NEWTON + AROUND * around;
        // Where a factor of n columns has few blocks its graph is long: a chain's n from end to end, a square's √n or so.
        let distance = particles * particles / f64::from(elimination.blocks.max(1));
        let expected = 1.0 / (1.0 / (LARGE * Real::sqrt(1.0 + stiffness)) + 1.0 / (STIFF * distance));
        let (price, patience) = (renewed.min(kept) / iteration, renewed / iteration);
        Self { elimination, price, expected, patience, renewal: making / around }
    }

    /// Whether there can be a factor.
    pub(crate) fn is_possible(&self) -> bool {
        self.patience.is_finite()
    }

    /// Whether factors are made from the first iteration on. Otherwise they are where conjugate gradients turn out to
    /// need far more iterations than expected.
    #[must_use]
    pub fn is_direct(&self) -> bool {
        self.price < self.expected
    }
}

impl fmt::Display for LinearSolver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { elimination: Elimination { particles, blocks, .. }, price, expected, .. } = self;
        if self.is_direct() {
            return write!(
                f,
                "a factorisation, of {particles} particles in {blocks} blocks: as much work as {price:.0} iterations of \
                 conjugate gradients, which would need about {expected:.0}"
            );
        }
        write!(f, "conjugate gradients, about {expected:.0} iterations for two digits: ")?;
        if *blocks == u32::MAX {
            write!(f, "a factor has more blocks than there is room for")
        } else if self.is_possible() {
            write!(f, "a factor of {blocks} blocks is as much work as {price:.0}")
        } else {
            write!(f, "no factor is worth its work for so few")
        }
    }
}

/// How stiff a step is: the largest Σ (dt²·k + dt·k_d)/m of any particle, without a unit.
pub(crate) fn stiffness<R: Real>(system: &System<'_, R>, dt: R) -> f64 {
    let springs = system.springs;
    let largest = system.springs.by_slot(system.plan.attached).fold(R::ZERO, |largest, (slot, incidences)| {
        let resistance = incidences.iter().fold(R::ZERO, |sum, incidence| {
            sum + dt * at(springs.stiffness, incidence.spring) + at(springs.damping, incidence.spring)
        });
        largest.at_least(dt * resistance * at(system.inverse_mass, slot))
    });
    largest.to_f64()
}
