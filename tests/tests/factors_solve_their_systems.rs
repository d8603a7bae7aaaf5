//! A factorisation solves the linearised step of random graphs, with particles held and particles at rest on a plane, as
//! dense elimination does.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use glam::{DQuat, DVec3};
use hooke::{ImplicitEulerLinearised, Reflect, Response, StepReport, TimeOfImpact};
use hooke_runner::model::{Hold, Model, ModelPlane};
use hooke_runner::simulate::{Heap, world};
use hooke_tests::graphs::Graph;
use hooke_tests::moment::Moment;
use hooke_tests::problems::skew;
use hooke_tests::right_hand_side::RightHandSide;
use hooke_tests::{linearisation, measure};

const GRAVITY: [f64; 3] = [0.2, -0.5, -9.7];
/// Blocks of a factor for each spring: more than a dense one has of these graphs.
const FILL: usize = 40;
const STEP: f64 = 0.3;
/// Of the largest velocity. A residual of 1e-13 times the matrix's condition, 1 + dt²ω² = 1e5 or less.
const TOLERANCE: f64 = 1e-8;

fn graph(seed: u64) -> Model {
    Graph { stiffness: [1e3, 1e4], strain: [0.7, 1.3], ..Graph::default() }.model(seed)
}

/// One step, by a factor and nothing else.
fn step(model: &Model, gravity: [f64; 3], mut response: impl Response<f64>) -> (Moment, StepReport) {
    let mut world = world::<f64>(model, gravity).unwrap();
    let mut stepper = ImplicitEulerLinearised::<f64, Heap, FILL>::new(1e-13);
    assert!(stepper.linear_solver(&world.view(), STEP).unwrap().is_direct());
    let report = world.step(&mut stepper, &mut response, STEP).unwrap();
    assert!(report.converged, "{report:?}");
    if report.substeps <= 1 {
        // One product proves the solution, and another one or two improve its last digits.
        assert!(report.factorisations == 1 && report.linear_iterations <= 3, "{report:?}");
    }
    (moment(&world.view()), report)
}

fn moment(view: &hooke::View<'_, f64>) -> Moment {
    view.states()
        .fold(Moment::default(), |moment, (position, velocity)| moment.with(position.to_array(), velocity.to_array()))
}

fn start(model: &Model) -> Moment {
    moment(&world::<f64>(model, GRAVITY).unwrap().view())
}

fn apart(found: &Moment, expected: &Moment) -> f64 {
    let size = expected.velocity.as_flattened().iter().fold(0.1, |size: f64, v| size.max(v.abs()));
    measure::velocity_error(found, expected) / size
}

#[test]
fn with_held_particles() {
    for seed in 0..20 {
        let model = graph(seed);
        let expected = linearisation::step(&model, GRAVITY, &start(&model), &linearisation::weights(&model), STEP);
        let (found, _) = step(&model, GRAVITY, Reflect);
        assert!(apart(&found, &expected) < TOLERANCE, "seed {seed}: {:e}", apart(&found, &expected));
        // One spring more, and it is another system.
        let mut other = model.clone();
        other.springs.pop();
        let other = linearisation::step(&other, GRAVITY, &start(&model), &linearisation::weights(&model), STEP);
        let released = Model { springs: model.springs[1..].to_vec(), ..model.clone() };
        let less = linearisation::step(&released, GRAVITY, &start(&model), &linearisation::weights(&model), STEP);
        assert!(apart(&found, &other).max(apart(&found, &less)) > 1e3 * TOLERANCE, "seed {seed}");
    }
}

/// On a floor, the components along its normal of what it holds up drop out of the system. The same scene turned gives
/// the same step turned, where they are no components any more.
#[test]
fn with_particles_at_rest_on_a_plane() {
    let mut seen = 0;
    for seed in 0..60 {
        let model = on_a_floor(graph(seed));
        let at_start = start(&model);
        let mut a = vec![[0.0; 3]; model.particles.len()];
        RightHandSide::new(&model, GRAVITY).accelerate(&at_start.position, &at_start.velocity, &mut a);
        let mut weights = linearisation::weights(&model);
        let mut supported = 0;
        for (number, particle) in model.particles.iter().enumerate() {
            if particle.position[2] == 0.0 && particle.hold == Hold::Free && a[number][2] < 0.0 {
                weights[3 * number + 2] = 0.0;
                supported += 1;
            }
        }
        let expected = linearisation::step(&model, GRAVITY, &at_start, &weights, STEP);
        // What would go through the floor is stopped on the way.
        if supported == 0 || expected.position.iter().any(|position| position[2] < 0.0) {
            continue;
        }
        seen += 1;
        let (found, report) = step(&model, GRAVITY, TimeOfImpact::<f64, Heap>::new());
        assert!((report.hits, report.substeps) == (0, 1), "seed {seed}: {report:?}");
        let attached = attached(&model);
        let error = apart(&keep(&found, &attached), &keep(&expected, &attached));
        assert!(error < TOLERANCE, "seed {seed}: {error:e}");

        let turn = skew();
        let gravity = (turn * DVec3::from(GRAVITY)).to_array();
        let (turned, _) = step(&turned(&model, turn), gravity, TimeOfImpact::<f64, Heap>::new());
        let back =
            |vectors: &[[f64; 3]]| vectors.iter().map(|v| (turn.inverse() * DVec3::from(*v)).to_array()).collect();
        let turned = Moment { position: back(&turned.position), velocity: back(&turned.velocity) };
        let error = apart(&keep(&turned, &attached), &keep(&expected, &attached));
        assert!(error < TOLERANCE, "seed {seed}, turned: {error:e}");
    }
    assert!(seen >= 5, "{seen} scenes tell");
}

/// A third of the graph rests on the floor z = 0, what flies freely is far above it.
fn on_a_floor(mut model: Model) -> Model {
    for (number, particle) in model.particles.iter_mut().enumerate() {
        particle.velocity = [0.0; 3];
        particle.position[2] = match number % 4 {
            0 => 0.0,
            2 => 100.0,
            _ => particle.position[2].abs() + 2.0,
        };
    }
    model.planes = vec![ModelPlane { point: [0.0; 3], normal: [0.0, 0.0, 1.0], restitution: 0.0 }];
    model
}

fn turned(model: &Model, turn: DQuat) -> Model {
    let mut model = model.clone();
    let turn = |vector: &mut [f64; 3]| *vector = (turn * DVec3::from(*vector)).to_array();
    for particle in &mut model.particles {
        turn(&mut particle.position);
        turn(&mut particle.velocity);
    }
    model.planes.iter_mut().for_each(|plane| turn(&mut plane.normal));
    model
}

/// Particles that springs pull at: the others fly by a rule of their own.
fn attached(model: &Model) -> Vec<usize> {
    let numbers = 0..model.particles.len();
    numbers.filter(|number| model.springs.iter().any(|spring| spring.between.contains(&(*number as u32)))).collect()
}

fn keep(moment: &Moment, numbers: &[usize]) -> Moment {
    let pick = |vectors: &[[f64; 3]]| numbers.iter().map(|number| vectors[*number]).collect();
    Moment { position: pick(&moment.position), velocity: pick(&moment.velocity) }
}
