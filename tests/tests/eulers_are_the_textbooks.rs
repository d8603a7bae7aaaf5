//! The named explicit and semi-implicit Euler are the textbook loop's, to the letter, for every particle.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use glam::DVec3;
use hooke_benches::textbook::{Response, Textbook};
use hooke_runner::model::Model;
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::graphs::{Graph, tilted_box};
use hooke_tests::measure;
use hooke_tests::moment::Moment;
use hooke_tests::problems::smooth;
use hooke_tests::runs::Run;
use hooke_tests::scenes;

const GRAVITY: [f64; 3] = [0.2, -0.5, -9.7];
const STEPS: usize = 1000;
/// Relative to the size of the scene. Both round every operation at 1e-16, 1,000 steps add up to 1e-13, and the
/// scenes' own growth of a disturbance (the rope's is 156 in a second) does the rest.
const AGREEMENT: f64 = 1e-10;

type Step = fn(&mut Textbook<DVec3>, f64);

const STEPPERS: [(StepperName, Step); 2] = [
    (StepperName::ExplicitEuler, Textbook::step_explicit_euler),
    (StepperName::SemiImplicitEuler, Textbook::step_semi_implicit_euler),
];

const RESPONSES: [(CollisionForm, Response); 2] =
    [(CollisionForm::Reflect, Response::Reflect), (CollisionForm::Project, Response::Project)];

#[test]
fn problems_with_exact_solutions() {
    for problem in smooth() {
        let dt = problem.duration / 4.0 / STEPS as f64;
        for (stepper, textbook) in STEPPERS {
            let apart = difference(&problem.model, problem.gravity, (stepper, textbook), RESPONSES[0], dt).0;
            assert!(apart < AGREEMENT, "{problem:?}, {stepper}: {apart:e}");
        }
    }
}

#[test]
fn ropes_and_cloths() {
    for name in ["rope-100", "cloth-32"] {
        let (model, settings) = scenes::load(name);
        for (stepper, textbook) in STEPPERS {
            // Explicit Euler diverges at 1e-3 s here: at a fifth of it no mode has grown much within 1,000 steps.
            let dt = if stepper == StepperName::ExplicitEuler { 2e-4 } else { 1e-3 };
            let apart = difference(&model, settings.gravity, (stepper, textbook), RESPONSES[0], dt).0;
            assert!(apart < AGREEMENT, "{name}, {stepper}: {apart:e}");
        }
    }
}

#[test]
fn irregular_graphs() {
    for seed in 0..8 {
        let model = Graph::default().model(seed);
        for stepper in STEPPERS {
            let apart = difference(&model, GRAVITY, stepper, RESPONSES[0], 1e-3).0;
            assert!(apart < AGREEMENT, "{seed}, {}: {apart:e}", stepper.0);
        }
    }
}

#[test]
fn irregular_graphs_in_a_tilted_box() {
    for seed in 0..8 {
        let mut model = Graph::default().model(seed);
        model.planes = tilted_box();
        // Fast enough to meet every side.
        for particle in &mut model.particles {
            particle.velocity = particle.velocity.map(|component| 20.0 * component);
        }
        for response in RESPONSES {
            for stepper in STEPPERS {
                let mut model = model.clone();
                if stepper.0 == StepperName::ExplicitEuler && response.0 == CollisionForm::Project {
                    // A particle put on a plane without any normal velocity is still on it after the next step: the
                    // rounding of its gap decides whether it is hit again.
                    model.planes[0].restitution = 0.05;
                }
                let (apart, hits) = difference(&model, GRAVITY, stepper, response, 1e-3);
                assert!(apart < AGREEMENT, "{seed}, {}, {}: {apart:e}", stepper.0, response.0);
                assert!(hits > 100, "{seed}: {hits}");
            }
        }
    }
}

/// A part in 1e8 of one damping is seen: the agreement above is not for want of sight.
#[test]
fn a_slightly_wrong_scene_is_noticed() {
    let model = Graph::default().model(3);
    let mut wrong = model.clone();
    wrong.springs[5].damping = wrong.springs[5].damping.max(0.1) * (1.0 + 1e-8);
    let mut right = model;
    right.springs[5].damping = right.springs[5].damping.max(0.1);
    let mut run = Run::<f64>::new(&right, GRAVITY, StepperName::SemiImplicitEuler, CollisionForm::Reflect);
    run.steps(STEPS, 1e-3);
    let mut textbook = Textbook::new(&wrong, GRAVITY, Response::Reflect).unwrap();
    (0..STEPS).for_each(|_| textbook.step_semi_implicit_euler(1e-3));
    assert!(apart(&run.moment(), &moment(&textbook)) > AGREEMENT);
}

/// How far Hooke and the textbook are apart after 1,000 steps, relative to the scene's size, and Hooke's hits.
fn difference(
    model: &Model,
    gravity: [f64; 3],
    (stepper, step): (StepperName, Step),
    (form, response): (CollisionForm, Response),
    dt: f64,
) -> (f64, u32) {
    let mut run = Run::<f64>::new(model, gravity, stepper, form);
    let report = run.steps(STEPS, dt);
    let mut textbook = Textbook::new(model, gravity, response).unwrap();
    (0..STEPS).for_each(|_| step(&mut textbook, dt));
    (apart(&run.moment(), &moment(&textbook)), report.hits)
}

fn apart(left: &Moment, right: &Moment) -> f64 {
    let size = |vectors: &[[f64; 3]]| vectors.as_flattened().iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    let position = measure::position_error(left, right) / size(&right.position);
    position.max(measure::velocity_error(left, right) / size(&right.velocity))
}

fn moment(textbook: &Textbook<DVec3>) -> Moment {
    textbook.particles.iter().fold(Moment::default(), |moment, particle| {
        moment.with(particle.position.to_array(), particle.velocity.to_array())
    })
}
