//! Every bouncing problem, against a reference that finds the impacts itself, and the properties of its ending.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use glam::DVec3;
use hooke_tests::measure;
use hooke_tests::moment::Moment;
use hooke_tests::problems::ball::Ball;
use hooke_tests::problems::{Impact, Problem, bouncing};
use hooke_tests::reference;
use hooke_tests::right_hand_side::RightHandSide;

/// Steps of a reference solution: short beside every flight that is compared.
const STEPS: usize = 400;
/// Only impacts this fast, in m/s, are compared one by one: below, flights are shorter than the reference's steps.
const FAST: f64 = 0.1;
/// A time is known to 1e-16 over the slope of the fall, which is FAST or more; tens of flights add up.
const AGREEMENT: f64 = 1e-11;

#[test]
fn problems_start_where_their_solution_does() {
    for problem in bouncing() {
        let start = Moment::start(&problem.model);
        assert_eq!(start, (problem.exact)(0.0), "{problem:?}");
    }
}

#[test]
fn impacts_and_states_agree_with_the_reference() {
    for problem in bouncing() {
        let (end, exact, impacts) = compare(&problem, &problem);
        let states = measure::position_error(&end, &exact).max(measure::velocity_error(&end, &exact));
        assert!(states < AGREEMENT, "{problem:?}: {states:e}");
        let listed = problem.impacts.iter().filter(|hit| hit.speed > FAST);
        assert_eq!(impacts.len(), listed.count(), "{problem:?}");
        for (found, listed) in impacts.iter().zip(&problem.impacts) {
            assert_eq!((found.particle, found.plane), (listed.particle, listed.plane));
            for (left, right) in
                [(found.time, listed.time), (found.speed, listed.speed), (found.energy_lost, listed.energy_lost)]
            {
                assert!((left - right).abs() < AGREEMENT, "{problem:?}: {found:?}, {listed:?}");
            }
        }
    }
}

#[test]
fn a_wrong_scene_is_noticed() {
    for problem in bouncing() {
        let mut wrong = bouncing().into_iter().find(|other| other.name == problem.name).unwrap();
        for spring in &mut wrong.model.springs {
            spring.stiffness *= 1.01;
        }
        if wrong.model.springs.is_empty() {
            wrong.gravity = (1.01 * DVec3::from(wrong.gravity)).to_array();
        }
        let (end, exact, _) = compare(&wrong, &problem);
        let error = measure::position_error(&end, &exact);
        assert!(error > 1e-5, "{problem:?}: {error:e}");
    }
}

/// Integrates `scene` to a time halfway between two impacts of `problem` (or after the only one that is compared);
/// returns what it found, the exact state of `problem`, and the impacts it found.
fn compare(scene: &Problem, problem: &Problem) -> (Moment, Moment, Vec<Impact>) {
    let fast = problem.impacts.iter().take_while(|hit| hit.speed > FAST).count();
    let time = match problem.impacts.get(fast) {
        Some(next) => 0.5 * (problem.impacts[fast - 1].time + next.time),
        // Restitution 0 leaves the mass lying there, or to a flight that starts from rest: stop short of that.
        None if problem.impacts.len() == 1 => 0.9 * problem.impacts[0].time,
        None => problem.duration,
    };
    let law = RightHandSide::new(&scene.model, scene.gravity);
    let start = Moment::start(&scene.model);
    if problem.impacts.len() == 1 {
        // The reference's own impact, from a run with restitution 1, whose state just after is not compared.
        let mut planes = scene.model.planes.clone();
        planes[0].restitution = 1.0;
        let after = 1.1 * problem.impacts[0].time;
        let (_, mut impacts) = reference::integrate_bouncing(&law, &planes, &start, after, STEPS);
        for impact in &mut impacts {
            let mass = scene.model.particles[impact.particle].mass;
            impact.energy_lost = 0.5 * mass * impact.speed * impact.speed;
        }
        let end = reference::integrate(&law, &start, time, STEPS);
        return (end, (problem.exact)(time), impacts);
    }
    let (end, impacts) = reference::integrate_bouncing(&law, &scene.model.planes, &start, time, STEPS);
    (end, (problem.exact)(time), impacts)
}

