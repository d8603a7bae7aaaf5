//! Every exact solution, against an integrator of order 16 on the full force law in three dimensions.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_tests::energy;
use hooke_tests::measure;
use hooke_tests::moment::Moment;
use hooke_tests::problems::hanging::Hanging;
use hooke_tests::problems::two_bodies::TwoBodies;
use hooke_tests::problems::{Problem, smooth};
use hooke_tests::reference;
use hooke_tests::right_hand_side::RightHandSide;

/// Steps of a reference solution: 60 or more a period, of order 16.
const STEPS: usize = 200;
/// Positions and velocities are about 1 in size (the projectile's 20) and 1e4 evaluations are rounded at 1e-16 each.
const AGREEMENT: f64 = 1e-11;

#[test]
fn problems_start_where_their_solution_does() {
    for problem in smooth() {
        let start = Moment::start(&problem.model);
        // Both were turned by the same rotation, in the same arithmetic.
        assert_eq!(start, (problem.exact)(0.0), "{problem:?}");
    }
}

#[test]
fn solutions_agree_with_the_reference() {
    for problem in smooth() {
        for part in [0.3, 1.0] {
            let error = disagreement(&problem, part);
            assert!(error < AGREEMENT, "{problem:?} at {part}: {error:e}");
        }
    }
}

#[test]
fn the_reference_is_converged() {
    for problem in smooth() {
        let law = RightHandSide::new(&problem.model, problem.gravity);
        let start = Moment::start(&problem.model);
        let [coarse, fine] =
            [STEPS, 2 * STEPS].map(|steps| reference::integrate(&law, &start, problem.duration, steps));
        let change = measure::position_error(&coarse, &fine);
        assert!(change < AGREEMENT, "{problem:?}: {change:e}");
    }
}

/// A per cent of stiffness, of mass, or of gravity where there is no spring, must be seen.
/// (A rest length would not do: a chain between two pins swings along itself the same at any tension.)
#[test]
fn a_wrong_scene_is_noticed() {
    for wrong in 0..2 {
        for mut problem in smooth() {
            if problem.model.springs.is_empty() {
                problem.gravity[wrong] *= 1.01;
            } else if wrong == 0 {
                for spring in &mut problem.model.springs {
                    spring.stiffness *= 1.01;
                }
            } else {
                for particle in &mut problem.model.particles {
                    particle.mass *= 1.01;
                }
            }
            let error = disagreement(&problem, 0.3);
            assert!(error > 1e-5, "{problem:?}: {error:e}");
        }
    }
}

#[test]
fn energy_is_kept_or_goes_into_damping() {
    for problem in smooth() {
        let spent = dissipated(&problem);
        let lost = problem.lost_to_damping(problem.duration);
        // Simpson's rule with 3,000 intervals a period errs by some 1e-12 of the energy; energies are joules.
        assert!((lost - spent).abs() < 1e-10, "{problem:?}: {lost:e}, {spent:e}");
    }
}

/// ∫ of the damping power over the duration, along the exact solution, by Simpson's rule.
fn dissipated(problem: &Problem) -> f64 {
    let intervals = 10_000;
    let width = problem.duration / f64::from(intervals);
    let power = |number: i32| {
        let moment = (problem.exact)(f64::from(number) * width);
        energy::damping_power(&problem.model, &moment)
    };
    let inner: f64 = (1..intervals).map(|number| f64::from(2 + 2 * (number % 2)) * power(number)).sum();
    width / 3.0 * (power(0) + inner + power(intervals))
}

#[test]
fn hanging_chain_reaches_its_stated_depth() {
    let chain = Hanging::default();
    let problem = chain.hung();
    let tip = glam::DVec3::from(*Moment::start(&problem.model).position.last().unwrap());
    // A sum of eight extensions against the closed sum: rounding.
    assert!((tip.length() - chain.depth()).abs() < 1e-14);
}

/// A circle pushed outwards by ε breathes as ε/κ sin κt, but for terms of ε².
#[test]
fn disturbed_circle_breathes_at_the_epicyclic_frequency() {
    let (bodies, radius, push) = (TwoBodies::default(), 1.1, 1e-6);
    let problem = bodies.circular(radius);
    let law = RightHandSide::new(&problem.model, problem.gravity);
    let mut start = Moment::start(&problem.model);
    let apart = separation(&start).normalize();
    // Both masses are pushed so that the centre of mass keeps its velocity.
    let [m0, m1] = bodies.masses;
    for (velocity, part) in start.velocity.iter_mut().zip([-m1, m0]) {
        *velocity = (glam::DVec3::from(*velocity) + part / (m0 + m1) * push * apart).to_array();
    }
    let epicyclic = bodies.epicyclic_frequency(radius);
    for time in [0.05, 0.21, 0.4] {
        let after = reference::integrate(&law, &start, time, STEPS);
        let swing = separation(&after).length() - radius;
        let expected = push / epicyclic * (epicyclic * time).sin();
        // ε² terms are 1e-6 of the swing and 1e-16 of rounding is 1e-9 of it; a wrong frequency shows at 1e-2.
        assert!((swing - expected).abs() < 1e-5 * push / epicyclic);
    }
}

fn separation(moment: &Moment) -> glam::DVec3 {
    glam::DVec3::from(moment.position[1]) - glam::DVec3::from(moment.position[0])
}

/// The larger of the errors in position (m) and velocity (m/s) after a part of the duration.
fn disagreement(problem: &Problem, part: f64) -> f64 {
    let law = RightHandSide::new(&problem.model, problem.gravity);
    let time = part * problem.duration;
    let found = reference::integrate(&law, &Moment::start(&problem.model), time, STEPS);
    let exact = (problem.exact)(time);
    measure::position_error(&found, &exact).max(measure::velocity_error(&found, &exact))
}
