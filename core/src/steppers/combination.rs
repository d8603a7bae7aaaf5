//! From accelerations to the state of a stage, or of the step: what follows tile by tile while they are at hand.

use core::ops::Range;

use crate::Real;
use crate::forces::{Acceleration, Then, Tile};
use crate::lanes::{self, Kernel, Lanes, Set};
use crate::vectors::{Columns, cut, cut_mut, lend, read, split, window};
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
pub struct Combination<'a, R, const STAGES: usize> {
    pub terms: Terms<R, STAGES>,
    /// Whether it is to be finite: only of the step itself, as no sum gets finite again.
    pub is_step: bool,
    pub lanes: Lanes,
    /// x and v, of all slots.
    pub state: (Columns<'a, R>, Columns<'a, R>),
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
        let (x, v) = (cut(self.state.0, tile.clone())?, cut(self.state.1, tile.clone())?);
        let to = tile.start - self.first..tile.end - self.first;
        let position = cut_mut(lend(&mut self.to.position), to.clone())?;
        let velocity = cut_mut(lend(&mut self.to.velocity), to)?;
        let Terms { drift, position: p, velocity: q } = self.terms;
        let is_checked = self.is_step;
        let mut finite = true;
        for (axis, ((to, x), v)) in position.into_iter().zip(x).zip(v).enumerate() {
            let accelerations = accelerations(self.known, fresh, axis, &tile, p)?;
            finite &= lanes::run(self.lanes, Sum { to, from: x, drift: Some((drift, v)), accelerations, is_checked });
        }
        for (axis, ((to, v), q)) in velocity.into_iter().zip(v).zip(q.into_iter().cycle()).enumerate() {
            let accelerations = accelerations(self.known, fresh, axis, &tile, q)?;
            finite &= lanes::run(self.lanes, Sum { to, from: v, drift: None, accelerations, is_checked });
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
        let State { position, velocity } = self.to;
        let (lower_position, upper_position) = split(position, slot - self.first);
        let (lower_velocity, upper_velocity) = split(velocity, slot - self.first);
        (
            Self { to: State { position: lower_position, velocity: lower_velocity }, ..self },
            Self { to: State { position: upper_position, velocity: upper_velocity }, first: slot, ..self },
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
}

impl<R: Real, const STAGES: usize> Kernel for Sum<'_, R, STAGES> {
    /// Whether it is finite, if that is asked.
    type Output = bool;

    #[inline(always)]
    fn run(self, _set: impl Set) -> bool {
        let Self { to, from, drift, accelerations, is_checked } = self;
        match drift {
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
