//! Implicit steps by a factorisation and by conjugate gradients are the same to the tolerance, and a rope's work grows
//! as its length.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{Fixed, ImplicitEuler, Particle, Reflect, Spring, StepReport, Storage, World};
use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::simulate::{Heap, world};
use hooke_tests::graphs::Graph;
use hooke_tests::{digest, scenes};

const GRAVITY: [f64; 3] = [0.2, -0.5, -9.7];

/// A chain, one end pinned, each particle hung to another one: its predecessor, or for a tree its parent.
fn chain(particles: u32, stiffness: f64, parent: fn(u32) -> u32) -> Model {
    let particle = |number: u32| ModelParticle {
        position: [0.01 * f64::from(number), 0.0, 0.003 * f64::from(number % 7)],
        velocity: [0.0; 3],
        mass: 0.01,
        hold: if number == 0 { Hold::Pinned } else { Hold::Free },
    };
    let spring =
        |number: u32| ModelSpring { between: [parent(number), number], stiffness, damping: 0.1, rest_length: 0.01 };
    Model {
        particles: (0..particles).map(particle).collect(),
        springs: (1..particles).map(spring).collect(),
        ..Model::default()
    }
}

fn rope(particles: u32, stiffness: f64) -> Model {
    chain(particles, stiffness, |number| number - 1)
}

fn run<const FILL: usize>(model: &Model, dt: f64, steps: usize) -> (Vec<[f64; 6]>, StepReport) {
    let mut world = world::<f64>(model, GRAVITY).unwrap();
    let mut stepper = ImplicitEuler::<f64, Heap, FILL>::new(1e-11);
    let mut total = StepReport::default();
    for _ in 0..steps {
        total.add(&world.step(&mut stepper, &mut Reflect, dt).unwrap());
    }
    let states = world.view().states().map(|(x, v)| [x.x, x.y, x.z, v.x, v.y, v.z]).collect();
    (states, total)
}

#[test]
fn their_steps_agree() {
    let mut models = vec![("rope", rope(60, 1e4)), ("tree", chain(60, 1e4, |number| (number - 1) / 2))];
    for seed in 0..4 {
        models.push(("graph", Graph { stiffness: [1e3, 1e5], strain: [0.9, 1.1], ..Graph::default() }.model(seed)));
    }
    let (mut cloth, _) = scenes::load("cloth-32");
    cloth.springs.retain(|spring| spring.between.iter().all(|number| number % 32 < 8 && number / 32 < 8));
    cloth.springs.iter_mut().for_each(|spring| spring.stiffness = 1e5);
    models.push(("cloth", cloth));
    for (name, model) in models {
        let (direct, by_factor) = run::<40>(&model, 1.0 / 60.0, 3);
        let (gradients, without) = run::<0>(&model, 1.0 / 60.0, 3);
        assert!(by_factor.factorisations > 0 && without.factorisations == 0, "{name}: {by_factor:?}, {without:?}");
        assert!(by_factor.linear_iterations < without.linear_iterations, "{name}: {by_factor:?}, {without:?}");
        assert!(by_factor.converged && without.converged, "{name}: {by_factor:?}, {without:?}");
        let apart = direct.as_flattened().iter().zip(gradients.as_flattened()).map(|(a, b)| (a - b).abs());
        let size = direct.as_flattened().iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        // The tolerance on the residual times the condition of its matrix, 1 + dt²ω²: 1e-11 x 1e4.
        let apart = apart.fold(0.0, f64::max) / size;
        assert!(apart < 1e-7, "{name}: {apart:e}");
        // Another tolerance is another solution: the comparison can tell.
        assert_ne!(direct, gradients, "{name}");
    }
}

/// Squeezed springs bend the matrix as it is down: a pivot that is not positive must not pass for a solution. A rope that
/// buckles all at once takes more than a hundred iterations, by either solver; the steps after it are solved.
#[test]
fn a_matrix_that_is_not_definite_has_no_factor() {
    let mut model = rope(40, 1e4);
    model.springs.iter_mut().for_each(|spring| spring.rest_length *= 1.2);
    for dt in [3e-3, 1e-2, 0.1] {
        let mut world = world::<f64>(&model, GRAVITY).unwrap();
        let mut stepper = ImplicitEuler::<f64, Heap, 1>::new(1e-11);
        let buckling = world.step(&mut stepper, &mut Reflect, dt).unwrap();
        // Where the matrix as it is has no factor, the definite one has.
        assert!(buckling.factorisations > buckling.iterations, "{dt}: {buckling:?}");
        for step in 1..20 {
            let report = world.step(&mut stepper, &mut Reflect, dt).unwrap();
            assert!(report.converged && report.factorisations > 0, "{dt}, step {step}: {report:?}");
        }
    }
}

