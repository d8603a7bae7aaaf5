//! Every set of vector instructions and every number of threads gives the same bits: with each stepper, precision and
//! form of collision, on diagonals with and without gaps, uniform and varied, and on springs that lie on none.
//!
//! A set that the machine does not have is stepped with the widest that it has.
#![allow(clippy::unwrap_used, missing_docs)]

use hooke::{Compensated, Lanes, Real};
use hooke_benches::mesh::irregular;
use hooke_runner::model::Model;
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_runner::simulate::Threads;
use hooke_tests::runs::Run;
use hooke_tests::steppers;
use hooke_tests::{digest, scenes};

const GRAVITY: [f64; 3] = [0.3, 0.0, -9.81];

/// The scene, with rest lengths that differ on every seventh rope's length of springs.
fn varied() -> Model {
    let mut model = scenes::load("every-kind-of-spring").0;
    for (number, spring) in model.springs.iter_mut().enumerate() {
        if number / 100 % 3 == 0 {
            spring.rest_length *= 1.0 + 1e-3 * (number % 7) as f64;
        }
    }
    model
}

fn digest<R: Real>(model: &Model, stepper: StepperName, form: CollisionForm, lanes: Lanes, threads: u32) -> u64 {
    let mut run = Run::<R>::new(model, GRAVITY, stepper, form).with_tolerance(stepper, 1e-4);
    run.world.set_lanes(lanes);
    let threads = Threads::of(Some(threads), run.world.view().plan()).unwrap();
    for _ in 0..25 {
        let mut view = run.world.view();
        if let Some(threads) = &threads {
            view.share_among(threads);
        }
        view.step(run.stepper.any(), &mut run.response, R::from_f64(1e-3)).unwrap();
    }
    digest::of(&run.world.view())
}

fn compare<R: Real>(model: &Model) {
    for stepper in steppers::all() {
        for form in [CollisionForm::Reflect, CollisionForm::Project, CollisionForm::TimeOfImpact] {
            let expected = digest::<R>(model, stepper, form, Lanes::Baseline, 1);
            for lanes in [Lanes::Avx2, Lanes::Avx512] {
                assert_eq!(digest::<R>(model, stepper, form, lanes, 1), expected, "{stepper} {form} {lanes:?}");
            }
            for threads in [2, 3, 5] {
                let shared = digest::<R>(model, stepper, form, Lanes::Avx512, threads);
                assert_eq!(shared, expected, "{stepper} {form} on {threads} threads");
            }
        }
    }
}

#[test]
fn in_single_precision() {
    compare::<f32>(&varied());
}

#[test]
fn in_compensated_precision() {
    compare::<Compensated>(&varied());
}

#[test]
fn in_double_precision() {
    compare::<f64>(&varied());
}

#[test]
fn on_an_irregular_mesh() {
    compare::<f32>(&irregular(24));
}

#[test]
fn the_scene_has_every_kind_of_spring() {
    let model = varied();
    let mut run = Run::<f32>::new(&model, GRAVITY, StepperName::SemiImplicitEuler, CollisionForm::Project);
    let plan = *run.world.view().plan();
    assert!(plan.on_diagonals > 1000 && plan.on_diagonals < plan.springs, "{plan:?}");
    assert!(plan.attached > 4 * 256 && plan.free() > 256, "{plan:?}");
}

/// What would show if a bit did change.
#[test]
fn the_digest_tells_one_bit() {
    let mut model = varied();
    let digest =
        |model: &Model| digest::<f64>(model, StepperName::SemiImplicitEuler, CollisionForm::Project, Lanes::Avx512, 2);
    let before = digest(&model);
    model.particles[700].position[1] = model.particles[700].position[1].next_up();
    assert_ne!(digest(&model), before);
}
