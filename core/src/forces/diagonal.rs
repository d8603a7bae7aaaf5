//! The hot loop: the springs of a piece of a diagonal.

use core::ops::Range;

use super::law::force_density;
use super::tiles::Forces;
use crate::Real;
use crate::vectors::{Columns, difference, lend, scaled, triples, triples_mut, window, window_mut};
use crate::world::{Law, Piece, Springs, TILE};

/// In place of a piece's presences: no gaps.
static NO_GAPS: [u8; TILE as usize] = [1; TILE as usize];

/// Adds the forces of a piece. Returns how many of its springs have length 0.
#[inline(always)]
pub fn add<R: Real>(springs: &Springs<'_, R>, piece: &Piece, forces: &mut Forces<'_, R>) -> u32 {
    // Where its upper ends come to lie within the slots that are asked for, and where past them.
    let upper = piece.first + piece.offset;
    let inside = forces.slots.start.saturating_sub(upper).min(piece.places)
        ..forces.slots.end.saturating_sub(upper).min(piece.places);
    let beyond = inside.end..piece.places;
    let mut degenerate = 0;
    for places in [inside, beyond] {
        if !places.is_empty() {
            degenerate += add_part(springs, &piece.part(places), forces);
        }
    }
    degenerate
}

/// Adds the forces of a piece whose upper ends lie all within the slots that are asked for, or all past them.
#[inline(always)]
fn add_part<R: Real>(springs: &Springs<'_, R>, piece: &Piece, forces: &mut Forces<'_, R>) -> u32 {
    let law = springs.law(piece.spring);
    let damped = law.damping != R::ZERO;
    if !piece.uniform {
        let range = piece.spring..piece.spring + piece.places;
        let [stiffness, damping, rest_length] =
            window([springs.stiffness, springs.damping, springs.rest_length], range);
        let laws = triples([stiffness, damping, rest_length]);
        let laws = laws.map(|[stiffness, damping, rest_length]| (Law { stiffness, damping, rest_length }, true));
        return pull::<R, true>(laws, piece, forces);
    }
    let Some(presences) = piece.presences else {
        let laws = NO_GAPS.iter().map(|_| (law, true));
        return if damped { pull::<R, true>(laws, piece, forces) } else { pull::<R, false>(laws, piece, forces) };
    };
    let [presences] = window([springs.presences], presences..presences + piece.places);
    let laws = presences.iter().map(|presence| (law, *presence != 0));
    if damped { pull::<R, true>(laws, piece, forces) } else { pull::<R, false>(laws, piece, forces) }
}

/// Adds the forces of springs with these laws at the places where there are some.
#[inline(always)]
fn pull<R: Real, const DAMPED: bool>(
    laws: impl Iterator<Item = (Law<R>, bool)> + Clone,
    piece: &Piece,
    forces: &mut Forces<'_, R>,
) -> u32 {
    let from = |first: u32| -> Range<u32> { first..first + piece.places };
    let (lower, upper) = (from(piece.first), from(piece.first + piece.offset));
    let within = from(piece.first - forces.start);
    let [above_x, above_y, above_z] = window_mut(lend(&mut forces.above), within);
    let [below_x, below_y, below_z] = if upper.end <= forces.slots.end {
        let below = upper.start - forces.slots.start;
        window_mut(lend(&mut forces.below), from(below))
    } else {
        window_mut(lend(&mut forces.nowhere), from(0))
    };
    let (position, velocity) = (forces.position, forces.velocity);
    let position = [window(position, lower.clone()), window(position, upper.clone())];
    let velocity = [window(velocity, lower), window(velocity, upper)];
    let undirected =
        add_places::<R, DAMPED>(laws.clone(), position, velocity, above_x, above_y, above_z, below_x, below_y, below_z);
    if undirected == 0 { 0 } else { count_degenerate(laws, position) }
}

/// Of the places without a direction, those with a spring.
#[cold]
fn count_degenerate<R: Real>(laws: impl Iterator<Item = (Law<R>, bool)>, [x_i, x_j]: [Columns<'_, R>; 2]) -> u32 {
    let places = triples(x_i).zip(triples(x_j)).zip(laws);
    let degenerate = places.filter(|((x_i, x_j), (law, is_there))| {
        *is_there && !force_density::<R, false>(*law, difference(*x_j, *x_i), [R::ZERO; 3]).1
    });
    degenerate.count() as u32
}

/// The loop itself. What it writes are arguments of their own, because only of those does the compiler know that
/// nothing else overlaps them; else it would not vectorise. Returns at how many places there is no direction, with or
/// without a spring: which of those there are is too rare a question to be asked here.
#[allow(clippy::too_many_arguments)]
#[inline(always)]
fn add_places<R: Real, const DAMPED: bool>(
    laws: impl Iterator<Item = (Law<R>, bool)>,
    [x_i, x_j]: [Columns<'_, R>; 2],
    [v_i, v_j]: [Columns<'_, R>; 2],
    above_x: &mut [R],
    above_y: &mut [R],
    above_z: &mut [R],
    below_x: &mut [R],
    below_y: &mut [R],
    below_z: &mut [R],
) -> u32 {
    let states = triples(x_i).zip(triples(x_j)).zip(triples(v_i).zip(triples(v_j)));
    let forces = triples_mut([above_x, above_y, above_z]).zip(triples_mut([below_x, below_y, below_z]));
    let mut undirected = 0;
    for ((((x_i, x_j), (v_i, v_j)), (law, is_there)), (above, below)) in states.zip(laws).zip(forces) {
        let d = difference(x_j, x_i);
        let (q, has_direction) = force_density::<R, DAMPED>(law, d, difference(v_j, v_i));
        let force = scaled(if is_there { q } else { R::ZERO }, d);
        for ((above, below), force) in above.into_iter().zip(below).zip(force) {
            *above += force;
            *below -= force;
        }
        undirected += u32::from(!has_direction);
    }
    undirected
}
