//! A particle without springs flies exactly from plane to plane under `auto`, through endless bounces to rest.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::bounce_runs::run;
use hooke_tests::measure::{position_error, velocity_error};
use hooke_tests::problems::ball::Ball;
use hooke_tests::problems::{Problem, bouncing};

/// Rounding: some hundred operations on numbers of size 10, and a time that is known to 1e-16 of it.
const ROUNDING: f64 = 1e-13;

fn balls() -> impl Iterator<Item = Problem> {
    bouncing().into_iter().filter(|problem| problem.model.springs.is_empty())
}

/// The largest error of position and velocity at eleven times, none of which is that of an impact.
fn worst(problem: &Problem, dt: f64) -> f64 {
    let errors = (1..=11).map(|part| {
        let time = problem.duration * f64::from(part) / 11.0;
        let outcome = run(problem, StepperName::Auto, CollisionForm::TimeOfImpact, dt, time);
        let exact = (problem.exact)(time);
        position_error(&outcome.moment, &exact).max(velocity_error(&outcome.moment, &exact))
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn bounces_are_exact_whatever_the_step() {
    for problem in balls() {
        for dt in [problem.duration, 1.0 / 60.0, 1e-3] {
            let error = worst(&problem, dt);
            assert!(error <= ROUNDING, "{} by {dt} s: {error:e}", problem.name);
        }
    }
}

#[test]
fn more_than_twenty_bounces_are_right_to_1e_10_and_end_in_rest() {
    for (restitution, slope) in [(0.5, 0.0), (0.8, 0.0), (0.9, 0.3)] {
        let ball = Ball { restitution, slope, ..Ball::default() };
        let mut problem = ball.problem();
        let rest = problem.rest.expect("a lossy ball comes to rest");
        problem = Ball { duration: 1.1 * rest, ..ball }.problem();
        assert!(problem.impacts.len() >= 20, "{} impacts", problem.impacts.len());
        for impact in problem.impacts.iter().take(40) {
            // Half-way up from an impact nothing is about to happen: the state there tells of all before.
            let time = impact.time + 0.5 * restitution * impact.speed / 9.81;
            let outcome = run(&problem, StepperName::Auto, CollisionForm::TimeOfImpact, 1.0 / 60.0, time);
            let error = position_error(&outcome.moment, &(problem.exact)(time));
            assert!(error <= 1e-10, "{} after the impact at {}: {error:e}", problem.name, impact.time);
        }
        let end = run(&problem, StepperName::Auto, CollisionForm::TimeOfImpact, 1.0 / 60.0, problem.duration);
        let exact = (problem.exact)(problem.duration);
        assert!(position_error(&end.moment, &exact) <= 1e-10, "{} at rest", problem.name);
        assert!(velocity_error(&end.moment, &exact) <= 1e-10, "{} at rest", problem.name);
        assert_eq!(end.report.capped, 0);
    }
}

#[test]
fn the_ledger_of_exact_flight_has_no_remainder() {
    for problem in balls() {
        let outcome = run(&problem, StepperName::Auto, CollisionForm::TimeOfImpact, 1.0 / 60.0, problem.duration);
        let (balance, name) = (outcome.balance, &problem.name);
        assert!(balance.remainder().abs() <= 1e-12 * balance.scale(), "{name}: {:e}", balance.remainder());
        let lost = problem.lost_in_impacts(problem.duration);
        assert!((balance.lost_in_impacts - lost).abs() <= 1e-12 * balance.scale(), "{name}: lost {lost}");
    }
}

#[test]
fn a_wrong_restitution_is_noticed() {
    let problem = Ball { restitution: 0.8, ..Ball::default() }.problem();
    let mut wrong = Ball { restitution: 0.8, ..Ball::default() }.problem();
    wrong.model.planes[0].restitution = 0.8001;
    assert!(worst(&problem, 0.1) <= ROUNDING);
    assert!(worst(&wrong, 0.1) > 1e-5, "the test cannot tell 0.8 from 0.8001");
}

#[test]
fn stepping_by_euler_is_not_exact() {
    let problem = Ball { restitution: 0.8, ..Ball::default() }.problem();
    let outcome =
        run(&problem, StepperName::SemiImplicitEuler, CollisionForm::TimeOfImpact, 1e-3, 0.9 * problem.duration);
    assert!(position_error(&outcome.moment, &(problem.exact)(0.9 * problem.duration)) > 1e-4);
}
