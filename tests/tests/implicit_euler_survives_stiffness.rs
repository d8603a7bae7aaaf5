//! Stiffnesses 1e8 apart, steps of a second: implicit Euler stays finite and says whether it converged.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::Real;
use hooke_runner::model::Model;
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::graphs::Graph;
use hooke_tests::runs::Run;
use hooke_tests::scenes;

const GRAVITY: [f64; 3] = [0.2, -0.5, -9.7];

/// Every other spring 1e8 times as stiff.
fn stiffened(mut model: Model) -> Model {
    model.springs.iter_mut().step_by(2).for_each(|spring| spring.stiffness *= 1e8);
    model
}

fn models() -> Vec<(String, Model)> {
    let mut models: Vec<(String, Model)> = (0..4)
        .map(|seed| {
            let graph = Graph { particles: 14, springs: 22, stiffness: [1.0, 1.0], ..Graph::default() };
            (format!("graph {seed}"), stiffened(graph.model(seed)))
        })
        .collect();
    let (mut rope, _) = scenes::load("rope-100");
    rope.particles.truncate(20);
    rope.springs.truncate(19);
    rope.springs.iter_mut().for_each(|spring| spring.stiffness = 1.0);
    models.push(("rope".into(), stiffened(rope)));
    models
}

#[test]
fn in_both_precisions() {
    for (name, model) in models() {
        survives::<f32>(&model, &name);
        survives::<f64>(&model, &name);
    }
}

/// A hundred steps of a second, each finite, and each either reported as not solved or solved: to the tolerance, or to
/// what rounding leaves, which at 1e8 N/m is a force of 10 N in `f32` and of 1e-8 N in `f64`.
fn survives<R: Real>(model: &Model, name: &str) {
    let tolerance = 1e-4;
    for stepper in [StepperName::ImplicitEuler, StepperName::ImplicitEulerLinearised] {
        let mut run = Run::<R>::new(model, GRAVITY, stepper, CollisionForm::Reflect).with_tolerance(stepper, tolerance);
        for step in 0..100 {
            let report = run.try_step(1.0).unwrap_or_else(|error| panic!("{name}, {stepper}, step {step}: {error}"));
            assert!(report.residual.is_finite(), "{name}, {stepper}, step {step}: {report:?}");
            let small = report.residual <= tolerance;
            // A linear solve knows no rounding of positions: there, converged is the tolerance and nothing else.
            let rounded = stepper == StepperName::ImplicitEuler && size_of::<R>() == 4;
            assert!(report.converged == small || report.converged && rounded, "{name}, {stepper}, {step}: {report:?}");
        }
    }
}