/// Position and velocity are continuous but for the normal velocity at an impact, which turns to −e times itself.
#[test]
fn impacts_reverse_the_normal_velocity_and_keep_the_rest() {
    for problem in bouncing() {
        let plane = problem.model.planes[0];
        let normal = DVec3::from(plane.normal);
        for impact in problem.impacts.iter().filter(|hit| hit.speed > FAST) {
            let instant = 1e-9;
            let [before, after] = [-instant, instant].map(|shift| {
                let moment = (problem.exact)(impact.time + shift);
                let vectors = [moment.position, moment.velocity];
                vectors.map(|vectors| DVec3::from(vectors[impact.particle]))
            });
            // In 2e-9 s at 10 m/s and under 100 m/s², nothing moves by more than 2e-8 m or 2e-7 m/s.
            assert!((before[0] - after[0]).length() < 3e-8);
            let gap = normal.dot(before[0] - DVec3::from(plane.point));
            assert!(gap.abs() < 3e-8, "{problem:?}: {gap:e}");
            let turned = before[1] + (1.0 + plane.restitution) * impact.speed * normal;
            assert!((turned - after[1]).length() < 3e-7, "{problem:?}: {impact:?}");
        }
    }
}

/// After the last of endlessly many bounces the particle stays on the plane and slides freely.
#[test]
fn rest_is_on_the_plane() {
    let mut rested = 0;
    for problem in bouncing() {
        let Some(rest) = problem.rest.filter(|rest| *rest < problem.duration) else {
            continue;
        };
        rested += 1;
        let particle = problem.impacts[0].particle;
        let normal = DVec3::from(problem.model.planes[0].normal);
        let end = (problem.exact)(problem.duration);
        assert!(normal.dot(end.position[particle].into()).abs() < 1e-14);
        assert!(normal.dot(end.velocity[particle].into()).abs() < 1e-14);
        // A particle without a spring slides as a projectile whose gravity has lost its normal part.
        if problem.model.springs.is_empty() {
            let gravity = DVec3::from(problem.gravity);
            let slide = gravity - normal * normal.dot(gravity);
            let law = RightHandSide::new(&problem.model, slide.to_array());
            let start = (problem.exact)(rest);
            let found = reference::integrate(&law, &start, problem.duration - rest, STEPS);
            assert!(measure::position_error(&found, &end) < AGREEMENT);
        }
        // All that is gone, the impacts took: nothing else takes energy here.
        let gone = problem.lost_to_damping(problem.duration);
        assert!(gone.abs() < 1e-12, "{problem:?}: {gone:e}");
    }
    assert!(rested >= 8, "the set has problems that come to rest");
}

#[test]
fn energy_changes_at_impacts_only() {
    for problem in bouncing() {
        for number in 0..50 {
            let time = problem.duration * f64::from(number) / 50.0;
            // Energies are a few joules, rounded at 1e-16 in positions and speeds.
            assert!(problem.lost_to_damping(time).abs() < 1e-12, "{problem:?} at {time}");
        }
    }
}

#[test]
fn dropped_ball_follows_the_geometric_series() {
    for restitution in [0.0, 0.5, 0.8, 0.95] {
        let ball = Ball { restitution, duration: 20.0, ..Ball::default() };
        let problem = ball.problem();
        // A sum of up to 500 flights against the closed sum: rounding.
        assert!((problem.rest.unwrap() - ball.end_of_bouncing()).abs() < 1e-12);
        let first = problem.impacts[0].time;
        for (number, impact) in problem.impacts.iter().enumerate() {
            let series = (1.0 - restitution.powi(number as i32)) / (1.0 - restitution);
            let time = first * (1.0 + 2.0 * restitution * series);
            assert!((impact.time - time).abs() < 1e-12);
        }
    }
}
