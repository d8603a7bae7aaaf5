//! The loop over the stages of a step, one for all methods.

use super::tableau::Tableau;
use crate::Real;
use crate::steppers::combination::{Combination, Factors, MOST_STAGES, Terms};
use crate::types::StepReport;
use crate::vectors::{Columns, ColumnsMut, lend, read};
use crate::world::{Coverage, State, View};

/// A tableau as rows of coefficients, whatever the number of its stages.
pub struct Rows {
    /// c
    nodes: &'static [f64],
    /// ā and a, row after row.
    position: &'static [f64],
    velocity: Option<&'static [f64]>,
    /// b̄ and b
    weights: [&'static [f64]; 2],
}

impl Rows {
    /// Those of a tableau.
    pub const fn of<T: Tableau<STAGES>, const STAGES: usize>() -> Self {
        // Sums have room for no more: with more stages this is not compiled.
        let _ = const { MOST_STAGES - STAGES };
        Self {
            nodes: const { &T::NODES },
            position: const { &T::POSITION }.as_flattened(),
            velocity: match const { &T::VELOCITY } {
                Some(matrix) => Some(matrix.as_flattened()),
                None => None,
            },
            weights: [const { &T::POSITION_WEIGHTS }, const { &T::VELOCITY_WEIGHTS }],
        }
    }

    /// What makes the state of a stage out of the accelerations of those before it, or the step out of all.
    fn terms<R: Real>(&self, dt: R, stage: usize, with_velocity: bool) -> Terms<'static, R> {
        let dt = dt.to_f64();
        let position = |coefficients| Factors { scale: dt * dt, coefficients };
        let velocity = |coefficients| Factors { scale: dt, coefficients };
        let Some(node) = self.nodes.get(stage) else {
            let [b_position, b_velocity] = self.weights;
            let velocity = Some(velocity(b_velocity));
            return Terms { drift: R::from_f64(dt), position: position(b_position), velocity };
        };
        let stages = self.nodes.len();
        let row = |matrix: &'static [f64]| matrix.get(stage * stages..(stage + 1) * stages).unwrap_or_default();
        let velocity = self.velocity.filter(|_| with_velocity).map(|matrix| velocity(row(matrix)));
        Terms { drift: R::from_f64(dt * node), position: position(row(self.position)), velocity }
    }
}

/// The stages of a step.
pub struct Stages<'a, 'b, R: Real> {
    pub rows: Rows,
    /// The acceleration of each stage, to be written.
    pub fresh: &'a mut [ColumnsMut<'b, R>],
    /// Those that have been, as many.
    pub known: &'a mut [Columns<'a, R>],
    /// Every second stage's state; the others are in the next state.
    pub spare: State<'a, R>,
    /// Whether the first acceleration is that of the current state already.
    pub is_kept: bool,
}

impl<R: Real> Stages<'_, '_, R> {
    /// Takes a step of `dt`.
    pub fn advance(self, view: &mut View<'_, R>, dt: R, report: &mut StepReport) {
        let Self { rows, fresh: accelerations, known, mut spare, is_kept } = self;
        let View { system, current, next, .. } = view;
        let (mut spare, mut next) = (spare.lend(), next.lend());
        // What lies on planes is told by velocities too.
        let with_velocity = system.plan.damped != Coverage::None || system.support.is_some();
        let state = (current.carried_position(), current.carried_velocity());
        let stages = accelerations.len();
        for (stage, fresh) in accelerations.iter_mut().enumerate() {
            // The last stage is in the spare state, so that the step can be written while it is still read.
            let is_spare = (stages - stage) % 2 == 1;
            let (from, to) = if is_spare { (&spare, &mut next) } else { (&next, &mut spare) };
            let (at, speed) = match stage {
                0 => (state.0, state.1.value),
                _ if with_velocity && rows.velocity.is_some() => (from.carried_position(), read(&from.velocity)),
                _ => (from.carried_position(), state.1.value),
            };
            let is_step = stage + 1 == stages;
            let to = to.lend();
            // Made where it is wanted: moved, it would have to be read while it is still being written.
            let combination = || Combination {
                terms: rows.terms(dt, stage + 1, with_velocity),
                is_step,
                carries_velocity: is_step,
                lanes: system.lanes,
                state: &state,
                known: known.get(..stage).unwrap_or_default(),
                first: 0,
                to,
            };
            let finite = if stage == 0 && is_kept {
                combination().of_known(system.plan.particles, read(fresh))
            } else {
                system.accelerations_then(at, speed, lend(fresh), report, combination())
            };
            if is_step {
                view.is_next_finite = finite;
            }
            if let Some(known) = known.get_mut(stage) {
                *known = read(fresh);
            }
        }
    }
}
