//! The steppers of high order on problems with exact solutions: the order that their papers claim, down to where rounding
//! takes over.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use hooke_runner::scene::StepperName;
use hooke_tests::order;
use hooke_tests::problems::{Problem, smooth};
use hooke_tests::runs;

/// What a stepper claims.
struct Claim {
    stepper: StepperName,
    order: f64,
    /// How far from that an observed order may be.
    margin: f64,
    /// Steps that half a problem's duration, a period and a half of most, is cut into.
    counts: [usize; 5],
    /// Steps that some twenty durations, no whole number of periods, are cut into: h = ω dt is 1.2 at first for order 8, and 0.04 for order 4.
    halvings: [usize; 4],
}

const CLAIMS: [Claim; 4] = [
    Claim {
        stepper: StepperName::Rk4,
        order: 4.0,
        margin: 0.15,
        counts: [100, 200, 400, 600, 800],
        halvings: [10240, 20480, 40960, 81920],
    },
    Claim {
        stepper: StepperName::BlanesMoanS6,
        order: 4.0,
        margin: 0.15,
        counts: [40, 80, 160, 240, 320],
        halvings: [2560, 5120, 10240, 20480],
    },
    Claim {
        stepper: StepperName::Dop853,
        order: 8.0,
        margin: 0.3,
        counts: [12, 16, 24, 32, 40],
        halvings: [320, 640, 1280, 2560],
    },
    Claim {
        stepper: StepperName::DormandPrinceRkn8,
        order: 8.0,
        margin: 0.3,
        counts: [16, 24, 32, 40, 48],
        halvings: [320, 640, 1280, 2560],
    },
];

/// Below this the roundings of places of size 1 begin to show, m.
const FLOOR: f64 = 5e-14;

fn takes(claim: &Claim, problem: &Problem) -> bool {
    claim.stepper.knows_damping() || problem.model.springs.iter().all(|spring| spring.damping == 0.0)
}

fn observed(problem: &Problem, stepper: StepperName, part: f64, counts: &[usize]) -> order::Order {
    let time_steps: Vec<f64> = counts.iter().map(|count| part * problem.duration / *count as f64).collect();
    let mut counts = counts.iter();
    order::observed(&time_steps, |_| runs::error::<f64>(problem, stepper, part, *counts.next().unwrap()))
}

/// The order from the last two errors that are above the floor; nothing if there are none.
fn last_order(problem: &Problem, claim: &Claim) -> Option<f64> {
    let order = observed(problem, claim.stepper, 0.5, &claim.counts);
    order.errors.windows(2).zip(&order.pairwise).rfind(|(pair, _)| pair[1] > FLOOR).map(|(_, order)| *order)
}

/// A little more than was claimed is no fault: the next term of the error still counts.
fn holds(order: f64, claim: &Claim) -> bool {
    (claim.order - claim.margin..claim.order + 0.7).contains(&order)
}

#[test]
fn on_every_problem_with_an_exact_solution() {
    let mut measured = 0;
    for problem in smooth() {
        for claim in CLAIMS.iter().filter(|claim| takes(claim, &problem)) {
            if problem.model.springs.is_empty() {
                // It flies on a parabola: rounding alone, of places of size 10.
                let error = runs::error::<f64>(&problem, claim.stepper, 0.5, claim.counts[0]);
                assert!(error < 1e-12, "{}, {}: {error:e}", problem.name, claim.stepper);
                continue;
            }
            let Some(order) = last_order(&problem, claim) else { continue };
            assert!(holds(order, claim), "{}, {}: order {order}", problem.name, claim.stepper);
            measured += 1;
        }
    }
    // On all but what is at rest.
    assert!(measured > 40, "{measured}");
}

/// The same judgement refuses a stiffness that is off by a millionth.
#[test]
fn a_wrong_scene_is_noticed() {
    for mut problem in smooth() {
        if problem.model.springs.is_empty() {
            continue;
        }
        let claims: Vec<&Claim> =
            CLAIMS.iter().filter(|claim| takes(claim, &problem) && last_order(&problem, claim).is_some()).collect();
        problem.model.springs.iter_mut().for_each(|spring| spring.stiffness *= 1.0 + 1e-6);
        for claim in claims {
            let order = last_order(&problem, claim);
            assert!(!order.is_some_and(|order| holds(order, claim)), "{}, {}", problem.name, claim.stepper);
        }
    }
}

#[test]
fn the_slope_over_three_halvings() {
    let mut measured = 0;
    let mut problems = smooth();
    problems.retain(|problem| problem.name == "oscillator, damping ratio 0, gravity 0");
    for problem in problems {
        for claim in &CLAIMS {
            let order = observed(&problem, claim.stepper, 19.3, &claim.halvings);
            let error = (order.slope - claim.order).abs();
            assert!(error <= claim.margin, "{}, {}: {order:?}", problem.name, claim.stepper);
            measured += 1;
        }
    }
    assert_eq!(measured, 4);
}
