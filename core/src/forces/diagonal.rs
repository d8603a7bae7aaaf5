//! The hot loop: the springs of a piece of a diagonal.

use core::marker::PhantomData;
use core::ops::Range;

use super::law::{Elastic, Tension};
use super::tiles::{Forces, States};
use crate::Real;
use crate::carried::{Carried, corrected};
use crate::lanes::{self, SixColumns};
use crate::vectors::{cut, cut_mut, difference, lend, part, scaled, stretch, triples, triples_mut};
use crate::world::{Law, Piece, Springs, TILE};

/// In place of a piece's presences: no gaps.
static NO_GAPS: [u8; TILE as usize] = [1; TILE as usize];

/// Adds the forces of a piece. Returns how many of its springs have length 0.
#[inline(always)]
pub fn add<R: Real, F: Tension>(springs: &Springs<'_, R>, piece: &Piece, forces: &mut Forces<'_, R>) -> u32 {
    // First the places whose upper ends lie within the slots that are asked for, then those where they lie past them.
    let upper = piece.first + piece.offset;
    let before = forces.slots.start.saturating_sub(upper).min(piece.places);
    let inside = forces.slots.end.saturating_sub(upper).min(piece.places);
    let mut places = before..inside;
    let mut degenerate = 0;
    loop {
        if !places.is_empty() {
            degenerate += add_part::<R, F>(springs, &piece.part(places.clone()), forces).unwrap_or_default();
        }
        if places.end == piece.places {
            return degenerate;
        }
        places = places.end..piece.places;
    }
}

/// Adds the forces of a piece whose upper ends lie all within the slots that are asked for, or all past them.
#[inline(always)]
fn add_part<R: Real, F: Tension>(springs: &Springs<'_, R>, piece: &Piece, forces: &mut Forces<'_, R>) -> Option<u32> {
    let law = springs.law(piece.spring);
    let damped = law.damping != R::ZERO;
    if piece.uniform && !damped && !F::PULLS_UNDAMPED {
        return Some(0);
    }
    if !piece.uniform {
        let range = piece.spring..piece.spring + piece.places;
        let laws = cut([springs.stiffness, springs.damping, springs.rest_length], range)?;
        let laws = triples(laws);
        let laws = laws.map(|[stiffness, damping, rest_length]| (Law { stiffness, damping, rest_length }, true));
        return pull::<R, F>(laws, piece, forces);
    }
    let presences = match piece.presences {
        None if !cfg!(feature = "compact") => {
            let laws = NO_GAPS.get(..piece.places as usize)?.iter().map(|_| (law, true));
            return pull_damped_or_not::<R, F>(damped, laws, piece, forces);
        }
        None => NO_GAPS.get(..piece.places as usize)?,
        Some(first) => part(springs.presences, first..first + piece.places)?,
    };
    pull_damped_or_not::<R, F>(damped, presences.iter().map(|presence| (law, *presence != 0)), piece, forces)
}

/// The same, without damping where there is none, unless the program is to be compact.
#[inline(always)]
fn pull_damped_or_not<R: Real, F: Tension>(
    damped: bool,
    laws: impl Iterator<Item = (Law<R>, bool)> + Clone,
    piece: &Piece,
    forces: &mut Forces<'_, R>,
) -> Option<u32> {
    if damped || cfg!(feature = "compact") {
        pull::<R, F>(laws, piece, forces)
    } else {
        pull::<R, F::Undamped>(laws, piece, forces)
    }
}

