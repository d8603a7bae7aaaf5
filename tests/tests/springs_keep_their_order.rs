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

/// A rope of so many particles.
fn rope(particles: u32) -> Model {
    let mut rope = Model::default();
    for index in 0..particles {
        let position = [f64::from(index) * 0.01, -1.0, 0.0];
        let hold = if index == 0 { Hold::Pinned } else { Hold::Free };
        rope.particles.push(ModelParticle { position, velocity: [0.0; 3], mass: 0.01, hold });
        if index > 0 {
            let between = [index - 1, index];
            rope.springs.push(ModelSpring { between, stiffness: 100.0, damping: 0.05, rest_length: 0.01 });
        }
    }
    rope
}

/// Both in one scene.
fn together(first: &Model, second: &Model) -> Model {
    let mut both = first.clone();
    let before = both.particles.len() as u32;
    both.particles.extend(&second.particles);
    for spring in &second.springs {
        both.springs.push(ModelSpring { between: spring.between.map(|end| end + before), ..*spring });
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

fn compare<R: Real>(model: &Model, companies: &[Model]) {
    let count = model.particles.len();
    let alone = last::<R>(model, count);
    for (number, company) in companies.iter().enumerate() {
        assert!(last::<R>(&together(company, model), count) == alone, "in company {number}");
    }
}

fn ropes() -> [Model; 5] {
    [2, 100, 255, 256, 300].map(rope)
}

#[test]
fn of_a_cloth() {
    compare::<f32>(&cloth(), &ropes());
    compare::<f64>(&cloth(), &ropes());
}

#[test]
fn of_an_irregular_mesh() {
    compare::<f32>(&irregular(20), &ropes());
}

/// Where there are many springs that lie on no diagonal, they are gone through in another way than where there are few;
/// and a tile of them may lie between two that have diagonals.
#[test]
fn of_a_small_mesh_beside_large_ones() {
    let large = [irregular(40), together(&irregular(30), &cloth()), together(&irregular(30), &rope(700))];
    for small in [irregular(20), together(&irregular(20), &cloth()), together(&cloth(), &irregular(12))] {
        compare::<f32>(&small, &large);
        compare::<f64>(&small, &large);
    }
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
