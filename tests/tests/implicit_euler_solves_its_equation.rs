//! Implicit Euler's step solves v' = v + dt·a(x + dt·v', v'), and the report says how well.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::StepReport;
use hooke_runner::model::{Hold, Model};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::graphs::Graph;
use hooke_tests::moment::Moment;
use hooke_tests::problems::smooth;
use hooke_tests::right_hand_side::RightHandSide;
use hooke_tests::runs::Run;
use hooke_tests::{measure, root, scenes};

const GRAVITY: [f64; 3] = [0.2, -0.5, -9.7];
/// Times the highest frequency of the scene.
const STEPS: [f64; 6] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0];

#[test]
fn exact_problems() {
    for problem in smooth() {
        let springs = &problem.model.springs;
        let stiffest = springs.iter().map(|spring| spring.stiffness).fold(0.0, f64::max);
        let lightest = problem.model.particles.iter().map(|particle| particle.mass).fold(f64::INFINITY, f64::min);
        let frequency = if springs.is_empty() { 1.0 } else { (4.0 * stiffest / lightest).sqrt() };
        for h in STEPS {
            check(&problem.model, problem.gravity, h / frequency, &format!("{problem:?} at {h}"));
        }
    }
}

#[test]
fn irregular_graphs_stretched_and_compressed_with_pins_and_tracks() {
    for (strain, damping) in [([0.6, 0.8], 0.0), ([0.7, 1.2], 0.3), ([1.1, 1.5], 0.0), ([1.1, 1.5], 2.0)] {
        for seed in 0..3 {
            let mut model = Graph { particles: 14, springs: 22, strain, damping, ..Graph::default() }.model(seed);
            drive_one(&mut model);
            for h in STEPS {
                // k/m is 1,000 at most, and some four springs meet at a particle.
                let dt = h / 4000.0_f64.sqrt();
                check(&model, GRAVITY, dt, &format!("strain {strain:?}, damping {damping}, seed {seed} at {h}"));
            }
        }
    }
}

/// The first pinned particle follows a track instead.
fn drive_one(model: &mut Model) {
    for particle in &mut model.particles {
        if particle.hold == Hold::Pinned {
            particle.velocity = [0.4, -0.3, 0.2];
            particle.hold = Hold::Track(0);
            return;
        }
        particle.velocity = particle.velocity.map(|component| 0.5 * component);
    }
}

fn check(model: &Model, gravity: [f64; 3], dt: f64, name: &str) {
    let law = RightHandSide::new(model, gravity);
    let mut run = Run::<f64>::new(model, gravity, StepperName::ImplicitEuler, CollisionForm::Reflect)
        .with_tolerance(StepperName::ImplicitEuler, 1e-13);
    // What is pinned has no velocity, whatever the model says.
    let start = run.moment();
    let report = run.steps(1, dt);
    let found = run.moment();
    assert!(report.converged, "{name}: {report:?}");
    let near = root::implicit_euler_near(&law, &start, dt, &found);
    let near = near.unwrap_or_else(|_| panic!("{name}: no root near {report:?}"));
    let size = found.velocity.as_flattened().iter().fold(0.1, |size: f64, v| size.max(v.abs()));
    let apart = measure::velocity_error(&found, &near.moment) / size;
    assert!(apart < 1e-8, "{name}: {apart:e}, {report:?}");
    let recomputed = relative_residual(model, gravity, &start, &found, dt);
    // Both are roundings of the same number once the equation is solved to the last digits: 1e-13 is told from nothing.
    assert!(
        (recomputed - report.residual).abs() < 0.01 * report.residual + 1e-13,
        "{name}: {recomputed:e}, {report:?}"
    );
}

