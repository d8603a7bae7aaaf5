//! From accelerations to the state of a stage, or of the step: what follows tile by tile while they are at hand.

use core::ops::Range;

use crate::Real;
use crate::carried::Carried;
use crate::forces::{Acceleration, Then, Tile};
use crate::lanes::{self, Kernel, Lanes, Set};
use crate::vectors::{Columns, cut, lend, read, triples, window};
use crate::world::{State, tiles};

/// x + h v + Σ pⱼ Aⱼ and v + Σ qⱼ Aⱼ.
#[derive(Clone, Copy)]
pub struct Terms<R, const STAGES: usize> {
    /// h, s
    pub drift: R,
    /// p, s²
    pub position: [R; STAGES],
    /// q, s; nothing where nobody asks for the velocity.
    pub velocity: Option<[R; STAGES]>,
}

/// Writes such a state, once the last of the accelerations is known.
pub struct Combination<'a, R: Real, const STAGES: usize> {
    pub terms: Terms<R, STAGES>,
    /// Whether it is to be finite: only of the step itself, as no sum gets finite again.
    pub is_step: bool,
    /// Whether its velocity is carried on, with what rounding takes from it.
    pub carries_velocity: bool,
    pub lanes: Lanes,
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
        let Terms { drift, position: p, velocity: q } = self.terms;
        let is_checked = self.is_step;
        let mut finite = true;
        for (axis, ((to, from), v)) in lend(&mut position.value).into_iter().zip(x.value).zip(v.value).enumerate() {
            let accelerations = accelerations(self.known, fresh, axis, &tile, p)?;
            finite &= lanes::run(
                self.lanes,
                Sum { to, from, drift: Some((drift, v)), accelerations, is_checked, is_carried: true },
            );
        }
        for (axis, ((to, from), q)) in
            lend(&mut velocity.value).into_iter().zip(v.value).zip(q.into_iter().cycle()).enumerate()
        {
            let accelerations = accelerations(self.known, fresh, axis, &tile, q)?;
            let is_carried = self.carries_velocity;
            finite &= lanes::run(self.lanes, Sum { to, from, drift: None, accelerations, is_checked, is_carried });
        }
        if R::IS_COMPENSATED {
            // What has been summed up is the increment.
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

/// Accelerations along one axis, with what each is multiplied by: those that count.
#[derive(Clone, Copy)]
struct Accelerations<'a, R, const STAGES: usize> {
    terms: [(R, &'a [R]); STAGES],
    count: usize,
}

/// Nothing if a column is too short.
fn accelerations<'a, R: Real, const STAGES: usize>(
    known: &[Columns<'a, R>],
    fresh: Columns<'a, R>,
    axis: usize,
    tile: &Range<u32>,
    factors: [R; STAGES],
) -> Option<Accelerations<'a, R, STAGES>> {
    let mut found = Accelerations { terms: [(R::ZERO, [].as_slice()); STAGES], count: 0 };
    let fresh = [*fresh.get(axis)?];
    let columns = known.iter().map(|columns| cut([*columns.get(axis)?], tile.clone()));
    for (column, factor) in columns.chain([Some(fresh)]).zip(factors) {
        let [column] = column?;
        if factor != R::ZERO {
            *found.terms.get_mut(found.count)? = (factor, column);
            found.count += 1;
        }
    }
    Some(found)
}

/// Along one axis of a tile.
struct Sum<'a, R, const STAGES: usize> {
    to: &'a mut [R],
    from: &'a [R],
    /// h and v
    drift: Option<(R, &'a [R])>,
    accelerations: Accelerations<'a, R, STAGES>,
    is_checked: bool,
    /// Whether the rounding of the sum is kept, if numbers keep any.
    is_carried: bool,
}

impl<R: Real, const STAGES: usize> Kernel for Sum<'_, R, STAGES> {
    /// Whether it is finite, if that is asked.
    type Output = bool;

    #[inline(always)]
    fn run(self, _set: impl Set) -> bool {
        let Self { to, from, drift, accelerations, is_checked, is_carried } = self;
        match drift {
            // What is to be added with its rounding kept is added at the end.
            Some((h, v)) if R::IS_COMPENSATED && is_carried => {
                for (to, v) in to.iter_mut().zip(v) {
                    *to = h * *v;
                }
            }
            None if R::IS_COMPENSATED && is_carried => to.fill(R::ZERO),
            Some((h, v)) => {
                for ((to, from), v) in to.iter_mut().zip(from).zip(v) {
                    *to = *from + h * *v;
                }
            }
            None => to.copy_from_slice(from.get(..to.len()).unwrap_or_default()),
        }
        let terms = accelerations.terms.get(..accelerations.count).unwrap_or_default();
        // Some at a time, so that the sum is not written and read again for each; its order is the same.
        let (fours, rest) = terms.as_chunks::<4>();
        for [(p, a), (q, b), (r, c), (s, d)] in fours {
            for ((((to, a), b), c), d) in to.iter_mut().zip(*a).zip(*b).zip(*c).zip(*d) {
                *to = *to + *p * *a + *q * *b + *r * *c + *s * *d;
            }
        }
        for (p, a) in rest {
            for (to, a) in to.iter_mut().zip(*a) {
                *to += *p * *a;
            }
        }
        !is_checked || to.iter().fold(true, |finite, value| finite & value.is_finite())
    }
}
