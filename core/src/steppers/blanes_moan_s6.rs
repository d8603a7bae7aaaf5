//! A splitting method of order 4: drifts and kicks by turns.

use super::combination::{Combination, Factors, Terms};
use crate::Real;
use crate::carried::Carried;
use crate::forces::{Follow, Keep};
use crate::roles::Stepper;
use crate::types::{Full, StepReport};
use crate::vectors::{Columns, ColumnsMut, lend, read};
use crate::world::{Column, Coverage, Plan, StateColumns, Storage, System, View};

/// The terms of the series that a damped kick is.
const TERMS: usize = 4;

/// Where nothing kicks.
const NONE: Factors<'_> = Factors { scale: 0.0, coefficients: &[] };

/// a: the drifts, each but the first after a kick; the last three mirror the first.
const DRIFTS: [f64; 7] = {
    let [first, second, third] = [0.079_203_696_431_195_7, 0.353_172_906_049_774, -0.042_065_080_357_719_5];
    [first, second, third, 1.0 - 2.0 * (first + second + third), third, second, first]
};

/// b: the kicks; the last three mirror the first.
const KICKS: [f64; 6] = {
    let [first, second] = [0.209_515_106_613_362, -0.143_851_773_179_818];
    let third = 0.5 - (first + second);
    [first, second, third, third, second, first]
};

/// The symmetric splitting S₆ of order 4 (Blanes and Moan, *Practical symplectic partitioned Runge-Kutta and
/// Runge-Kutta-Nyström methods*, Journal of Computational and Applied Mathematics 142, 2002): x' = x + aᵢ dt v and
/// v' = v + bᵢ dt a(x, v) by turns, six kicks a step. Symplectic where nothing is damped, and then stable up to
/// ω dt = 3.13.
///
/// Between two positions a kick is to follow v′ = a(x, v), which is affine in v: where springs are damped it is the
/// first four terms of its Taylor series, τ a + τ²/2 D a + τ³/6 D² a + τ⁴/24 D³ a with D = ∂a/∂v, which keep the order.
/// They take three more passes over damped springs a kick; [`StepReport::force_evaluations`] counts the first alone.
pub struct BlanesMoanS6<R: Real, M: Storage> {
    /// Of the kick at hand: a, D a, D² a, D³ a.
    terms: [[M::Particles<R>; 3]; TERMS],
    /// After every second kick; after the others it is the next state.
    spare: StateColumns<R, M>,
}

impl<R: Real, M: Storage> BlanesMoanS6<R, M> {
    /// Without room for any particles yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { terms: [const { [const { Column::EMPTY }; 3] }; TERMS], spare: StateColumns::EMPTY }
    }

    fn run(&mut self, view: &mut View<'_, R>, dt: R, report: &mut StepReport) {
        let View { system, current, next, .. } = view;
        let (mut spare, mut next) = (self.spare.lend(), next.lend());
        let mut terms = self.terms.each_mut().map(|columns| columns.each_mut().map(Column::items_mut));
        let count = terms_of(&system.plan);
        let (x, v) = (current.carried_position(), current.carried_velocity());
        let [first, drifts @ ..] = DRIFTS;
        let drift = Combination {
            terms: Terms { drift: R::from_f64(first) * dt, position: NONE, velocity: None },
            is_step: false,
            carries_velocity: false,
            lanes: system.lanes,
            state: &(x, v),
            known: &[],
            first: 0,
            to: next.lend(),
        };
        // None of them counts.
        drift.of_known(system.plan.particles, v.value);
        for (kick, (b, a)) in KICKS.into_iter().zip(drifts).enumerate() {
            let (from, to) = if kick % 2 == 0 { (&next, &mut spare) } else { (&spare, &mut next) };
            let position = from.carried_position();
            let velocity = if kick == 0 { v } else { from.carried_velocity() };
            let series = series(b * dt.to_f64(), count);
            let h = a * dt.to_f64();
            for term in 0..count {
                let Some((earlier, [fresh, ..])) = terms.split_at_mut_checked(term) else { return };
                let mut known = [Columns::<R>::default(); TERMS];
                for (known, columns) in known.iter_mut().zip(&*earlier) {
                    *known = read(columns);
                }
                let known = known.get(..term).unwrap_or_default();
                let vectors = known.last().copied().unwrap_or(velocity.value);
                let (system, out) = (*system, lend(fresh));
                if term + 1 < count {
                    evaluate(system, position, vectors, out, term, report, Keep);
                    continue;
                }
                let kicked = Combination {
                    terms: kicked(h, &series),
                    is_step: kick + 1 == KICKS.len(),
                    carries_velocity: true,
                    lanes: system.lanes,
                    state: &(position, velocity),
                    known,
                    first: 0,
                    to: to.lend(),
                };
                view.is_next_finite = evaluate(system, position, vectors, out, term, report, kicked);
            }
        }
    }
}

/// a, or what damping makes of the term before.
fn evaluate<R: Real>(
    system: System<'_, R>,
    position: Carried<'_, R>,
    vectors: Columns<'_, R>,
    out: ColumnsMut<'_, R>,
    term: usize,
    report: &mut StepReport,
    then: impl Follow<R>,
) -> bool {
    if term == 0 {
        system.accelerations_then(position, vectors, out, report, then)
    } else {
        system.damping_then(position, vectors, out, then)
    }
}

/// v + τ a + τ²/2 D a + …, and x + h times that.
fn kicked<R: Real>(h: f64, series: &[f64; TERMS]) -> Terms<'_, R> {
    let factors = |scale| Factors { scale, coefficients: series };
    Terms { drift: R::from_f64(h), position: factors(h), velocity: Some(factors(1.0)) }
}

/// τ, τ²/2, …
fn series(tau: f64, count: usize) -> [f64; TERMS] {
    let mut series = [0.0; TERMS];
    let mut power = 1.0;
    for (order, term) in (1..).zip(&mut series).take(count) {
        power *= tau / f64::from(order);
        *term = power;
    }
    series
}

impl<R: Real, M: Storage> Default for BlanesMoanS6<R, M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real, M: Storage> Stepper<R> for BlanesMoanS6<R, M> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        let particles = plan.particles as usize;
        let count = terms_of(plan);
        self.terms.iter_mut().take(count).flatten().try_for_each(|column| column.fit(particles))?;
        self.spare.fit(particles)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        let mut report = StepReport::default();
        self.run(view, dt, &mut report);
        report
    }

    fn order(&self) -> u32 {
        4
    }

    fn curvature(&self) -> R {
        R::from_f64(0.5)
    }
}

/// How many terms a kick has.
fn terms_of(plan: &Plan) -> usize {
    if plan.damped == Coverage::None { 1 } else { TERMS }
}
