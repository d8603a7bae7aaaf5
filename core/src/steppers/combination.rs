//! From accelerations to the state of a stage, or of the step: what follows tile by tile while they are at hand.

use core::ops::Range;

use crate::Real;
use crate::carried::Carried;
use crate::forces::{Acceleration, Then, Tile};
use crate::lanes::{Present, SixColumns, run_on_six};
use crate::vectors::{Columns, cut, read, triples, window};
use crate::world::{State, tiles};

/// x + h v + Σ pⱼ Aⱼ and v + Σ qⱼ Aⱼ.
#[derive(Clone, Copy)]
pub struct Terms<R, const STAGES: usize> {
    /// h, s
    drift: R,
    /// j, p (s²) and q (s), of those that are not 0.
    factors: [(usize, R, R); STAGES],
    count: usize,
    /// Whether anybody asks for the velocity.
    with_velocity: bool,
}

impl<R: Real, const STAGES: usize> Terms<R, STAGES> {
    /// h, p and q; no q where nobody asks for the velocity.
    pub fn new(drift: R, position: [R; STAGES], velocity: Option<[R; STAGES]>) -> Self {
        let mut terms =
            Self { drift, factors: [(0, R::ZERO, R::ZERO); STAGES], count: 0, with_velocity: velocity.is_some() };
        let factors = position.into_iter().zip(velocity.unwrap_or([R::ZERO; STAGES]));
        let factors = factors.enumerate().filter(|(_, (p, q))| *p != R::ZERO || *q != R::ZERO);
        for (place, (stage, (p, q))) in terms.factors.iter_mut().zip(factors) {
            *place = (stage, p, q);
            terms.count += 1;
        }
        terms
    }
}

/// Writes such a state, once the last of the accelerations is known.
pub struct Combination<'a, R: Real, const STAGES: usize> {
    pub terms: &'a Terms<R, STAGES>,
    /// Whether it is to be finite: only of the step itself, as no sum gets finite again.
    pub is_step: bool,
    /// Whether its velocity is carried on, with what rounding takes from it.
    pub carries_velocity: bool,
    pub lanes: Present,
    /// x and v, of all slots.
    pub state: (Carried<'a, R>, Carried<'a, R>),
    /// The accelerations before the last one, of all slots.
    pub known: &'a [Columns<'a, R>],
    /// The slot that what is written begins with.
    pub first: u32,
    pub to: State<'a, R>,
}

impl<R: Real, const STAGES: usize> Combination<'_, R, STAGES> {
    /// Of so many particles, the last acceleration being known as well. Returns whether it is finite, if that is asked.
    pub fn of_known(mut self, particles: u32, last: Columns<'_, R>) -> bool {
        tiles(0..particles).fold(true, |finite, tile| {
            let fresh = window(last, tile.clone());
            self.combine(tile, fresh).unwrap_or(false) & finite
        })
    }

    /// Nothing if a column is too short.
    fn combine(&mut self, tile: Range<u32>, fresh: Columns<'_, R>) -> Option<bool> {
        let (x, v) = (self.state.0.cut(tile.clone())?, self.state.1.cut(tile.clone())?);
        let to = tile.start - self.first..tile.end - self.first;
        let [position, velocity] = self.to.lend().apart();
        let (mut position, mut velocity) = (position.cut(to.clone())?, velocity.cut(to)?);
        let mut accelerations = [(R::ZERO, R::ZERO, Columns::<R>::default()); STAGES];
        let factors = self.terms.factors.get(..self.terms.count)?;
        for (place, (stage, p, q)) in accelerations.iter_mut().zip(factors) {
            let column = match self.known.get(*stage) {
                Some(known) => cut(*known, tile.clone())?,
                None => fresh,
            };
            *place = (*p, *q, column);
        }
        let sums = Sums {
            from: (x.value, v.value),
            drift: self.terms.drift,
            accelerations: accelerations.get(..self.terms.count)?,
            with_velocity: self.terms.with_velocity,
            is_checked: self.is_step,
            carries_velocity: self.carries_velocity,
        };
        let ([x_to, y_to, z_to], [u_to, v_to, w_to]) = (&mut position.value, &mut velocity.value);
        let mut finite = run_on_six(self.lanes, sums, x_to, y_to, z_to, u_to, v_to, w_to)?;
        if R::IS_COMPENSATED {
            finite &= position.add(self.lanes, x, triples(x.value).map(|_| |sum| sum));
            finite &= !self.carries_velocity || velocity.add(self.lanes, v, triples(v.value).map(|_| |sum| sum));
        }
        Some(finite)
    }
}

