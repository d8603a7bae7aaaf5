//! Free flight.

use super::{Problem, build, skew};
use crate::moment::Moment;
use glam::DVec3;
use hooke_runner::model::Model;

/// A thrown particle: x = x₀ + v₀ t + ½ g t² (Goldstein, "Classical Mechanics", chapter 1).
///
/// Position in m, velocity in m/s, gravity in m/s², duration in s.
#[must_use]
pub fn projectile(position: [f64; 3], velocity: [f64; 3], gravity: [f64; 3], duration: f64) -> Problem {
    let model = Model { particles: vec![build::free(0.3)], ..Model::default() };
    Problem::new("projectile", model, gravity, duration, move |time| {
        let (x, v) = flight(position, velocity, gravity, time);
        Moment::default().with(x, v)
    })
    .turned(skew())
}

/// Position and velocity of anything whose acceleration is constant.
pub(super) fn flight(
    position: [f64; 3],
    velocity: [f64; 3],
    acceleration: [f64; 3],
    time: f64,
) -> ([f64; 3], [f64; 3]) {
    let [x, v, a] = [position, velocity, acceleration].map(DVec3::from);
    let place = x + time * (v + 0.5 * time * a);
    (place.to_array(), (v + time * a).to_array())
}
