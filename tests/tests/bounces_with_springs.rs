//! `time-of-impact` keeps the stepper's order where springs pull at what bounces.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_runner::model::{Hold, Model, ModelParticle, ModelPlane, ModelSpring};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::bounce_runs::run;
use hooke_tests::measure::position_error;
use hooke_tests::order::{Order, observed};
use hooke_tests::problems::bouncing_oscillator::BouncingOscillator;
use hooke_tests::problems::{Problem, bouncing};
use hooke_tests::runs::Run;

const TIME_STEPS: [f64; 4] = [1e-3, 5e-4, 2.5e-4, 1.25e-4];

/// Of these, one only touches the plane after its first impact, again and again: whether an Euler hits it there depends
/// on whether it gains or loses energy, so that its error falls with the root of the time step.
fn grazes(problem: &Problem) -> bool {
    problem.name.ends_with("equilibrium 0.08, restitution 0")
}

fn oscillators() -> impl Iterator<Item = Problem> {
    bouncing().into_iter().filter(|problem| !problem.model.springs.is_empty())
}

/// The largest position error at five times up to `end` (s).
fn error(problem: &Problem, stepper: StepperName, collision: CollisionForm, dt: f64, end: f64) -> f64 {
    let errors = (1..=5).map(|part| {
        let time = end * f64::from(part) / 5.0;
        position_error(&run(problem, stepper, collision, dt, time).moment, &(problem.exact)(time))
    });
    errors.fold(0.0, f64::max)
}

fn order(problem: &Problem, stepper: StepperName, collision: CollisionForm) -> Order {
    observed(&TIME_STEPS, |dt| error(problem, stepper, collision, dt, problem.duration))
}

/// The same over the first third, two periods or so: later, implicit Euler has damped so much at these time steps that
/// it misses impacts, and is not yet where its error is proportional to dt.
fn early_order(problem: &Problem, stepper: StepperName, collision: CollisionForm) -> Order {
    observed(&TIME_STEPS, |dt| error(problem, stepper, collision, dt, problem.duration / 3.0))
}

/// Whether the errors are those of a particle that lies still: roundings, which have no order.
fn at_rest(order: &Order) -> bool {
    order.errors.iter().all(|error| *error < 1e-12)
}

#[test]
fn verlet_keeps_its_second_order() {
    for problem in oscillators() {
        let order = order(&problem, StepperName::VelocityVerlet, CollisionForm::TimeOfImpact);
        // 12 impacts in differing parts of their steps scatter the errors by some ten per cent.
        assert!(at_rest(&order) || (1.8..2.3).contains(&order.slope), "{}: {order:?}", problem.name);
        assert!(order.errors[3] < 1e-6, "{}: {order:?}", problem.name);
    }
}

#[test]
fn methods_of_fourth_order_keep_it() {
    for problem in oscillators() {
        let order = |stepper, steps: &[f64]| {
            observed(steps, |dt| error(&problem, stepper, CollisionForm::TimeOfImpact, dt, problem.duration))
        };
        let rk4 = order(StepperName::Rk4, &[4e-3, 2e-3, 1e-3, 5e-4]);
        assert!(at_rest(&rk4) || (rk4.slope - 4.0).abs() < 0.15, "{}: {rk4:?}", problem.name);
        // Its error is a tenth of that, so its steps are longer. Where it grazes the plane again and again, whether it
        // touches it is up to the last digits.
        let s6 = order(StepperName::BlanesMoanS6, &[8e-3, 4e-3, 2e-3, 1e-3]);
        let holds = if grazes(&problem) { s6.errors[3] < 1e-8 } else { (s6.slope - 4.0).abs() < 0.15 };
        assert!(at_rest(&s6) || holds, "{}: {s6:?}", problem.name);
    }
}

/// A tenth of a period a step at most, and some impacts in each: their differing parts of their steps scatter the errors,
/// which fall by a factor of a thousand here.
const LONG_STEPS: [f64; 3] = [1.13e-1, 8e-2, 5.6e-2];

fn high_order(problem: &Problem, stepper: StepperName) -> Order {
    observed(&LONG_STEPS, |dt| error(problem, stepper, CollisionForm::TimeOfImpact, dt, problem.duration))
}

