//! How far a run is from what is trusted.

use std::borrow::Borrow;

use super::probe::{State, Vectors};

/// The largest distance between two particles of one number at any checkpoint, m.
pub fn position_error<L: Borrow<State>, R: Borrow<State>>(left: &[L], right: &[R]) -> f64 {
    largest(left, right, |state| &state.positions)
}

/// The largest difference between two velocities of one particle at any checkpoint, m/s.
pub fn velocity_error<L: Borrow<State>, R: Borrow<State>>(left: &[L], right: &[R]) -> f64 {
    largest(left, right, |state| &state.velocities)
}

fn largest<L: Borrow<State>, R: Borrow<State>>(left: &[L], right: &[R], of: fn(&State) -> &Vectors) -> f64 {
    let pairs = left.iter().zip(right).flat_map(|(left, right)| of(left.borrow()).iter().zip(of(right.borrow())));
    let squares = pairs.map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>());
    // What is not a number is no small distance.
    squares.fold(0.0, |largest: f64, square| if square.is_nan() { f64::INFINITY } else { largest.max(square) }).sqrt()
}