/// Products of two blocks, blocks, and products with the matrix: counted, not timed.
#[test]
fn the_work_of_a_rope_grows_as_its_length() {
    for particles in [100, 1_000, 10_000, 100_000] {
        let model = rope(particles, 1e4);
        let solver = solver::<1>(&model);
        assert!(solver.is_direct(), "{particles}: {solver}");
        let links = particles - 2;
        // A pivot each, and for each link the division by it and its square.
        assert_eq!(solver.elimination.blocks, links);
        assert_eq!(solver.elimination.products, f64::from(particles - 1) + 2.0 * f64::from(links));
        let (_, report) = run::<1>(&model, 1.0 / 60.0, 1);
        assert!(report.converged && report.iterations <= 12, "{particles}: {report:?}");
        assert!(report.linear_iterations <= 3 * report.iterations, "{particles}: {report:?}");
    }
    // Conjugate gradients need more iterations for a longer rope.
    let without = [10, 100].map(|particles| run::<0>(&rope(particles, 1e5), 1.0 / 60.0, 1).1);
    let [short, long] = without.map(|report| f64::from(report.linear_iterations) / f64::from(report.iterations));
    assert!(long > 4.0 * short, "{without:?}");
}

/// Trees leave no fill whatever order their particles come in; a ring leaves one block for all but three of its springs.
#[test]
fn trees_leave_no_fill_and_rings_do() {
    let parents: [fn(u32) -> u32; 4] =
        [|_| 0, |number| (number - 1) / 2, |number| number / 3, |number| number.min(1) * (number - 1)];
    for parent in parents {
        let model = chain(500, 1e5, parent);
        let held = model.springs.iter().filter(|spring| spring.between.contains(&0)).count();
        assert_eq!(solver::<1>(&model).elimination.blocks as usize, model.springs.len() - held);
    }
    let mut ring = rope(500, 1e5);
    ring.springs.push(ModelSpring { between: [499, 1], ..ring.springs[0] });
    // 499 particles in a ring of 499 springs: each elimination but the last two leaves two blocks.
    assert_eq!(solver::<2>(&ring).elimination.blocks, 2 * 497 + 1);
    // That is more than one a spring: with room for that there is no factor.
    assert!(!solver::<1>(&ring).is_direct());
}

fn solver<const FILL: usize>(model: &Model) -> hooke::LinearSolver {
    let mut world = world::<f64>(model, GRAVITY).unwrap();
    ImplicitEuler::<f64, Heap, FILL>::new(1e-6).linear_solver(&world.view(), 1.0 / 60.0).unwrap()
}

/// What is chosen depends on the springs and on `FILL`, and not on the capacity: a ring needs two blocks a spring, and gets
/// no factor where `FILL` is 1, though a large workspace had room for it. With one particle held it is a rope.
#[test]
fn the_choice_does_not_depend_on_the_capacity() {
    for (pinned, is_direct) in [(true, true), (false, false)] {
        let found = [bits::<Heap>(pinned), bits::<Fixed<20, 20, 0>>(pinned), bits::<Fixed<200, 400, 0>>(pinned)];
        assert!(found.iter().all(|other| *other == found[0]), "{found:?}");
        assert_eq!(found[0].1 > 0, is_direct);
    }
}

/// The digest of a ring after some steps, and how often there was a factor.
fn bits<M: Storage>(pinned: bool) -> (u64, u32) {
    let mut world = World::<f32, 20, 20, 0>::new();
    world.set_gravity([0.2, -0.5, -9.7]).unwrap();
    for number in 0..20_u8 {
        let (sine, cosine) = (0.1 * std::f32::consts::PI * f32::from(number)).sin_cos();
        let particle = Particle::at([cosine, sine, 0.0]).with_mass(0.01);
        world.add_particle(if pinned && number == 0 { particle.pinned() } else { particle }).unwrap();
    }
    for number in 0..20 {
        world.add_spring(Spring::new([number, (number + 1) % 20], 1e5, 0.3)).unwrap();
    }
    let mut stepper = ImplicitEuler::<f32, M, 1>::new(1e-6);
    let mut factorisations = 0;
    for _ in 0..20 {
        factorisations += world.step(&mut stepper, &mut Reflect, 0.01).unwrap().factorisations;
    }
    (digest::of(&world.view()), factorisations)
}
