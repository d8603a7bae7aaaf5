//! A structure moves to the bit as if it were alone, whatever else there is: neither where its particles come to lie
//! among tiles nor which springs share a loop changes the order of a sum.
#![allow(missing_docs)]

use hooke::Real;
use hooke_benches::mesh::irregular;
use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::runs::Run;
use hooke_tests::scenes;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

fn cloth() -> Model {
    scenes::load("cloth-13x29").0
}

/// The same after a rope of so many particles.
fn after_a_rope(model: &Model, particles: u32) -> Model {
    let mut both = Model::default();
    for index in 0..particles {
        let position = [f64::from(index) * 0.01, -1.0, 0.0];
        let hold = if index == 0 { Hold::Pinned } else { Hold::Free };
        both.particles.push(ModelParticle { position, velocity: [0.0; 3], mass: 0.01, hold });
        if index > 0 {
            let between = [index - 1, index];
            both.springs.push(ModelSpring { between, stiffness: 100.0, damping: 0.05, rest_length: 0.01 });
        }
    }
    both.particles.extend(&model.particles);
    for spring in &model.springs {
        both.springs.push(ModelSpring { between: spring.between.map(|end| end + particles), ..*spring });
    }
    both
}

/// The states of the last so many particles after some steps.
fn last<R: Real>(model: &Model, count: usize) -> Vec<[R::Vec3; 2]> {
    let mut run = Run::<R>::new(model, GRAVITY, StepperName::SemiImplicitEuler, CollisionForm::Project);
    run.steps(50, 1e-3);
    let view = run.world.view();
    let states = view.states().skip(model.particles.len() - count);
    states.map(|(position, velocity)| [position, velocity]).collect()
}

fn compare<R: Real>(model: &Model) {
    let count = model.particles.len();
    let alone = last::<R>(model, count);
    for particles in [2, 100, 255, 256, 300] {
        assert!(last::<R>(&after_a_rope(model, particles), count) == alone, "after a rope of {particles}");
    }
}

#[test]
fn of_a_cloth() {
    compare::<f32>(&cloth());
    compare::<f64>(&cloth());
}

#[test]
fn of_an_irregular_mesh() {
    compare::<f32>(&irregular(20));
}

/// What would show if it did not: with another stiffness somewhere, something else comes out.
#[test]
fn the_comparison_tells_a_small_change() {
    let mut model = cloth();
    let count = model.particles.len();
    let before = last::<f64>(&model, count);
    model.springs[100].stiffness *= 1.0 + 1e-12;
    assert!(last::<f64>(&model, count) != before);
}
