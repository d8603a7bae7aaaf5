//! A clone of a world is a place to come back to, and accelerations are what velocities do next.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{Compensated, Container, ExplicitEuler, Real, Reflect, Storage, TimeOfImpact};
use hooke_runner::scene::StepperName;
use hooke_runner::simulate::{AnyStepper, Heap};
use hooke_tests::digest;
use hooke_tests::random_scenes::RandomScene;

/// The digests of a world after each of so many steps, by a stepper and a response of their own.
fn steps<R: Real>(world: &mut Container<R, Heap>, stepper: StepperName, dt: f64, count: u32) -> Vec<u64> {
    let mut stepper = AnyStepper::<R>::named(stepper, 1e-9);
    let mut response = TimeOfImpact::<R, Heap>::new();
    let one = |_| {
        world.step(stepper.any(), &mut response, R::from_f64(dt)).expect("a step");
        digest::of(&world.view())
    };
    (0..count).map(one).collect()
}

/// How many of the steppers moved anything on the way.
fn come_back<R: Real>(seed: u64) -> usize {
    let mut moved = 0;
    let scene = RandomScene::new(seed, 1.0, 0.0);
    let dt = scene.time_step();
    for stepper in [StepperName::VelocityVerlet, StepperName::Dop853, StepperName::Auto] {
        let mut world: Container<R, Heap> = scene.world();
        steps(&mut world, stepper, dt, 5);
        let place = world.clone();
        let time = world.time();
        let first = steps(&mut world, stepper, dt, 10);
        let mut again = place.clone();
        assert_eq!(again.time().to_bits(), time.to_bits());
        assert_eq!(steps(&mut again, stepper, dt, 10), first, "{seed} {stepper}");
        // What is done to one is not done to the other.
        assert_eq!(place.time().to_bits(), time.to_bits());
        moved += usize::from(digest::of(&place.clone().view()) != digest::of(&again.view()));
    }
    moved
}

#[test]
fn a_clone_goes_on_to_the_same_bits() {
    let of_seed = |seed| come_back::<f32>(seed) + come_back::<f64>(seed) + come_back::<Compensated>(seed);
    let moved: usize = (0..40).map(of_seed).sum();
    assert!(moved > 300, "{moved} of 360 runs moved anything");
}

/// The largest difference between the accelerations of a world and what an explicit step makes of its velocities, relative
/// to the largest of them; nothing where nothing bounces on the way.
fn difference<M: Storage>(world: &mut Container<f64, M>, dt: f64) -> Option<f64> {
    let accelerations: Vec<[f64; 3]> = world.view().accelerations().map(Into::into).collect();
    let before: Vec<[f64; 3]> = world.view().states().map(|(_, velocity)| velocity.into()).collect();
    let report = world.step(&mut ExplicitEuler, &mut Reflect, dt).expect("a step");
    let after: Vec<[f64; 3]> = world.view().states().map(|(_, velocity)| velocity.into()).collect();
    let largest = accelerations.iter().flatten().fold(0.0_f64, |largest, a| largest.max(a.abs()));
    let changes = before.iter().flatten().zip(after.iter().flatten()).map(|(v, w)| (w - v) / dt);
    let apart = accelerations.iter().flatten().zip(changes).map(|(a, change)| (a - change).abs());
    (report.hits == 0 && largest > 0.0).then(|| apart.fold(0.0, f64::max) / largest)
}

#[test]
fn accelerations_are_what_an_explicit_step_takes() {
    let mut compared = 0;
    for seed in 0..200 {
        let scene = RandomScene::new(seed, 1.0, 0.0);
        let mut world: Container<f64, Heap> = scene.world();
        // Rounded velocities, taken from each other and divided by so short a step, leave about 1e-16/1e-3.
        if let Some(difference) = difference(&mut world, 1e-3) {
            compared += 1;
            assert!(difference < 1e-11, "{seed}: {difference:e}");
        }
    }
    assert!(compared > 100, "{compared} scenes");
}

#[test]
fn asking_for_accelerations_changes_nothing() {
    for seed in 0..40 {
        let scene = RandomScene::new(seed, 1.0, 0.0);
        let dt = scene.time_step();
        let mut asked: Container<f64, Heap> = scene.world();
        let mut left: Container<f64, Heap> = scene.world();
        let mut steppers = [(); 2].map(|()| AnyStepper::<f64>::named(StepperName::Dop853, 1e-9));
        let mut responses = [(); 2].map(|()| TimeOfImpact::<f64, Heap>::new());
        for _ in 0..10 {
            asked.view().accelerations().for_each(drop);
            asked.step(steppers[0].any(), &mut responses[0], dt).expect("a step");
            left.step(steppers[1].any(), &mut responses[1], dt).expect("a step");
            assert_eq!(digest::of(&asked.view()), digest::of(&left.view()), "{seed}");
        }
    }
}
