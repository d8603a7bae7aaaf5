//! Explicit Runge-Kutta methods, each a tableau of coefficients.

mod adaptive;
mod dense;
mod dense_weights;
mod dop853;
mod dormand_prince_rkn8;
mod embedded;
mod rk4;
mod stages;
mod tableau;

pub use adaptive::Adaptive;
pub use dense::DenseOutput;
pub use dop853::{AdaptiveDop853, Dop853};
pub use dormand_prince_rkn8::{AdaptiveDormandPrinceRkn8, DormandPrinceRkn8};
pub use rk4::Rk4;

use core::marker::PhantomData;

use crate::Real;
use crate::roles::Stepper;
use crate::types::{Full, StepError, StepReport};
use crate::vectors::Columns;
use crate::world::{Column, Coverage, Plan, StateColumns, Storage, View};

use stages::{Rows, Stages};
use tableau::Tableau;

/// An explicit Runge-Kutta method with the coefficients of `T`.
///
/// Stages are those of an equation of second order: only their accelerations are kept, 3 reals a particle and stage, and
/// beside them one state, 6 reals a particle.
pub struct RungeKutta<R: Real, M: Storage, T, const STAGES: usize> {
    acceleration: [[M::Particles<R>; 3]; STAGES],
    /// Every second stage's; the others are in the next state.
    stage: StateColumns<R, M>,
    /// The epochs of the states that the first acceleration belongs to, and the last one; 0 is none.
    epochs: [u64; 2],
    /// How many particles they are of: a response may leave some to others.
    particles: u32,
    tableau: PhantomData<T>,
}

impl<R: Real, M: Storage, T: Tableau<STAGES>, const STAGES: usize> RungeKutta<R, M, T, STAGES> {
    /// Without room for any particles yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            acceleration: [const { [const { Column::EMPTY }; 3] }; STAGES],
            stage: StateColumns::EMPTY,
            epochs: [0; 2],
            particles: 0,
            tableau: PhantomData,
        }
    }

    /// Whether the first acceleration is that of the current state already.
    fn is_kept(&mut self, epoch: u64) -> bool {
        let [first, last] = self.epochs;
        if last == epoch
            && let Some((first, [.., last])) = self.acceleration.split_first_mut()
        {
            core::mem::swap(first, last);
            return true;
        }
        first == epoch
    }

    fn run(&mut self, view: &mut View<'_, R>, dt: R, report: &mut StepReport) {
        let particles = view.system.plan.particles;
        let is_kept = core::mem::replace(&mut self.particles, particles) >= particles && self.is_kept(*view.epoch);
        let stages = Stages {
            rows: const { Rows::of::<T, STAGES>() },
            fresh: &mut self.acceleration.each_mut().map(|columns| columns.each_mut().map(Column::items_mut)),
            known: &mut [Columns::default(); STAGES],
            spare: self.stage.lend(),
            is_kept,
        };
        stages.advance(view, dt, report);
        // What planes hold up follows from velocities that the last stage does not have.
        let is_last_next = T::FIRST_SAME_AS_LAST && view.system.support.is_none();
        self.epochs = [*view.epoch, if is_last_next { *view.epoch + 1 } else { 0 }];
    }
}

impl<R: Real, M: Storage, T: Tableau<STAGES>, const STAGES: usize> Default for RungeKutta<R, M, T, STAGES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real, M: Storage, T: Tableau<STAGES>, const STAGES: usize> Stepper<R> for RungeKutta<R, M, T, STAGES> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        let particles = plan.particles as usize;
        self.acceleration.iter_mut().flatten().try_for_each(|column| column.fit(particles))?;
        self.stage.fit(particles)
    }

    fn accept(&self, plan: &Plan) -> Result<(), StepError> {
        if T::VELOCITY.is_none() && plan.damped != Coverage::None { Err(StepError::Damped) } else { Ok(()) }
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        let mut report = StepReport::default();
        self.run(view, dt, &mut report);
        report
    }

    fn order(&self) -> u32 {
        T::ORDER
    }

    fn curvature(&self) -> R {
        R::from_f64(0.5)
    }

    fn rearranged(&mut self, _view: &View<'_, R>) {
        self.epochs = [0; 2];
    }
}
