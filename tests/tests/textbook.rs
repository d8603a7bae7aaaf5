//! The textbook loop does what the textbook says: one step of everything, by hand.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use glam::DVec3;
use hooke_benches::textbook::{KinematicParticle, Response, Textbook};
use hooke_runner::model::{Hold, Model, ModelParticle, ModelPlane, ModelSpring};
use hooke_tests::problems::oscillator::Oscillator;
use hooke_tests::problems::{Problem, bouncing, smooth};
use hooke_tests::right_hand_side::RightHandSide;
use hooke_tests::{measure, moment::Moment, order};

type Step = fn(&mut Textbook<DVec3>, f64);

const STEPS: [Step; 2] = [Textbook::step_explicit_euler, Textbook::step_semi_implicit_euler];

#[test]
fn a_step_is_the_formula() {
    for problem in smooth() {
        let start = Moment::start(&problem.model);
        let law = RightHandSide::new(&problem.model, problem.gravity);
        let mut acceleration = vec![[0.0; 3]; start.position.len()];
        law.accelerate(&start.position, &start.velocity, &mut acceleration);
        let dt = 1e-2;
        for (step, new_velocity) in STEPS.into_iter().zip([false, true]) {
            let mut textbook = build(&problem, Response::Reflect);
            step(&mut textbook, dt);
            for (number, particle) in textbook.particles.iter().enumerate() {
                let [x, v, a] =
                    [&start.position, &start.velocity, &acceleration].map(|vectors| DVec3::from(vectors[number]));
                let velocity = v + dt * a;
                let position = x + dt * if new_velocity { velocity } else { v };
                // Rounding of numbers of size 10.
                assert!(particle.velocity.distance(velocity) < 1e-13, "{problem:?}");
                assert!(particle.position.distance(position) < 1e-13, "{problem:?}");
            }
        }
    }
}

#[test]
fn both_eulers_are_of_order_one() {
    let oscillator = Oscillator { damping_ratio: 0.2, ..Oscillator::default() };
    let problem = oscillator.problem();
    let duration = 0.4;
    for step in STEPS {
        let order = order::observed(&[4e-4, 2e-4, 1e-4], |dt| {
            let mut textbook = build(&problem, Response::Reflect);
            for _ in 0..(duration / dt).round() as usize {
                step(&mut textbook, dt);
            }
            measure::position_error(&moment(&textbook), &(problem.exact)(duration))
        });
        // The error's next term is smaller by ω dt, 0.008 at most, times a few.
        assert!((order.slope - 1.0).abs() < 0.05, "{order:?}");
    }
}

#[test]
fn responses_differ_in_the_position_only() {
    for mut problem in bouncing() {
        let plane = problem.model.planes[0];
        let normal = DVec3::from(plane.normal);
        let hit = problem.impacts[0];
        // On the plane at the impact's speed: the step carries it below, before anything is tested.
        let particle = &mut problem.model.particles[hit.particle];
        let velocity = DVec3::from(particle.velocity).reject_from(normal) - hit.speed * normal;
        let lift = normal.dot(DVec3::from(plane.point) - DVec3::from(particle.position));
        particle.position = (DVec3::from(particle.position) + lift * normal).to_array();
        particle.velocity = velocity.to_array();
        let dt = 1e-3;
        let [reflected, projected] = [Response::Reflect, Response::Project].map(|response| {
            let mut textbook = build(&problem, response);
            textbook.step_explicit_euler(dt);
            textbook.particles[hit.particle]
        });
        let mut unhindered = build(&problem, Response::Reflect);
        unhindered.planes.clear();
        unhindered.step_explicit_euler(dt);
        let free = unhindered.particles[hit.particle];
        let incoming = normal.dot(free.velocity);
        let bounced = free.velocity - (1.0 + plane.restitution) * incoming * normal;
        let gap = |position: DVec3| normal.dot(position - DVec3::from(plane.point));
        assert_eq!(reflected.velocity, projected.velocity);
        // Rounding of positions and speeds below 10.
        assert!(reflected.velocity.distance(bounced) < 1e-14, "{problem:?}");
        assert_eq!(reflected.position, free.position, "{problem:?}");
        assert!((gap(reflected.position) + dt * hit.speed).abs() < 1e-14);
        assert!(gap(projected.position).abs() < 1e-15);
        let moved = projected.position - reflected.position;
        assert!(moved.reject_from(normal).length() < 1e-15);
    }
}

#[test]
fn a_particle_that_leaves_a_plane_is_not_hit() {
    let mut problem = bouncing().swap_remove(0);
    let normal = DVec3::from(problem.model.planes[0].normal);
    let particle = &mut problem.model.particles[0];
    particle.position = (-0.1 * normal).to_array();
    particle.velocity = (2.0 * normal).to_array();
    let mut textbook = build(&problem, Response::Project);
    textbook.step_explicit_euler(1e-3);
    assert!(normal.dot(textbook.particles[0].velocity) > 1.9);
    assert!(normal.dot(textbook.particles[0].position) < -0.09);
}

#[test]
fn pins_stay_and_springs_of_no_length_do_not_pull() {
    let particle = |hold| ModelParticle { position: [0.1, 0.2, -0.3], velocity: [0.0, 0.0, -1.0], mass: 2.0, hold };
    let model = Model {
        particles: vec![particle(Hold::Pinned), particle(Hold::Free)],
        springs: vec![ModelSpring { between: [0, 1], stiffness: 10.0, damping: 1.0, rest_length: 0.5 }],
        planes: vec![ModelPlane { point: [0.0; 3], normal: [0.0, 0.0, 1.0], restitution: 0.5 }],
        ..Model::default()
    };
    let mut textbook = Textbook::<DVec3>::new(&model, [0.0, 0.0, -10.0], Response::Project).unwrap();
    textbook.step_semi_implicit_euler(0.1);
    let [pin, mass] = [0, 1].map(|number| textbook.particles[number]);
    assert_eq!(pin.position.to_array(), [0.1, 0.2, -0.3]);
    assert_eq!(pin.velocity, DVec3::ZERO);
    // Only gravity: −1 − 0.1 × 10, halved by the bounce; the spring, though far from its rest length, is silent.
    assert_eq!(mass.velocity.to_array(), [0.0, 0.0, 1.0]);
    assert_eq!(mass.position.to_array(), [0.1, 0.2, 0.0]);
}

#[test]
fn keyframes_are_refused() {
    let mut model = smooth().swap_remove(1).model;
    model.particles[1].hold = Hold::Track(0);
    let refused = Textbook::<DVec3>::new(&model, [0.0; 3], Response::Reflect);
    assert_eq!(refused.err(), Some(KinematicParticle(1)));
}

fn build(problem: &Problem, response: Response) -> Textbook<DVec3> {
    Textbook::new(&problem.model, problem.gravity, response).unwrap()
}

fn moment(textbook: &Textbook<DVec3>) -> Moment {
    let particles = textbook.particles.iter();
    particles.fold(Moment::default(), |moment, particle| {
        moment.with(particle.position.to_array(), particle.velocity.to_array())
    })
}
