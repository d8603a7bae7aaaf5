//! DOP853 between the ends of its steps.

use super::dense_weights::{ALL, FURTHER, MATRIX, STAGES, weights};
use super::dop853::Hairer;
use super::tableau::weighted;
use super::{Adaptive, RungeKutta};
use crate::Real;
use crate::roles::Stepper;
use crate::steppers::combination::{Combination, Factors, MOST_STAGES, Terms};
use crate::types::{Full, StepError, StepReport};
use crate::vectors::{Columns, lend, read};
use crate::world::{Column, Plan, StateColumns, Storage, View};

// Sums have room for no more: with more stages this is not compiled.
const _: usize = MOST_STAGES - ALL;

/// A stepper whose last step is known stage by stage.
pub trait Stages<R: Real> {
    /// The accelerations of each stage, m/s².
    fn accelerations(&self) -> [Columns<'_, R>; STAGES];

    /// How many particles they are of.
    fn particles(&self) -> u32;
}

impl<R: Real, M: Storage> Stages<R> for RungeKutta<R, M, Hairer, STAGES> {
    fn accelerations(&self) -> [Columns<'_, R>; STAGES] {
        self.acceleration.each_ref().map(|columns| columns.each_ref().map(Column::items))
    }

    fn particles(&self) -> u32 {
        self.particles
    }
}

impl<R: Real, M: Storage> Stages<R> for Adaptive<R, M, Hairer, STAGES> {
    fn accelerations(&self) -> [Columns<'_, R>; STAGES] {
        self.method.accelerations()
    }

    fn particles(&self) -> u32 {
        self.method.particles
    }
}

/// [`super::Dop853`] or [`super::AdaptiveDop853`], with its dense output: [`Stepper::between`] tells positions and velocities
/// at any time within a step or a part of one, to the seventh order (Hairer, Nørsett and Wanner, *Solving Ordinary Differential
/// Equations I*, 2nd edition 1993, §II.6; the coefficients are those of their code `DOP853`).
///
/// The first look at a step takes four evaluations of forces, at its end and at three stages more, which no report counts;
/// further looks take none. Steps that nobody looks at cost nothing. It owns 18 reals a particle beside the stepper.
///
/// ```
/// use hooke::{DenseOutput, Dop853, Fixed, Observer, Particle, Reflect, Spring, Stepper, View, World};
///
/// /// Where a particle is half-way through each step.
/// struct Middle(f64);
///
/// impl Observer<f64> for Middle {
///     fn watches(&self) -> bool {
///         true
///     }
///     fn advanced(&mut self, _: &mut View<'_, f64>, _: f64) {}
///     fn advanced_by(&mut self, view: &mut View<'_, f64>, dt: f64, stepper: &mut (impl Stepper<f64> + ?Sized)) {
///         self.0 = stepper.between(view, dt, 0.5 * dt).and_then(|view| view.position(1)).map_or(f64::NAN, |x| x.x);
///     }
///     fn lost_in_impacts(&mut self, _: f64) {}
/// }
///
/// let mut world = World::<f64, 2, 1, 0>::new();
/// let pin = world.add_particle(Particle::at([0.0; 3]).pinned())?;
/// let mass = world.add_particle(Particle::at([1.1, 0.0, 0.0]))?;
/// world.add_spring(Spring::new([pin, mass], 1.0, 1.0))?;
/// let mut stepper = DenseOutput::<_, f64, Fixed<2, 1, 0>>::of(Dop853::<f64, Fixed<2, 1, 0>>::new());
/// let mut middle = Middle(0.0);
/// world.view().step_observed(&mut stepper, &mut Reflect, 0.5, &mut middle)?;
/// // x = 1 + 0.1 cos t
/// assert!((middle.0 - 1.0 - 0.1 * 0.25_f64.cos()).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct DenseOutput<S, R: Real, M: Storage> {
    stepper: S,
    /// At the end of the step and at the further stages.
    acceleration: [[M::Particles<R>; 3]; ALL - STAGES],
    /// Of a further stage, then of the time that is asked for.
    state: StateColumns<R, M>,
    /// Whether those are of the step that was made last.
    is_known: bool,
}

impl<S, R: Real, M: Storage> DenseOutput<S, R, M> {
    /// Of a stepper, which it steps as: one that tells its stages, [`super::Dop853`] or [`super::AdaptiveDop853`].
    #[must_use]
    pub const fn of(stepper: S) -> Self {
        Self {
            stepper,
            acceleration: [const { [const { Column::EMPTY }; 3] }; ALL - STAGES],
            state: StateColumns::EMPTY,
            is_known: false,
        }
    }
}

