//! A mesh whose numbers lead far apart is renumbered inside: its springs reach as little far as they must, and nobody
//! outside can tell.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use glam::DVec3;
use hooke::{Plan, Sleep};
use hooke_benches::mesh::irregular;
use hooke_benches::textbook::{Response, Textbook};
use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_runner::simulate::world;
use hooke_tests::measure;
use hooke_tests::moment::Moment;
use hooke_tests::random::Random;
use hooke_tests::runs::Run;

const GRAVITY: [f64; 3] = [0.1, 0.0, -9.81];
const TIME_STEP: f64 = 1e-3;
const STEPS: usize = 200;
/// m. Sums in another order differ by 1e-16 of what is added up.
const AGREEMENT: f64 = 1e-11;

/// Random numbers for the particles.
fn numbers(count: usize, seed: u64) -> Vec<u32> {
    let mut random = Random::new(seed);
    let mut numbers: Vec<u32> = (0..count as u32).collect();
    for last in (1..count).rev() {
        numbers.swap(last, random.below(last + 1));
    }
    numbers
}

/// The model with its particles numbered like this.
fn numbered(model: &Model, numbers: &[u32]) -> Model {
    let mut other = model.clone();
    for (particle, number) in model.particles.iter().zip(numbers) {
        other.particles[*number as usize] = *particle;
    }
    for spring in &mut other.springs {
        spring.between = spring.between.map(|end| numbers[end as usize]);
    }
    other
}

fn shuffled(model: &Model, seed: u64) -> Model {
    numbered(model, &numbers(model.particles.len(), seed))
}

/// A grid whose particles are joined to their neighbours in its rows and columns, the first of them pinned.
fn grid(width: u32, height: u32) -> Model {
    let mut model = Model::default();
    for (v, u) in (0..height).flat_map(|v| (0..width).map(move |u| (v, u))) {
        let number = v * width + u;
        let hold = if number == 0 { Hold::Pinned } else { Hold::Free };
        let position = [f64::from(u) * 0.1, f64::from(v) * 0.1, 0.0];
        model.particles.push(ModelParticle { position, velocity: [0.0; 3], mass: 0.01, hold });
        let mut join = |other: u32| {
            let between = [other, number];
            model.springs.push(ModelSpring { between, stiffness: 50.0, damping: 0.02, rest_length: 0.1 });
        };
        if u > 0 {
            join(number - 1);
        }
        if v > 0 {
            join(number - width);
        }
    }
    model
}

/// One scene of both: the particles of the first have the numbers that `is_first` tells, in order.
fn together(first: &Model, second: &Model, is_first: impl Fn(usize) -> bool) -> (Model, [Vec<u32>; 2]) {
    let mut both = Model::default();
    let mut numbers = [Vec::new(), Vec::new()];
    let mut particles = [first.particles.iter(), second.particles.iter()];
    for number in 0..first.particles.len() + second.particles.len() {
        let wanted = usize::from(!is_first(number));
        let source = if particles[wanted].len() > 0 { wanted } else { 1 - wanted };
        both.particles.push(*particles[source].next().unwrap());
        numbers[source].push(number as u32);
    }
    for (model, numbers) in [first, second].into_iter().zip(&numbers) {
        let renamed = |spring: &ModelSpring| spring.between.map(|end| numbers[end as usize]);
        both.springs.extend(model.springs.iter().map(|spring| ModelSpring { between: renamed(spring), ..*spring }));
    }
    (both, numbers)
}

fn plan(model: &Model) -> Plan {
    *world::<f32>(model, GRAVITY).unwrap().view().plan()
}

fn run(model: &Model) -> Run<f64> {
    Run::new(model, GRAVITY, StepperName::SemiImplicitEuler, CollisionForm::Project)
}

fn after(model: &Model) -> Moment {
    let mut run = run(model);
    run.steps(STEPS, TIME_STEP);
    run.moment()
}

fn of(moment: &Moment, numbers: &[u32]) -> Moment {
    numbers.iter().fold(Moment::default(), |part, number| {
        part.with(moment.position[*number as usize], moment.velocity[*number as usize])
    })
}

