//! The small yardsticks: distances, orders of accuracy, the root of implicit Euler's equation.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_tests::measure;
use hooke_tests::moment::Moment;
use hooke_tests::order;
use hooke_tests::problems::chain::{Chain, Ends};
use hooke_tests::problems::hanging::Hanging;
use hooke_tests::problems::oscillator::Oscillator;
use hooke_tests::problems::two_bodies::TwoBodies;
use hooke_tests::problems::{Problem, skew};
use hooke_tests::right_hand_side::RightHandSide;
use hooke_tests::root;

#[test]
fn errors_are_distances_and_nan_is_far() {
    let here = Moment::default().with([0.0; 3], [1.0, 0.0, 0.0]).with([1.0; 3], [0.0; 3]);
    let there = Moment::default().with([3.0, 0.0, 4.0], [1.0, 0.0, 0.0]).with([1.0; 3], [0.0, 0.5, 0.0]);
    assert_eq!(measure::position_error(&here, &there), 5.0);
    assert_eq!(measure::velocity_error(&here, &there), 0.5);
    let nowhere = Moment::default().with([f64::NAN; 3], [0.0; 3]).with([1.0; 3], [0.0; 3]);
    assert_eq!(measure::position_error(&here, &nowhere), f64::INFINITY);
}

#[test]
fn order_is_the_slope_and_no_error_is_no_order() {
    let time_steps = [0.1, 0.03, 0.01];
    let order = order::observed(&time_steps, |dt| 7.0 * dt.powi(3));
    // Rounding of the logarithms alone.
    assert!((order.slope - 3.0).abs() < 1e-12);
    assert!(order.pairwise.iter().all(|slope| (slope - 3.0).abs() < 1e-12));
    assert_eq!(order.errors.len(), 3);
    assert!(order::observed(&time_steps, |_| 0.0).slope.is_nan());
}

/// On a straight spring implicit Euler is v' = (v − h ω x)/(1 + 2ζh + h²), h = ω dt, and x' = x + dt v'.
#[test]
fn root_on_the_damped_oscillator_is_the_closed_form() {
    for damping_ratio in [0.0, 0.2, 3.0] {
        for time_step in [1e-4, 1e-2, 1.0, 30.0] {
            let oscillator = Oscillator { damping_ratio, ..Oscillator::default() };
            let problem = oscillator.problem();
            let root = solve(&problem, time_step);
            let omega = oscillator.frequency();
            let h = omega * time_step;
            let v =
                (oscillator.velocity - h * omega * oscillator.displacement) / (1.0 + 2.0 * damping_ratio * h + h * h);
            let x = oscillator.rest_length + oscillator.displacement + time_step * v;
            let along = skew() * glam::DVec3::X;
            let expected =
                Moment::default().with([0.0; 3], [0.0; 3]).with((x * along).to_array(), (v * along).to_array());
            // Positions near 1 m are rounded at 1e-16; dt k/m of that is what velocities lose, and 1 + h² divides it again.
            assert!(measure::position_error(&root.moment, &expected) < 1e-14);
            assert!(measure::velocity_error(&root.moment, &expected) < 1e-14);
        }
    }
}

/// Many masses, large rotations, damping: no closed form, so the equation itself is the witness.
#[test]
fn root_solves_the_equation() {
    let bodies = TwoBodies { damping: 1.7, ..TwoBodies::default() };
    let hanging = Hanging { masses: 20, damping: 0.3, ..Hanging::default() };
    let mut slung = hanging.slung(1.5);
    // Out of equilibrium: every third mass is kicked sideways, hard enough to turn its springs.
    for particle in slung.model.particles.iter_mut().skip(1).step_by(3) {
        particle.velocity = [2.0, -3.0, 1.0];
    }
    let problems = [bodies.circular(1.1), Chain::new(Ends::FixedFixed, 12, 4, 0.2).problem(), slung];
    for problem in &problems {
        for time_step in [1e-3, 1e-2, 1e-1, 1.0] {
            let root = solve(problem, time_step);
            // Forces k x/m dt of some 1e3 m/s at dt = 1 s are rounded at 1e-13.
            assert!(root.residual < 1e-11, "{problem:?}, {time_step}: {root:?}");
        }
    }
}

/// At small steps the root is the problem's own solution, to first order.
#[test]
fn root_steps_converge_at_order_one() {
    let bodies = TwoBodies { damping: 1.7, ..TwoBodies::default() };
    let problem = bodies.circular(1.1);
    let law = RightHandSide::new(&problem.model, problem.gravity);
    let duration = 0.2;
    let order = order::observed(&[2e-3, 1e-3, 5e-4], |dt| {
        let mut moment = Moment::start(&problem.model);
        for _ in 0..(duration / dt).round() as usize {
            moment = root::implicit_euler(&law, &moment, dt).unwrap().moment;
        }
        measure::position_error(&moment, &(problem.exact)(duration))
    });
    // The error's next term is smaller by ω dt, 0.02 at most.
    assert!((order.slope - 1.0).abs() < 0.05, "{order:?}");
}

/// A mass thrown hard enough at its pin may land on either side of it, and the guess decides.
#[test]
fn root_is_not_unique_at_large_steps() {
    let problem = Oscillator::default().problem();
    let law = RightHandSide::new(&problem.model, problem.gravity);
    let start = Moment::start(&problem.model);
    let followed = solve(&problem, 1.0);
    let nearest = root::implicit_euler_near(&law, &start, 1.0, &start).unwrap();
    let again = root::implicit_euler_near(&law, &start, 1.0, &followed.moment).unwrap();
    assert!(followed.residual < 1e-11 && nearest.residual < 1e-11);
    // Opposite points of a sphere of radius 0.7 m.
    assert!(measure::position_error(&followed.moment, &nearest.moment) > 1.0);
    assert!(measure::position_error(&followed.moment, &again.moment) < 1e-13);
}

fn solve(problem: &Problem, time_step: f64) -> root::Root {
    let law = RightHandSide::new(&problem.model, problem.gravity);
    root::implicit_euler(&law, &Moment::start(&problem.model), time_step).unwrap()
}