impl<R: Real, M: Storage, S: Stages<R>> DenseOutput<S, R, M> {
    /// Writes the state that these weights of the stages make of the current one, from a step of `dt`, to `self.state`.
    fn combine(
        to: &mut StateColumns<R, M>,
        view: &View<'_, R>,
        known: &[Columns<'_, R>],
        dt: R,
        weights: &[f64; ALL],
        is_told: bool,
    ) {
        let Some((last, before)) = known.split_last() else { return };
        let dt = dt.to_f64();
        let position = Factors { scale: dt * dt, coefficients: &weighted(weights, &MATRIX) };
        let velocity = Factors { scale: dt, coefficients: weights };
        let drift: f64 = weights.iter().sum();
        let combination = Combination {
            terms: Terms { drift: R::from_f64(dt * drift), position, velocity: Some(velocity) },
            is_step: false,
            carries_velocity: is_told,
            lanes: view.system.lanes,
            state: &(view.current.carried_position(), view.current.carried_velocity()),
            known: before,
            first: 0,
            to: to.lend(),
        };
        combination.of_known(view.system.plan.particles, *last);
    }

    /// The accelerations at the end of the step and at the further stages.
    fn look(&mut self, view: &View<'_, R>, dt: R) {
        // Nobody's report: it is for whoever looks.
        let mut report = StepReport::default();
        let mut known = [Columns::<R>::default(); ALL];
        for (known, columns) in known.iter_mut().zip(self.stepper.accelerations()) {
            *known = columns;
        }
        let mut fresh = self.acceleration.each_mut().map(|columns| columns.each_mut().map(Column::items_mut));
        for ((stage, fresh), weights) in
            (STAGES..).zip(&mut fresh).zip([None].into_iter().chain(FURTHER.iter().map(Some)))
        {
            if let Some(weights) = weights {
                let before = known.get(..stage).unwrap_or_default();
                Self::combine(&mut self.state, view, before, dt, weights, false);
                let velocity = self.state.velocity().value;
                view.system.accelerations(self.state.position(), velocity, lend(fresh), &mut report);
            } else {
                let velocity = read(&view.next.velocity);
                view.system.accelerations(view.next.carried_position(), velocity, lend(fresh), &mut report);
            }
            if let Some(known) = known.get_mut(stage) {
                *known = read(fresh);
            }
        }
        self.is_known = true;
    }
}

impl<R: Real, M: Storage, S: Stepper<R> + Stages<R>> Stepper<R> for DenseOutput<S, R, M> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        let particles = plan.particles as usize;
        self.acceleration.iter_mut().flatten().try_for_each(|column| column.fit(particles))?;
        self.state.fit(particles)?;
        self.stepper.fit(plan)
    }

    fn accept(&self, plan: &Plan) -> Result<(), StepError> {
        self.stepper.accept(plan)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        self.is_known = false;
        self.stepper.advance(view, dt)
    }

    fn advance_up_to(&mut self, view: &mut View<'_, R>, most: R, report: &mut StepReport) -> R {
        self.is_known = false;
        self.stepper.advance_up_to(view, most, report)
    }

    fn chooses_parts(&self) -> bool {
        self.stepper.chooses_parts()
    }

    fn begins(&mut self, view: &View<'_, R>) {
        self.stepper.begins(view);
    }

    fn fails(&mut self, view: &mut View<'_, R>) {
        self.stepper.fails(view);
    }

    fn between<'a>(&'a mut self, view: &'a mut View<'_, R>, dt: R, after: R) -> Option<View<'a, R>> {
        if self.stepper.particles() < view.system.plan.particles {
            // The others fly on a path of their own.
            return None;
        }
        if !self.is_known {
            self.look(view, dt);
        }
        let mut known = [Columns::<R>::default(); ALL];
        let further = self.acceleration.each_ref().map(|columns| columns.each_ref().map(Column::items));
        for (known, columns) in known.iter_mut().zip(self.stepper.accelerations().into_iter().chain(further)) {
            *known = columns;
        }
        let weights = weights(after.to_f64() / dt.to_f64());
        Self::combine(&mut self.state, view, &known, dt, &weights, true);
        Some(view.with_state(self.state.lend()))
    }

    fn order(&self) -> u32 {
        self.stepper.order()
    }

    fn curvature(&self) -> R {
        self.stepper.curvature()
    }

    fn rearranged(&mut self, view: &View<'_, R>) {
        self.stepper.rearranged(view);
    }
}