fn apart(left: &Moment, right: &Moment) -> f64 {
    measure::position_error(left, right).max(TIME_STEP * measure::velocity_error(left, right))
}

fn textbook(model: &Model) -> Moment {
    let mut textbook = Textbook::<DVec3>::new(model, GRAVITY, Response::Project).unwrap();
    (0..STEPS).for_each(|_| textbook.step_semi_implicit_euler(TIME_STEP));
    textbook.particles.iter().fold(Moment::default(), |moment, particle| {
        moment.with(particle.position.to_array(), particle.velocity.to_array())
    })
}

#[test]
fn particles_move_as_the_textbook_says() {
    let mesh = shuffled(&irregular(32), 1);
    assert_eq!(plan(&mesh).renumbered, 1024);
    let apart_from = |other: &Model| apart(&after(&mesh), &textbook(other));
    assert!(apart_from(&mesh) < AGREEMENT, "{:e}", apart_from(&mesh));
    // What would show otherwise: two particles in each other's place, a slightly different spring.
    let mut other = mesh.clone();
    other.particles.swap(100, 101);
    assert!(apart_from(&other) > 1e-3);
    let mut other = mesh.clone();
    other.springs[700].stiffness *= 1.0 + 1e-5;
    assert!(apart_from(&other) > AGREEMENT, "{:e}", apart_from(&other));
}

#[test]
fn particles_move_as_with_other_numbers() {
    let mesh = irregular(32);
    let numbers = numbers(mesh.particles.len(), 2);
    let apart = apart(&of(&after(&numbered(&mesh, &numbers)), &numbers), &after(&mesh));
    assert!(apart < AGREEMENT, "{apart:e}");
}

#[test]
fn states_are_in_the_order_of_the_numbers() {
    let mesh = shuffled(&irregular(30), 3);
    let mut run = run(&mesh);
    assert_eq!(run.world.view().plan().renumbered, 900);
    assert!(run.moment() == Moment::start(&mesh));
    for (number, particle) in (0..).zip(&mesh.particles) {
        assert!(run.world.position(number).unwrap() == DVec3::from(particle.position));
    }
    run.world.set_position(77, [5.0, 6.0, 7.0]).unwrap();
    run.world.set_velocity(78, [1.0, 2.0, 3.0]).unwrap();
    let mut expected = Moment::start(&mesh);
    expected.position[77] = [5.0, 6.0, 7.0];
    expected.velocity[78] = [1.0, 2.0, 3.0];
    assert!(run.moment() == expected);
}

#[test]
fn a_path_becomes_a_diagonal() {
    for particles in [66, 100, 257, 1000] {
        let plan = plan(&shuffled(&grid(particles, 1), 4));
        assert_eq!((plan.renumbered, plan.reach, plan.span), (particles, 1, 1));
        assert_eq!((plan.on_diagonals, plan.springs), (particles - 1, particles - 1));
        assert!(plan.reach_by_number > particles / 2, "{plan:?}");
    }
}

/// Breadth first from a corner come the short diagonals of a grid, one more than as long as its shorter side at most.
#[test]
fn a_grid_reaches_no_further_than_its_shorter_side() {
    for [width, height] in [[30, 30], [20, 20], [7, 100], [100, 7], [64, 33]] {
        let plan = plan(&shuffled(&grid(width, height), 5));
        assert_eq!(plan.renumbered, width * height);
        assert!(plan.reach <= width.min(height) + 1 && plan.span == plan.reach, "{width} {height}: {plan:?}");
    }
}

#[test]
fn what_is_numbered_well_stays_as_it_is() {
    // Rows on diagonals, where other numbers would make a spring reach less far; and a mesh that could not be better.
    for (name, model) in [("rows", grid(300, 12)), ("a path", grid(5000, 1)), ("a mesh", irregular(64))] {
        assert_eq!(plan(&model).renumbered, 0, "{name}");
        assert!(plan(&shuffled(&model, 6)).renumbered > 0, "{name}");
    }
    // All of it is in the cache, and no numbers put it on diagonals.
    assert_eq!(plan(&shuffled(&irregular(20), 6)).renumbered, 0);
}

