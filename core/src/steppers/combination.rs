//! From accelerations to the state of a stage, or of the step: what follows tile by tile while they are at hand.

use core::ops::Range;

use super::stage_sums::Sums;
use crate::Real;
use crate::carried::Carried;
use crate::compiled::HotLoops;
use crate::forces::{Follow, Then, Tile};
use crate::lanes::Present;
use crate::vectors::{Columns, triples, window};
use crate::world::{State, tiles};

/// x + h v + Σ pⱼ Aⱼ and v + Σ qⱼ Aⱼ.
#[derive(Clone, Copy)]
pub struct Terms<'a, R> {
    /// h, s
    pub drift: R,
    /// p, s²
    pub position: Factors<'a>,
    /// q, s; nothing where nobody asks for the velocity.
    pub velocity: Option<Factors<'a>>,
}

impl<R: Real> Terms<'_, R> {
    /// p and q of one stage.
    #[inline(always)]
    pub fn of(&self, stage: usize) -> (R, R) {
        (self.position.of(stage), self.velocity.map_or(R::ZERO, |velocity| velocity.of(stage)))
    }
}

/// The most stages that anybody combines.
pub const MOST_STAGES: usize = 16;

/// Coefficients, at most [`MOST_STAGES`], each times a scale.
#[derive(Clone, Copy)]
pub struct Factors<'a> {
    pub scale: f64,
    pub coefficients: &'a [f64],
}

impl Factors<'_> {
    /// That of one stage.
    #[inline(always)]
    fn of<R: Real>(&self, stage: usize) -> R {
        R::from_f64(self.scale * self.coefficients.get(stage).copied().unwrap_or_default())
    }
}

/// Writes such a state, once the last of the accelerations is known.
pub struct Combination<'a, R: Real> {
    pub terms: Terms<'a, R>,
    /// Whether it is to be finite: only of the step itself, as no sum gets finite again.
    pub is_step: bool,
    /// Whether its velocity is carried on, with what rounding takes from it.
    pub carries_velocity: bool,
    pub lanes: Present,
    /// x and v, of all slots.
    pub state: &'a (Carried<'a, R>, Carried<'a, R>),
    /// The accelerations before the last one, of all slots.
    pub known: &'a [Columns<'a, R>],
    /// The slot that what is written begins with.
    pub first: u32,
    pub to: State<'a, R>,
}

impl<R: Real> Combination<'_, R> {
    /// Of so many particles, the last acceleration being known as well. Returns whether it is finite, if that is asked.
    pub fn of_known(mut self, particles: u32, last: Columns<'_, R>) -> bool {
        tiles(0..particles).fold(true, |finite, tile| {
            let fresh = window(last, tile.clone());
            self.combine(tile, fresh).unwrap_or(false) & finite
        })
    }

    /// Nothing if a column is too short.
    fn combine(&mut self, tile: Range<u32>, fresh: Columns<'_, R>) -> Option<bool> {
        let lanes = self.lanes;
        let mut finite = R::Loops::sum(lanes, Sums { combination: self, tile: tile.clone(), fresh })?;
        if R::IS_COMPENSATED {
            let (x, v) = (self.state.0.cut(tile.clone())?, self.state.1.cut(tile.clone())?);
            let to = tile.start - self.first..tile.end - self.first;
            let [position, velocity] = self.to.lend().apart();
            finite &= position.cut(to.clone())?.add(lanes, x, triples(x.value).map(|_| |sum| sum));
            if self.carries_velocity {
                finite &= velocity.cut(to)?.add(lanes, v, triples(v.value).map(|_| |sum| sum));
            }
        }
        Some(finite)
    }
}

impl<R: Real> Then<R> for Combination<'_, R> {
    fn then(&mut self, mut tile: Tile<'_, R>) -> bool {
        let slots = tile.slots.clone();
        self.combine(slots, tile.fresh()).unwrap_or(false)
    }
}

impl<R: Real> Follow<R> for Combination<'_, R> {
    fn split(self, slot: u32) -> (Self, Self) {
        let [position, velocity] = self.to.apart().map(|columns| columns.split(slot - self.first));
        (
            Self { to: State::of([position.0, velocity.0]), ..self },
            Self { to: State::of([position.1, velocity.1]), first: slot, ..self },
        )
    }
}