/// A loose tolerance leaves a residual well above rounding, and the report must name it to a few digits.
#[test]
fn the_reported_residual_is_the_true_one() {
    let mut seen = 0;
    for seed in 0..6 {
        let mut model = Graph { particles: 14, springs: 22, ..Graph::default() }.model(seed);
        drive_one(&mut model);
        for dt in [0.01, 0.1, 0.5] {
            let mut run = Run::<f64>::new(&model, GRAVITY, StepperName::ImplicitEuler, CollisionForm::Reflect)
                .with_tolerance(StepperName::ImplicitEuler, 1e-3);
            let start = run.moment();
            let report: StepReport = run.steps(1, dt);
            let residual = relative_residual(&model, GRAVITY, &start, &run.moment(), dt);
            assert!(report.converged && report.residual <= 1e-3, "{report:?}");
            // Rounding of the residual's terms, 1e-15 of them, beside what is left of them.
            assert!((residual - report.residual).abs() < 1e-6 * report.residual + 1e-14, "{residual:e}, {report:?}");
            seen += usize::from(residual > 1e-8);
        }
    }
    assert!(seen >= 9, "residuals above rounding: {seen}");
}

/// √(Σ |r|²/m) over √(Σ s²/m): r = m (v' − v) − dt·f(x', v'), and s the sizes of its momenta and impulses added up, both
/// of the particles that springs pull at and that are not held; written from the documentation.
fn relative_residual(model: &Model, gravity: [f64; 3], start: &Moment, end: &Moment, dt: f64) -> f64 {
    let mut accelerations = vec![[0.0; 3]; model.particles.len()];
    RightHandSide::new(model, gravity).accelerate(&end.position, &end.velocity, &mut accelerations);
    let length = |vector: [f64; 3]| glam::DVec3::from(vector).length();
    let (mut left, mut scale) = (0.0, 0.0);
    for (number, particle) in model.particles.iter().enumerate() {
        let springs = || model.springs.iter().filter(|spring| spring.between.contains(&(number as u32)));
        if particle.hold != Hold::Free || springs().count() == 0 {
            continue;
        }
        let m = particle.mass;
        let parts: [f64; 3] = std::array::from_fn(|axis| {
            end.velocity[number][axis] - start.velocity[number][axis] - dt * accelerations[number][axis]
        });
        let mut size = m * (length(start.velocity[number]) + length(end.velocity[number]) + dt * length(gravity));
        for spring in springs() {
            let [i, j] = spring.between.map(|end| end as usize);
            let apart = |vectors: &[[f64; 3]]| glam::DVec3::from(vectors[j]) - glam::DVec3::from(vectors[i]);
            let (d, v) = (apart(&end.position), apart(&end.velocity));
            if d.length() > 0.0 {
                let rate = v.dot(d) / d.length();
                size += dt * (spring.stiffness * (d.length() - spring.rest_length) + spring.damping * rate).abs();
            }
        }
        left += m * length(parts).powi(2);
        scale += size * size / m;
    }
    if left == 0.0 { 0.0 } else { (left / scale).sqrt() }
}

/// A slack cloth in steps of 0.1 s, where many springs are compressed: the definite matrix alone takes 47 iterations a
/// step, and Newton's own takes 6.
#[test]
fn a_slack_cloth_takes_few_iterations() {
    let (model, settings) = scenes::load("cloth-32");
    let stepper = StepperName::ImplicitEuler;
    let mut run =
        Run::<f64>::new(&model, settings.gravity, stepper, CollisionForm::Reflect).with_tolerance(stepper, 1e-6);
    let report = run.steps(20, 0.1);
    assert!(report.converged && report.iterations < 200, "{report:?}");
}

/// In `f32` the rounding of a stiff spring's ends weighs more than gravity: that must not pass for a solution before
/// anything was tried. What falls must fall.
#[test]
fn a_stiff_scene_in_single_precision_moves() {
    let (mut model, settings) = scenes::load("rope-100");
    model.springs.iter_mut().for_each(|spring| spring.stiffness = 1e8);
    let stepper = StepperName::ImplicitEuler;
    let mut run =
        Run::<f32>::new(&model, settings.gravity, stepper, CollisionForm::Reflect).with_tolerance(stepper, 1e-4);
    let report = run.steps(10, 0.03);
    let tip = run.moment().position[99];
    // Free fall is 0.5 m by then and swinging about the pin three quarters of that; implicit steps overshoot a little.
    assert!(tip[2] < -0.2, "{tip:?}, {report:?}");
}