#[test]
fn dop853_keeps_its_eighth_order() {
    for problem in oscillators().filter(|problem| !grazes(problem)) {
        let order = high_order(&problem, StepperName::Dop853);
        assert!(at_rest(&order) || order.slope > 7.3 && order.errors[2] < 1e-10, "{}: {order:?}", problem.name);
        // And the same judgement refuses one of fourth order.
        let order = high_order(&problem, StepperName::Rk4);
        assert!(at_rest(&order) || order.slope < 7.3, "{}: {order:?}", problem.name);
    }
}

/// gap = 1 − 0.99 sin 10 t: a centimetre is always left, while the parabola between two states of such long steps dips
/// beyond the plane. And the same a centimetre deeper does hit it.
#[test]
fn what_turns_round_before_the_plane_does_not_bounce() {
    let particle = |z: f64, speed: f64, hold| ModelParticle {
        position: [0.0, 0.0, z],
        velocity: [0.0, 0.0, speed],
        mass: 1.0,
        hold,
    };
    for (stepper, dt) in [(StepperName::Dop853, 0.25), (StepperName::Dop853, 0.15), (StepperName::Rk4, 0.03)] {
        for (depth, bounces) in [(0.99, false), (1.05, true)] {
            let model = Model {
                particles: vec![particle(3.0, 0.0, Hold::Pinned), particle(1.0, -10.0 * depth, Hold::Free)],
                springs: vec![ModelSpring { between: [0, 1], stiffness: 100.0, damping: 0.0, rest_length: 2.0 }],
                planes: vec![ModelPlane { point: [0.0; 3], normal: [0.0, 0.0, 1.0], restitution: 0.5 }],
                ..Model::default()
            };
            let mut run = Run::<f64>::new(&model, [0.0; 3], stepper, CollisionForm::TimeOfImpact);
            // Where a path dips beyond the plane and back within one step it is missed: short ones show the hit.
            let hits = if bounces { run.steps(20, 0.02).hits } else { run.steps(20, dt).hits };
            assert_eq!(hits > 0, bounces, "{stepper}, {dt} s, {depth}: {hits}");
        }
    }
}

#[test]
fn the_eulers_keep_their_first_order() {
    for problem in oscillators().filter(|problem| !grazes(problem)) {
        for stepper in [StepperName::SemiImplicitEuler, StepperName::ExplicitEuler, StepperName::ImplicitEuler] {
            let order = early_order(&problem, stepper, CollisionForm::TimeOfImpact);
            // Some errors fall faster by symmetry: a whole swing of semi-implicit Euler is right to second order, and a
            // flight of explicit Euler that ends in rest forgets its error. None may fall more slowly.
            assert!(at_rest(&order) || order.slope > 0.8, "{stepper} on {}: {order:?}", problem.name);
        }
    }
}

#[test]
fn answers_at_the_end_of_the_step_are_of_first_order_only() {
    let problem = BouncingOscillator::new(0.08, 0.8).problem();
    for collision in [CollisionForm::Reflect, CollisionForm::Project] {
        let order = order(&problem, StepperName::VelocityVerlet, collision);
        assert!(order.slope < 1.5, "{collision}: {order:?}");
        assert!(order.errors[3] > 1e-5, "{collision}: {order:?}");
    }
}

#[test]
fn the_remainder_of_the_ledger_shrinks_at_the_same_order() {
    for problem in oscillators() {
        let remainder = |dt: f64| {
            let balance =
                run(&problem, StepperName::VelocityVerlet, CollisionForm::TimeOfImpact, dt, problem.duration).balance;
            balance.remainder().abs() / balance.scale()
        };
        let order = observed(&TIME_STEPS, remainder);
        let elastic = problem.model.planes[0].restitution == 1.0;
        // Elastic bounces at the lowest point of the swing leave Verlet's own symmetry, whose remainder falls faster.
        assert!(order.slope > 1.8 && (elastic || order.slope < 2.3), "{}: {order:?}", problem.name);
    }
}

#[test]
fn what_impacts_take_is_what_the_closed_form_says() {
    for problem in oscillators() {
        let outcome = run(&problem, StepperName::VelocityVerlet, CollisionForm::TimeOfImpact, 2.5e-4, problem.duration);
        let exact = problem.lost_in_impacts(problem.duration);
        // Second order with the constants seen above: 1e-6 of the energy at this time step.
        let error = (outcome.balance.lost_in_impacts - exact).abs() / outcome.balance.scale();
        assert!(error < 1e-6, "{}: {error:e}", problem.name);
    }
}
