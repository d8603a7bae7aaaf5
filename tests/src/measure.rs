//! How far two states are apart.

use crate::moment::Moment;
use glam::DVec3;

/// The largest distance of any particle between its two positions, m. A NaN is infinitely far.
///
/// # Panics
/// The two states have different numbers of particles.
#[must_use]
pub fn position_error(left: &Moment, right: &Moment) -> f64 {
    largest_distance(&left.position, &right.position)
}

/// The largest difference of any particle between its two velocities, m/s. A NaN is infinitely far.
///
/// # Panics
/// The two states have different numbers of particles.
#[must_use]
pub fn velocity_error(left: &Moment, right: &Moment) -> f64 {
    largest_distance(&left.velocity, &right.velocity)
}

fn largest_distance(left: &[[f64; 3]], right: &[[f64; 3]]) -> f64 {
    assert_eq!(left.len(), right.len(), "as many particles on both sides");
    let distances = left.iter().zip(right).map(|(a, b)| DVec3::from(*a).distance(DVec3::from(*b)));
    // `max` passes over a NaN, and a state that is not a number must not look close.
    distances.fold(0.0, |largest: f64, distance| if distance.is_nan() { f64::INFINITY } else { largest.max(distance) })
}
