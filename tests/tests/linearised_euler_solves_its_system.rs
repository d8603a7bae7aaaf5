//! The linearised step solves (M + dt·C + dt²·K)(v' − v) = dt (f(x, v) − dt·K v), assembled and eliminated here.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_runner::model::{Hold, Model};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::graphs::Graph;
use hooke_tests::problems::smooth;
use hooke_tests::runs::Run;
use hooke_tests::{linearisation, measure};

const GRAVITY: [f64; 3] = [0.2, -0.5, -9.7];

#[test]
fn exact_problems() {
    for problem in smooth() {
        for dt in [1e-3, 1e-2, 0.1, 1.0] {
            check(&problem.model, problem.gravity, dt, &format!("{problem:?} at {dt}"));
        }
    }
}

#[test]
fn irregular_graphs_with_pins_and_tracks() {
    for strain in [[0.6, 0.8], [0.7, 1.2], [1.1, 1.5]] {
        for seed in 0..4 {
            let mut model = Graph { particles: 16, springs: 26, strain, ..Graph::default() }.model(seed);
            // A spring that has no length and wants none resists all alike.
            let last = model.springs.len() - 1;
            model.springs[last].rest_length = if seed % 2 == 0 { 0.0 } else { 0.2 };
            for particle in model.particles.iter_mut().filter(|particle| particle.hold == Hold::Pinned).take(1) {
                particle.hold = Hold::Track(0);
                particle.velocity = [0.4, -0.3, 0.2];
            }
            for dt in [1e-3, 1e-2, 0.1, 1.0] {
                check(&model, GRAVITY, dt, &format!("strain {strain:?}, seed {seed} at {dt}"));
            }
        }
    }
}

fn check(model: &Model, gravity: [f64; 3], dt: f64, name: &str) {
    let mut run = Run::<f64>::new(model, gravity, StepperName::ImplicitEulerLinearised, CollisionForm::Reflect)
        .with_tolerance(StepperName::ImplicitEulerLinearised, 1e-14);
    let start = run.moment();
    let report = run.steps(1, dt);
    assert!(report.converged && report.iterations == 1, "{name}: {report:?}");
    let expected = linearisation::step(model, gravity, &start, &linearisation::weights(model), dt);
    let found = run.moment();
    let size = expected.velocity.as_flattened().iter().fold(0.1, |size: f64, v| size.max(v.abs()));
    let apart = measure::velocity_error(&found, &expected) / size;
    // A residual of 1e-14 times the matrix's condition, 1 + dt²ω²: 1e4 at most here.
    assert!(apart < 1e-9, "{name}: {apart:e}, {report:?}");
    assert!(measure::position_error(&found, &expected) < 1e-9 * size * dt.max(1e-3), "{name}");
}
