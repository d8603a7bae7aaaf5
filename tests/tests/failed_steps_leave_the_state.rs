//! A step that cannot be taken leaves the state and the time as they were, and the world goes on from there.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{
    Auto, Fixed, Full, ImplicitEuler, ImplicitEulerLinearised, Particle, Plane, Project, Reflect, Spring, StepError,
    Stepper, TimeOfImpact, VelocityVerlet, World,
};
use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::digest;
use hooke_tests::runs::Run;
use hooke_tests::steppers;

/// Far too long for the fast ones of [`model`], and short enough for all.
const LONG: f64 = 1e150;
const SHORT: f64 = 1e-160;

/// Particles 2 and 3 are too fast for a long step; 3 is on a spring and so comes before 2 inside.
fn model() -> Model {
    let particle = |place: f64, speed: f64| ModelParticle {
        position: [place, 0.1 * place, 0.0],
        velocity: [speed, 0.0, 0.0],
        mass: 0.5,
        hold: Hold::Free,
    };
    let fast = 1e160;
    Model {
        particles: vec![particle(0.0, 0.1), particle(1.0, 0.2), particle(2.0, fast), particle(3.0, fast)],
        springs: vec![ModelSpring { between: [1, 3], stiffness: 1.0, damping: 0.0, rest_length: 1.5 }],
        ..Model::default()
    }
}

#[test]
fn a_step_out_of_range_names_the_first_particle_and_leaves_everything() {
    for stepper in steppers::all() {
        for &response in CollisionForm::ALL {
            let mut run = Run::<f64>::new(&model(), [0.0, 0.0, -9.81], stepper, response);
            let before = digest::of(&run.world.view());
            // Others than Euler ask for the forces at new places, and the spring's is infinite there: for particle 1, too.
            let asks = [StepperName::VelocityVerlet, StepperName::Rk4, StepperName::BlanesMoanS6, StepperName::Dop853]
                .contains(&stepper);
            let particle = if asks { 1 } else { 2 };
            let error = run.try_step(LONG);
            // With located hits particles on springs are looked at first: 3 may be named as well.
            let named = response == CollisionForm::TimeOfImpact && error == Err(StepError::NonFinite { particle: 3 });
            assert!(named || error == Err(StepError::NonFinite { particle }), "{stepper}, {response}: {error:?}");
            assert_eq!((digest::of(&run.world.view()), run.world.time()), (before, 0.0), "{stepper}, {response}");
            let mut untried = Run::<f64>::new(&model(), [0.0, 0.0, -9.81], stepper, response);
            for run in [&mut run, &mut untried] {
                run.steps(3, SHORT);
            }
            let [tried, untried] =
                [&mut run, &mut untried].map(|run| (digest::of(&run.world.view()), run.world.time()));
            assert_eq!(tried, untried, "{stepper}, {response}");
            assert_ne!(tried.0, before, "{stepper}, {response}");
        }
    }
}

/// Verlet keeps accelerations from step to step: those of a step that failed must not be taken for a later state's.
#[test]
fn what_a_failed_step_worked_out_is_forgotten() {
    let slow = |mut model: Model| {
        model.particles.truncate(2);
        model.springs[0] = ModelSpring { between: [0, 1], stiffness: 30.0, damping: 0.0, rest_length: 1.5 };
        model
    };
    let finish = |fail: bool| {
        let mut run = Run::<f64>::new(&slow(model()), [0.0; 3], StepperName::VelocityVerlet, CollisionForm::Reflect);
        run.steps(5, 1e-3);
        if fail {
            assert!(matches!(run.try_step(1e300), Err(StepError::NonFinite { .. })));
        }
        // Something from outside that changes the state, if only to itself.
        let velocity = run.world.velocity(1).unwrap();
        run.world.set_velocity(1, velocity).unwrap();
        run.steps(5, 1e-3);
        run.moment()
    };
    assert_eq!(finish(true), finish(false));
}

#[test]
fn a_workspace_that_is_too_small_is_named() {
    type Two = Fixed<2, 1, 1>;
    type NoSprings = Fixed<3, 0, 1>;
    refused(&mut VelocityVerlet::<f64, Two>::new(), 2);
    refused(&mut ImplicitEuler::<f64, Two>::new(1e-6), 2);
    refused(&mut ImplicitEuler::<f64, NoSprings>::new(1e-6), 0);
    refused(&mut ImplicitEulerLinearised::<f64, Two>::new(1e-6), 2);
    refused(&mut ImplicitEulerLinearised::<f64, NoSprings>::new(1e-6), 0);
    refused(&mut Auto::<f64, Two>::new(1e-6), 2);
    let mut world = world();
    let before = digest::of(&world.view());
    let mut verlet = VelocityVerlet::<f64, Fixed<3, 2, 1>>::new();
    let error = world.step(&mut verlet, &mut TimeOfImpact::<f64, Two>::new(), 1e-3);
    assert_eq!(error, Err(StepError::Workspace(Full { capacity: 2 })));
    assert_eq!((digest::of(&world.view()), world.time()), (before, 0.0));
    world.step(&mut verlet, &mut Project, 1e-3).unwrap();
}

fn refused(stepper: &mut impl Stepper<f64>, capacity: usize) {
    let mut world = world();
    let before = digest::of(&world.view());
    let error = world.step(stepper, &mut Reflect, 1e-3);
    assert_eq!(error, Err(StepError::Workspace(Full { capacity })));
    assert_eq!((digest::of(&world.view()), world.time()), (before, 0.0));
}

/// Three particles on two springs over a floor.
fn world() -> World<f64, 3, 2, 1> {
    let mut world = World::new();
    for place in 0..3 {
        world.add_particle(Particle::at([f64::from(place), 0.0, 1.0])).unwrap();
    }
    for first in 0..2 {
        world.add_spring(Spring::new([first, first + 1], 10.0, 0.9)).unwrap();
    }
    world.add_plane(Plane::through([0.0; 3], [0.0, 0.0, 1.0], 0.5).unwrap()).unwrap();
    world
}
