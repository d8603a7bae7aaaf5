//! The problems that every stepper is held against, with values that make none of them special.

use super::Problem;
use super::ball::Ball;
use super::bouncing_oscillator::BouncingOscillator;
use super::chain::{Chain, Ends};
use super::hanging::Hanging;
use super::oscillator::Oscillator;
use super::projectile::projectile;
use super::two_bodies::TwoBodies;

/// All problems without a plane.
#[must_use]
pub fn smooth() -> Vec<Problem> {
    let bodies = TwoBodies::default();
    let damped_bodies = TwoBodies { damping: 1.7, ..bodies };
    let mut problems = vec![
        projectile([1.0, -2.0, 0.5], [3.0, 1.5, 4.0], [0.3, -0.8, -9.81], 2.0),
        bodies.radial(0.2, -0.9),
        damped_bodies.radial(0.2, -0.9),
        bodies.circular(1.1),
        bodies.harmonic([0.5, -0.2, 0.1], [1.0, 2.0, -3.0]),
        Hanging::default().hung(),
        Hanging::default().slung(0.8),
    ];
    for damping_ratio in [0.0, 0.1, 0.5, 1.0, 2.5] {
        let oscillator = Oscillator { damping_ratio, ..Oscillator::default() };
        problems.push(oscillator.problem());
    }
    for damping_ratio in [0.0, 0.2] {
        let vertical = Oscillator { damping_ratio, gravity: 9.81, ..Oscillator::default() };
        problems.push(vertical.problem());
    }
    for ends in [Ends::FixedFixed, Ends::FixedFree, Ends::FreeFree] {
        for (mode, damping) in [(1, 0.0), (3, 0.0), (2, 0.2), (5, 0.2)] {
            problems.push(Chain::new(ends, 6, mode, damping).problem());
        }
    }
    problems
}

/// All problems with one.
#[must_use]
pub fn bouncing() -> Vec<Problem> {
    let mut problems = Vec::new();
    for restitution in [0.0, 0.5, 0.8, 1.0] {
        let dropped = Ball { restitution, ..Ball::default() };
        let thrown = Ball { velocity: [1.3, -0.7, 2.0], ..dropped };
        let inclined = Ball { slope: 0.4, ..thrown };
        problems.extend([dropped, thrown, inclined].map(Ball::problem));
    }
    for equilibrium in [0.08, 0.0, -0.1] {
        for restitution in [0.0, 0.5, 0.8, 1.0] {
            problems.push(BouncingOscillator::new(equilibrium, restitution).problem());
        }
    }
    problems
}
