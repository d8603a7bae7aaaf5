//! Every stepper on every problem with an exact solution: its order of accuracy, and its error.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_runner::scene::StepperName;
use hooke_tests::measure;
use hooke_tests::order::{self, Order};
use hooke_tests::problems::{Problem, smooth};
use hooke_tests::runs;
use hooke_tests::steppers;

/// Part of the duration that is run through: a period and a half of most problems.
const PART: f64 = 0.5;

/// The steps that it is cut into. The highest frequency is 63 rad/s and the longest run 2 s, so h = ω dt is 0.1 at most
/// and the next term of the error some per cent of the leading one.
fn counts(stepper: StepperName) -> [usize; 3] {
    match stepper {
        // Its errors grow like e^{hωt/2}: shorter steps for the same straightness.
        StepperName::ExplicitEuler => [4000, 8000, 16000],
        StepperName::ImplicitEuler | StepperName::ImplicitEulerLinearised => [1000, 2000, 4000],
        _ => [500, 1000, 2000],
    }
}

fn is_second_order(stepper: StepperName) -> bool {
    !matches!(
        stepper,
        StepperName::ExplicitEuler
            | StepperName::SemiImplicitEuler
            | StepperName::ImplicitEuler
            | StepperName::ImplicitEulerLinearised
    )
}

#[test]
fn on_every_problem_with_an_exact_solution() {
    for problem in smooth() {
        for stepper in steppers::of_low_order() {
            let order = measured(&problem, stepper);
            assert!(holds(&problem, stepper, is_second_order(stepper), &order), "{problem:?}, {stepper}: {order:?}");
        }
    }
}

/// The same judgement must refuse a scene whose stiffness (or gravity, where there is no spring) is 1 % off.
#[test]
fn a_wrong_scene_is_noticed() {
    for mut problem in smooth() {
        problem.model.springs.iter_mut().for_each(|spring| spring.stiffness *= 1.01);
        if problem.model.springs.is_empty() {
            problem.gravity = problem.gravity.map(|component| 1.01 * component);
        }
        for stepper in steppers::of_low_order() {
            let order = measured(&problem, stepper);
            assert!(!holds(&problem, stepper, is_second_order(stepper), &order), "{problem:?}, {stepper}: {order:?}");
        }
    }
}

/// And a stepper of another order, wherever there is an error to tell by.
#[test]
fn a_stepper_of_the_wrong_order_is_noticed() {
    for problem in smooth().iter().filter(|problem| size(problem) > 0.0) {
        for stepper in [StepperName::SemiImplicitEuler, StepperName::ExplicitEuler, StepperName::VelocityVerlet] {
            let order = measured(problem, stepper);
            assert!(!holds(problem, stepper, !is_second_order(stepper), &order), "{problem:?}, {stepper}: {order:?}");
        }
    }
}

/// Single precision follows until rounding stops it: by then half a unit of the last place a step, twice, has added up.
#[test]
fn single_precision_follows_down_to_its_rounding() {
    let mut floored = 0;
    for problem in smooth() {
        // Exponential growth of every rounding is explicit Euler's own: e^{ω² dt t/2} is next to 1 here.
        for stepper in steppers::of_low_order() {
            for count in [500, 8000] {
                let (wide, narrow) = (
                    runs::error::<f64>(&problem, stepper, PART, count),
                    runs::error::<f32>(&problem, stepper, PART, count),
                );
                let reach = 1.0 + size(&problem);
                // The scene itself is rounded too, and the period and a half multiplies that by ωt, 10 or so.
                let rounding = (0.5 * count as f64 + 50.0) * f64::from(f32::EPSILON) * reach;
                assert!((narrow - wide).abs() < rounding, "{problem:?}, {stepper}, {count}: {narrow:e}, {wide:e}");
                floored += usize::from(narrow > 2.0 * wide && narrow > 1e-8);
            }
        }
    }
    // Verlet's and auto's at 8,000 steps, at least.
    assert!(floored > 30, "{floored}");
}

/// The order, where there is an error that has one, and the error at the smallest step.
fn holds(problem: &Problem, stepper: StepperName, second: bool, order: &Order) -> bool {
    let size = size(problem);
    let last = order.errors[2];
    let exact = problem.model.springs.is_empty() && is_second_order(stepper);
    if size == 0.0 || exact && second {
        // At rest, or on the stepper's own parabola: rounding alone, of places and speeds of size 10, 2,000 times.
        return last < 1e-12;
    }
    // The leading error is c h (or c h²) of the size with c up to ωt/2 = 5 (ωt/24 = 0.4, times three where damping adds
    // its own), at the highest of the frequencies that are swung: h = ω dt is 0.0006 explicitly, 0.0024 implicitly and
    // 0.0047 otherwise. Overdamped, the faster rate is five times ω.
    let bound = if second { 2e-5 } else { 1e-2 };
    // The next term bends the line by h or so: a hundredth, or a fifth of that beside an error of second order.
    let slope = if second { (order.pairwise[1] - 2.0).abs() < 0.01 } else { (order.pairwise[1] - 1.0).abs() < 0.015 };
    slope && last < bound * size
}

fn measured(problem: &Problem, stepper: StepperName) -> Order {
    let counts = counts(stepper);
    let time_steps = counts.map(|count| PART * problem.duration / count as f64);
    let mut counts = counts.into_iter();
    order::observed(&time_steps, |_| runs::error::<f64>(problem, stepper, PART, counts.next().unwrap()))
}

/// How far any particle gets from its place, m.
fn size(problem: &Problem) -> f64 {
    let start = (problem.exact)(0.0);
    (1..=32).fold(0.0, |size: f64, part| {
        let moment = (problem.exact)(f64::from(part) / 32.0 * PART * problem.duration);
        size.max(measure::position_error(&moment, &start))
    })
}
