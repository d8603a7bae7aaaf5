//! Explicit Runge-Kutta methods: one loop over stages for all of them.

mod adaptive;
mod dense;
mod dense_weights;
mod dop853;
mod dormand_prince_rkn8;
mod embedded;
mod rk4;
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
use crate::vectors::{Columns, lend, read};
use crate::world::{Column, Coverage, Plan, StateColumns, Storage, View};

use super::combination::{Combination, Factors, Terms};
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

    /// What makes the state of a stage out of the accelerations of those before it, or the step out of all.
    fn terms(dt: R, stage: usize, with_velocity: bool) -> Terms<'static, R, STAGES> {
        let dt = dt.to_f64();
        let position = |coefficients| Factors { scale: dt * dt, coefficients };
        let velocity = |coefficients| Factors { scale: dt, coefficients };
        let (nodes, rows) = const { (&T::NODES, &T::POSITION) };
        if let (Some(node), Some(row)) = (nodes.get(stage), rows.get(stage)) {
            let rows = const { &T::VELOCITY }.as_ref().filter(|_| with_velocity);
            let velocity = rows.and_then(|rows| rows.get(stage)).map(velocity);
            return Terms { drift: R::from_f64(dt * node), position: position(row), velocity };
        }
        let velocity = Some(velocity(const { &T::VELOCITY_WEIGHTS }));
        Terms { drift: R::from_f64(dt), position: position(const { &T::POSITION_WEIGHTS }), velocity }
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
        let View { system, current, next, .. } = view;
        let (mut spare, mut next) = (self.stage.lend(), next.lend());
        let mut accelerations = self.acceleration.each_mut().map(|columns| columns.each_mut().map(Column::items_mut));
        // What lies on planes is told by velocities too.
        let with_velocity = system.plan.damped != Coverage::None || system.support.is_some();
        let state = (current.carried_position(), current.carried_velocity());
        let mut known = [Columns::<R>::default(); STAGES];
        for (stage, fresh) in accelerations.iter_mut().enumerate() {
            // The last stage is in the spare state, so that the step can be written while it is still read.
            let is_spare = (STAGES - stage) % 2 == 1;
            let (from, to) = if is_spare { (&spare, &mut next) } else { (&next, &mut spare) };
            let (at, speed) = match stage {
                0 => (state.0, state.1.value),
                _ if with_velocity && T::VELOCITY.is_some() => (from.carried_position(), read(&from.velocity)),
                _ => (from.carried_position(), state.1.value),
            };
            let to = to.lend();
            // Made where it is wanted: moved, it would have to be read while it is still being written.
            let combination = || Combination {
                terms: Self::terms(dt, stage + 1, with_velocity),
                is_step: stage + 1 == STAGES,
                carries_velocity: stage + 1 == STAGES,
                lanes: system.lanes,
                state: &state,
                known: known.get(..stage).unwrap_or_default(),
                first: 0,
                to,
            };
            let is_kept = stage == 0 && is_kept;
            let finite = if is_kept {
                combination().of_known(system.plan.particles, read(fresh))
            } else {
                system.accelerations_then(at, speed, lend(fresh), report, combination())
            };
            if stage + 1 == STAGES {
                view.is_next_finite = finite;
            }
            if let Some(known) = known.get_mut(stage) {
                *known = read(fresh);
            }
        }
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