#[test]
fn rows_beside_a_mesh_stay_on_their_diagonals() {
    let (rows, mesh) = (grid(100, 40), shuffled(&irregular(30), 7));
    let both = plan(&together(&rows, &mesh, |number| number % 3 != 0).0);
    let [rows, mesh] = [plan(&rows), plan(&mesh)];
    assert_eq!((rows.on_diagonals, both.renumbered, both.reach), (rows.springs, 900, mesh.reach));
    assert!(both.on_diagonals >= rows.on_diagonals, "{both:?}");
}

#[test]
fn a_mesh_moves_as_if_alone() {
    let mesh = shuffled(&irregular(30), 8);
    let alone = after(&mesh);
    let others = [grid(100, 3), shuffled(&grid(30, 10), 9), shuffled(&irregular(29), 10), grid(1, 1)];
    for (index, other) in others.iter().enumerate() {
        let is_first: [fn(usize) -> bool; 3] = [|_| true, |_| false, |number| number % 2 == 0];
        for (arrangement, is_first) in is_first.into_iter().enumerate() {
            let (both, [first, _]) = together(&mesh, other, is_first);
            assert!(of(&after(&both), &first) == alone, "beside {index}, {arrangement}");
        }
    }
    // What would show otherwise: the same mesh with other numbers adds its forces in another order.
    let numbers = numbers(mesh.particles.len(), 11);
    assert!(of(&after(&numbered(&mesh, &numbers)), &numbers) != alone);
}

#[test]
fn a_mesh_moves_as_if_alone_while_others_sleep() {
    let weightless = |model: &Model| Run::new(model, [0.0; 3], StepperName::SemiImplicitEuler, CollisionForm::Project);
    let mut mesh = shuffled(&irregular(30), 12);
    mesh.particles.iter_mut().for_each(|particle| particle.velocity[2] = 5.0 * particle.position[0]);
    let mut alone: Run<f64> = weightless(&mesh);
    alone.steps(STEPS, TIME_STEP);
    // Two that are at rest, and renumbered until they sleep.
    let resting = together(&shuffled(&grid(30, 10), 13), &shuffled(&grid(11, 11), 14), |number| number % 3 == 0).0;
    let (both, [first, second]) = together(&mesh, &resting, |number| number % 2 == 1);
    let mut run: Run<f64> = weightless(&both);
    run.world.set_sleep(Some(Sleep::below(1e-6).after(0.02))).unwrap();
    assert_eq!(run.world.view().plan().renumbered as usize, both.particles.len());
    run.steps(STEPS, TIME_STEP);
    let plan = *run.world.view().plan();
    assert_eq!((plan.islands, plan.islands_asleep, plan.renumbered), (3, 2, 900));
    assert!(of(&run.moment(), &first) == alone.moment());
    assert!(apart(&of(&run.moment(), &second), &Moment::start(&resting)) < AGREEMENT);
    // Woken, they are renumbered again.
    run.world.set_velocity(second[5], [0.0, 0.0, 1.0]).unwrap();
    assert!(run.world.view().plan().renumbered > 900);
}

/// Whatever slots an earlier preparation gave: preparing a scene half-made changes nothing.
#[test]
fn earlier_preparations_leave_no_trace() {
    let mesh = shuffled(&irregular(30), 14);
    let mut run = run(&Model { springs: Vec::new(), ..mesh.clone() });
    for (number, spring) in mesh.springs.iter().enumerate() {
        let ModelSpring { between, stiffness, damping, rest_length } = *spring;
        let spring = hooke::Spring::new(between, stiffness, rest_length).with_damping(damping);
        run.world.add_spring(spring).unwrap();
        if number % 100 == 0 {
            run.world.view();
        }
    }
    run.steps(STEPS, TIME_STEP);
    assert!(run.moment() == after(&mesh));
}
