//! The textbook loop against trajectories that other programs computed.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use glam::{DVec3, Vec3, Vec3A};
use hooke_benches::textbook::{Response, Textbook};
use hooke_benches::vector::{Scalar, Vector};
use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_tests::measure;
use hooke_tests::moment::Moment;
use hooke_tests::reference;
use hooke_tests::right_hand_side::RightHandSide;
use hooke_tests::trusted::Trusted;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Agreed on by three programs, to the seven digits given.
const CLOTH_ERROR: f64 = 5.163_268e-3;
const ROPE_ERROR: f64 = 7.012_999e-3;
/// Half of the last digit given.
const DIGIT: f64 = 0.5e-9;

#[test]
fn cloth_misses_the_trusted_one_by_what_it_must() {
    let error = error_at_one_second::<DVec3>(&cloth(), "cloth-32");
    assert!((error - CLOTH_ERROR).abs() < DIGIT, "{error:e}");
}

#[test]
fn rope_misses_the_trusted_one_by_what_it_must() {
    let error = error_at_one_second::<DVec3>(&rope(), "rope-100");
    assert!((error - ROPE_ERROR).abs() < DIGIT, "{error:e}");
}

/// The step's error is the same 5 mm and 7 mm in f32: rounding adds 1e-7 × 1,000 steps × the 156-fold growth, at worst.
#[test]
fn single_precision_misses_by_about_the_same() {
    for (model, name, expected) in [(cloth(), "cloth-32", CLOTH_ERROR), (rope(), "rope-100", ROPE_ERROR)] {
        let narrow = error_at_one_second::<Vec3>(&model, name);
        let wide = error_at_one_second::<Vec3A>(&model, name);
        for error in [narrow, wide] {
            assert!((error - expected).abs() < 1e-3, "{name}: {error:e}");
        }
    }
}

/// Semi-implicit Euler in 1,000 steps of 1 ms; the largest distance of any particle, m.
fn error_at_one_second<V: Vector>(model: &Model, name: &str) -> f64 {
    let mut textbook = Textbook::<V>::new(model, GRAVITY, Response::Reflect).unwrap();
    for _ in 0..1000 {
        textbook.step_semi_implicit_euler(V::Real::from_f64(1e-3));
    }
    let mut moment = Moment::default();
    for particle in &textbook.particles {
        moment = moment.with(particle.position.components(), particle.velocity.components());
    }
    let trusted = Trusted::read(name).unwrap();
    assert_eq!(trusted.time, [0.25, 0.5, 1.0]);
    measure::position_error(&moment, &trusted.moments[2])
}

/// The reference integrator and its force law reach the trusted states on their own, to what those can be trusted.
#[test]
fn reference_integrator_agrees_with_the_trusted_states() {
    // At t = 0.25 s, where the rope's disturbances have not grown yet and the run is short.
    for (model, name, steps) in [(cloth(), "cloth-32", 25), (rope(), "rope-100", 125)] {
        let law = RightHandSide::new(&model, GRAVITY);
        let found = reference::integrate(&law, &Moment::start(&model), 0.25, steps);
        let trusted = Trusted::read(name).unwrap();
        let error = measure::position_error(&found, &trusted.moments[0]);
        // The trusted states differ from other programs' by 1e-10 (cloth) and 4e-9 (rope) at 1 s.
        assert!(error < 1e-9, "{name}: {error:e}");
    }
}

/// 32 × 32 particles on the unit square, u fastest, structural, shear and bend springs, two corners pinned.
fn cloth() -> Model {
    let n = 32;
    let place = |number: usize| number as f64 / (n - 1) as f64;
    let particles = (0..n * n).map(|number| {
        let (u, v) = (number % n, number / n);
        particle([place(u), place(v), 0.0], v == 0 && (u == 0 || u == n - 1))
    });
    let particles: Vec<ModelParticle> = particles.collect();
    let mut springs = Vec::new();
    // Structural, shear, bend, as steps in u and v.
    for (du, dv) in [(1, 0), (0, 1), (1, 1), (-1, 1), (2, 0), (0, 2)] {
        for v in 0..n - dv {
            for u in 0..n {
                let Some(to) = u.checked_add_signed(du).filter(|to| *to < n) else {
                    continue;
                };
                springs.push(spring(&particles, [v * n + u, (v + dv) * n + to], 100.0, 0.05));
            }
        }
    }
    Model { particles, springs, ..Model::default() }
}

/// 100 particles, a centimetre apart, the first one pinned.
fn rope() -> Model {
    let particles = (0..100).map(|i| particle([0.99 * f64::from(i) / 99.0, 0.0, 0.0], i == 0));
    let particles: Vec<ModelParticle> = particles.collect();
    let springs = (1..100).map(|j| spring(&particles, [j - 1, j], 1000.0, 0.1));
    Model { springs: springs.collect(), particles, ..Model::default() }
}

fn particle(position: [f64; 3], pinned: bool) -> ModelParticle {
    ModelParticle { position, velocity: [0.0; 3], mass: 0.01, hold: if pinned { Hold::Pinned } else { Hold::Free } }
}

fn spring(particles: &[ModelParticle], between: [usize; 2], stiffness: f64, damping: f64) -> ModelSpring {
    let [from, to] = between.map(|number| DVec3::from(particles[number].position));
    ModelSpring { between: between.map(|number| number as u32), stiffness, damping, rest_length: from.distance(to) }
}