impl<R: Real, const STAGES: usize> Then<R> for Combination<'_, R, STAGES> {
    #[inline(always)]
    fn then<A: Acceleration<R>>(&mut self, tile: Tile<'_, R, A>) -> bool {
        let slots = tile.slots.clone();
        let fresh = tile.write();
        self.combine(slots, read(&fresh.below)).unwrap_or(false)
    }

    fn split(self, slot: u32) -> (Self, Self) {
        let [position, velocity] = self.to.apart().map(|columns| columns.split(slot - self.first));
        (
            Self { to: State::of([position.0, velocity.0]), ..self },
            Self { to: State::of([position.1, velocity.1]), first: slot, ..self },
        )
    }
}

/// p, q and A along one axis.
type Term<'a, R> = (R, R, &'a [R]);

/// Those of a tile.
struct Sums<'a, R> {
    /// x and v.
    from: (Columns<'a, R>, Columns<'a, R>),
    drift: R,
    accelerations: &'a [(R, R, Columns<'a, R>)],
    with_velocity: bool,
    is_checked: bool,
    /// Whether v is added later, with its rounding kept, as x always is where numbers keep any.
    carries_velocity: bool,
}

impl<R: Real> SixColumns<R> for Sums<'_, R> {
    /// Whether they are finite, if that is asked; nothing if a column is too short.
    type Output = Option<bool>;

    #[inline(always)]
    fn run(self, x: &mut [R], y: &mut [R], z: &mut [R], u: &mut [R], v: &mut [R], w: &mut [R]) -> Option<bool> {
        let mut finite = true;
        for (axis, (position, velocity)) in [(x, u), (y, v), (z, w)].into_iter().enumerate() {
            finite &= if self.with_velocity {
                self.along::<true>(axis, position, velocity)?
            } else {
                self.along::<false>(axis, position, velocity)?
            };
        }
        Some(finite)
    }
}

impl<R: Real> Sums<'_, R> {
    #[inline(always)]
    fn along<const VELOCITY: bool>(&self, axis: usize, position: &mut [R], velocity: &mut [R]) -> Option<bool> {
        let count = position.len();
        let (x, v) = (self.from.0.get(axis)?.get(..count)?, self.from.1.get(axis)?.get(..count)?);
        let velocity = velocity.get_mut(..count)?;
        for ((to, x), v) in position.iter_mut().zip(x).zip(v) {
            let drift = self.drift * *v;
            *to = if R::IS_COMPENSATED { drift } else { *x + drift };
        }
        if VELOCITY {
            for (to, v) in velocity.iter_mut().zip(v) {
                *to = if R::IS_COMPENSATED && self.carries_velocity { R::ZERO } else { *v };
            }
        }
        let term = |index: usize| -> Option<Term<'_, R>> {
            let (p, q, columns) = self.accelerations.get(index)?;
            Some((*p, *q, columns.get(axis)?.get(..count)?))
        };
        // Some at a time, so that the sums are not written and read again for each; their order is the same.
        let mut index = 0;
        while let (Some(a), Some(b), Some(c), Some(d)) =
            (term(index), term(index + 1), term(index + 2), term(index + 3))
        {
            add_four::<R, VELOCITY>(position, velocity, [a, b, c, d]);
            index += 4;
        }
        while let Some((p, q, a)) = term(index) {
            for ((x, v), a) in position.iter_mut().zip(&mut *velocity).zip(a) {
                *x += p * *a;
                if VELOCITY {
                    *v += q * *a;
                }
            }
            index += 1;
        }
        let finite = |column: &[R]| column.iter().fold(true, |finite, value| finite & value.is_finite());
        Some(!self.is_checked || finite(position) && (!VELOCITY || finite(velocity)))
    }
}

#[inline(always)]
fn add_four<R: Real, const VELOCITY: bool>(position: &mut [R], velocity: &mut [R], [a, b, c, d]: [Term<'_, R>; 4]) {
    let accelerations = a.2.iter().zip(b.2).zip(c.2.iter().zip(d.2));
    for ((x, v), ((a_i, b_i), (c_i, d_i))) in position.iter_mut().zip(velocity).zip(accelerations) {
        *x = *x + a.0 * *a_i + b.0 * *b_i + c.0 * *c_i + d.0 * *d_i;
        if VELOCITY {
            *v = *v + a.1 * *a_i + b.1 * *b_i + c.1 * *c_i + d.1 * *d_i;
        }
    }
}
