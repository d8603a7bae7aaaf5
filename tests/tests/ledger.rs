//! The energy ledger: what it counts is what the closed forms say, and what it leaves is the integrator's own error.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{Fixed, Ledger, Particle, Project, Spring, TimeOfImpact, VelocityVerlet, World};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::bounce_runs::run;
use hooke_tests::order::observed;
use hooke_tests::problems::ball::Ball;
use hooke_tests::problems::{Problem, smooth};

type Storage = Fixed<4, 4, 1>;

fn damped() -> impl Iterator<Item = Problem> {
    smooth().into_iter().filter(|problem| problem.model.springs.iter().any(|spring| spring.damping > 0.0))
}

#[test]
fn damping_takes_what_the_closed_form_says() {
    for problem in damped() {
        let end = problem.duration;
        let exact = problem.lost_to_damping(end);
        let largest = 0.02 * time_scale(&problem);
        let order = observed(&[largest, 0.5 * largest, 0.25 * largest, 0.125 * largest], |dt| {
            let balance = run(&problem, StepperName::VelocityVerlet, CollisionForm::TimeOfImpact, dt, end).balance;
            (balance.lost_to_damping - exact).abs() / exact
        });
        assert!((1.85..2.2).contains(&order.slope), "{}: {order:?}", problem.name);
        assert!(order.errors[3] < 1e-4, "{}: {order:?}", problem.name);
    }
}

/// √(m/k) of the stiffest spring at the lightest particle, s.
fn time_scale(problem: &Problem) -> f64 {
    let stiffest = problem.model.springs.iter().map(|spring| spring.stiffness).fold(0.0, f64::max);
    let lightest = problem.model.particles.iter().map(|particle| particle.mass).fold(f64::INFINITY, f64::min);
    (lightest / stiffest).sqrt()
}

#[test]
fn the_remainder_is_of_the_steppers_order() {
    let steppers = [
        (StepperName::VelocityVerlet, 2.0),
        (StepperName::SemiImplicitEuler, 1.0),
        (StepperName::ExplicitEuler, 1.0),
        (StepperName::ImplicitEuler, 1.0),
    ];
    for problem in damped() {
        for (stepper, expected) in steppers {
            let largest = if expected > 1.5 { 0.02 } else { 0.004 } * time_scale(&problem);
            let end = 0.3 * problem.duration;
            let order = observed(&[largest, 0.5 * largest, 0.25 * largest], |dt| {
                let balance = run(&problem, stepper, CollisionForm::TimeOfImpact, dt, end).balance;
                balance.remainder().abs() / balance.scale()
            });
            // Where first-order parts nearly cancel it may fall faster, never more slowly.
            assert!(order.slope > expected - 0.15, "{stepper} on {}: {order:?}", problem.name);
        }
    }
}

/// A hand that pulls a damped spring, whose other end is pinned, at a constant speed u: its work is
/// ½ k (u t)² + k_d u² t, of which the spring keeps the first part. The trapezoidal rule is exact for it.
#[test]
fn the_work_of_a_pin_is_what_the_closed_form_says() {
    let (stiffness, damping, speed, time) = (30.0, 2.0, 0.4, 1.5);
    let mut world = World::<f64, 4, 4, 1>::new();
    let wall = world.add_particle(Particle::at([0.0; 3]).pinned()).unwrap();
    let hand = world.add_particle(Particle::at([0.0, 0.0, 1.0]).with_velocity([0.0, 0.0, speed]).kinematic()).unwrap();
    world.add_spring(Spring::new([wall, hand], stiffness, 1.0).with_damping(damping)).unwrap();
    let mut verlet = VelocityVerlet::<f64, Storage>::new();
    let mut ledger = Ledger::open(&world.view());
    for _ in 0..150 {
        world.view().step_observed(&mut verlet, &mut Project, time / 150.0, &mut ledger).unwrap();
    }
    let balance = ledger.balance(&world.view());
    let (kept, lost) = (0.5 * stiffness * (speed * time).powi(2), damping * speed * speed * time);
    assert!((balance.work_of_pins - kept - lost).abs() < 1e-12, "{balance:?}");
    assert!((balance.lost_to_damping - lost).abs() < 1e-12);
    assert!((balance.elastic - kept).abs() < 1e-12);
    assert!(balance.remainder().abs() < 1e-12);
}

/// Putting a particle back on a plane lifts it: that energy is the impact's, not the integrator's. What the integrator
/// itself does to a ball in free flight is exact, so nothing is left.
#[test]
fn putting_back_on_a_plane_counts_with_the_impact() {
    for restitution in [0.0, 0.5, 1.0] {
        let problem = Ball { restitution, ..Ball::default() }.problem();
        for collision in [CollisionForm::Project, CollisionForm::Reflect] {
            let balance = run(&problem, StepperName::VelocityVerlet, collision, 1e-2, problem.duration).balance;
            assert!(balance.remainder().abs() < 1e-12 * balance.scale(), "{collision} {restitution}: {balance:?}");
        }
    }
}

/// Without what damping takes, or with another stiffness, the balance would not close: the test would see it.
#[test]
fn a_missing_loss_is_noticed() {
    for problem in damped() {
        let dt = 0.0025 * time_scale(&problem);
        let balance =
            run(&problem, StepperName::VelocityVerlet, CollisionForm::TimeOfImpact, dt, problem.duration).balance;
        assert!(balance.remainder().abs() < 1e-4 * balance.scale(), "{}: {balance:?}", problem.name);
        let without = balance.remainder() - balance.lost_to_damping;
        assert!(without.abs() > 1e-3 * balance.scale(), "{}: {balance:?}", problem.name);
    }
}

/// A step that fails has not been: the ledger is as it was, though the springs had been through it already when the
/// particle in free flight overflowed.
#[test]
fn a_failed_step_leaves_the_ledger() {
    let mut world = World::<f32, 4, 4, 1>::new();
    let left = world.add_particle(Particle::at([0.0; 3]).with_velocity([0.1, 0.0, 0.0])).unwrap();
    let right = world.add_particle(Particle::at([1.0, 0.0, 0.0])).unwrap();
    let flying = world.add_particle(Particle::at([0.0; 3]).with_velocity([0.0, 0.0, 3e38])).unwrap();
    world.add_spring(Spring::new([left, right], 0.1, 1.0).with_damping(0.1)).unwrap();
    let mut verlet = VelocityVerlet::<f32, Storage>::new();
    let mut response = TimeOfImpact::<f32, Storage>::new();
    let mut ledger = Ledger::open(&world.view());
    let before = ledger.balance(&world.view());
    world.view().step_observed(&mut verlet, &mut response, 10.0, &mut ledger).unwrap_err();
    assert_eq!(ledger.balance(&world.view()), before);

    world.set_velocity(flying, [0.0; 3]).unwrap();
    world.view().step_observed(&mut verlet, &mut response, 0.1, &mut ledger).unwrap();
    assert!(ledger.balance(&world.view()).lost_to_damping > 0.0);
}