/// Adds the forces of springs with these laws at the places where there are some.
#[inline(always)]
fn pull<R: Real, F: Tension>(
    laws: impl Iterator<Item = (Law<R>, bool)> + Clone,
    piece: &Piece,
    forces: &mut Forces<'_, R>,
) -> Option<u32> {
    let from = |first: u32| -> Range<u32> { first..first + piece.places };
    let (lower, upper) = (from(piece.first), from(piece.first + piece.offset));
    let [above_x, above_y, above_z] = cut_mut(lend(&mut forces.above), from(piece.first - forces.start))?;
    let [below_x, below_y, below_z] = if upper.end <= forces.slots.end {
        cut_mut(lend(&mut forces.below), from(upper.start - forces.slots.start))?
    } else {
        let nowhere = forces.nowhere.as_deref_mut()?;
        cut_mut(nowhere.each_mut().map(<[R; TILE as usize]>::as_mut_slice), from(0))?
    };
    let states = forces.states;
    let places =
        Places::<R, _, F> { laws: laws.clone(), states, lower: lower.start, upper: upper.start, tension: PhantomData };
    let undirected = lanes::run_on_six(forces.lanes, places, above_x, above_y, above_z, below_x, below_y, below_z)?;
    if undirected == 0 {
        return Some(0);
    }
    Some(count_degenerate(laws, [states.position.cut(lower)?, states.position.cut(upper)?]))
}

/// Of the places without a direction, those with a spring.
#[cold]
fn count_degenerate<R: Real>(laws: impl Iterator<Item = (Law<R>, bool)>, position: [Carried<'_, R>; 2]) -> u32 {
    let places = differences(position).zip(laws);
    let degenerate =
        places.filter(|(d, (law, is_there))| *is_there && !Elastic::force_density(*law, *d, [R::ZERO; 3]).1);
    degenerate.count() as u32
}

/// d = x_j − x_i
#[inline(always)]
fn differences<'a, R: Real>([x_i, x_j]: [Carried<'a, R>; 2]) -> impl Iterator<Item = [R; 3]> + 'a {
    let values = triples(x_i.value).zip(triples(x_j.value));
    let residuals = triples(x_i.residual).zip(triples(x_j.residual));
    values.zip(residuals).map(|((x_i, x_j), (r_i, r_j))| corrected(difference(x_j, x_i), r_j, r_i))
}

/// The places of a piece, each with or without a spring.
struct Places<'a, R: Real, I, F> {
    laws: I,
    states: &'a States<'a, R>,
    /// The first slots of the lower and of the upper ends.
    lower: u32,
    upper: u32,
    tension: PhantomData<F>,
}

impl<R: Real, I: Iterator<Item = (Law<R>, bool)>, F: Tension> SixColumns<R> for Places<'_, R, I, F> {
    type Output = Option<u32>;

    /// The loop itself. Returns at how many places there is no direction, with or without a spring: which of those there
    /// are is too rare a question to be asked here. Nothing if a column is too short.
    #[inline(always)]
    fn run(
        self,
        above_x: &mut [R],
        above_y: &mut [R],
        above_z: &mut [R],
        below_x: &mut [R],
        below_y: &mut [R],
        below_z: &mut [R],
    ) -> Option<u32> {
        let (States { position, velocity }, count) = (self.states, above_x.len());
        let position = [position.stretch(self.lower, count)?, position.stretch(self.upper, count)?];
        let (v_i, v_j) = (stretch(*velocity, self.lower, count)?, stretch(*velocity, self.upper, count)?);
        let (above_y, above_z) = (above_y.get_mut(..count)?, above_z.get_mut(..count)?);
        let (below_x, below_y) = (below_x.get_mut(..count)?, below_y.get_mut(..count)?);
        let below_z = below_z.get_mut(..count)?;
        let states = differences(position).zip(triples(v_i).zip(triples(v_j)));
        let forces = triples_mut([above_x, above_y, above_z]).zip(triples_mut([below_x, below_y, below_z]));
        let mut undirected = 0;
        for (((d, (v_i, v_j)), (law, is_there)), (above, below)) in states.zip(self.laws).zip(forces) {
            let (q, has_direction) = F::force_density(law, d, difference(v_j, v_i));
            let force = scaled(if is_there { q } else { R::ZERO }, d);
            for ((above, below), force) in above.into_iter().zip(below).zip(force) {
                *above += force;
                *below -= force;
            }
            undirected += u32::from(!has_direction);
        }
        Some(undirected)
    }
}
