//! What rests sleeps if it is asked to, nothing else does, and nobody who is awake can tell.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{Hold, Ledger, Particle, Plane, Project, Real, Sleep, Spring, VelocityVerlet};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_runner::simulate::{AnyResponse, AnyStepper, Heap, HeapWorld};
use hooke_tests::steppers;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
const STIFFNESS: f64 = 200.0;
const MASS: f64 = 0.01;
const SPACING: f64 = 0.1;

/// s; h = ω dt is 0.28 at most.
const TIME_STEP: f64 = 1e-3;

/// Eight looks, 6 steps apart.
fn soon<R: Real>() -> Sleep<R> {
    Sleep::below(R::from_f64(2e-2)).after(R::from_f64(0.048))
}

fn particle<R: Real>(position: [f64; 3], velocity: [f64; 3]) -> Particle<R> {
    let vector = |vector: [f64; 3]| vector.map(R::Coordinate::from_f64);
    Particle::at(vector(position)).with_velocity(vector(velocity)).with_mass(R::from_f64(MASS))
}

/// A world without anything but gravity.
fn empty<R: Real>() -> HeapWorld<R> {
    let mut world = HeapWorld::new();
    world.set_gravity(GRAVITY.map(R::Coordinate::from_f64)).unwrap();
    world
}

/// Particles hanging below one another from a pin, each spring drawn out by the weight below it, so that they are at
/// rest but for roundings; unless they are given a velocity. Returns the numbers.
fn hang<R: Real>(world: &mut HeapWorld<R>, from: [f64; 3], links: u32, velocity: [f64; 3]) -> Vec<u32> {
    let mut place = from;
    let mut numbers = vec![world.add_particle(particle(place, [0.0; 3]).pinned()).unwrap()];
    for link in 0..links {
        place[2] -= SPACING + f64::from(links - link) * MASS * 9.81 / STIFFNESS;
        let number = world.add_particle(particle(place, velocity)).unwrap();
        let spring = Spring::new([number - 1, number], R::from_f64(STIFFNESS), R::from_f64(SPACING));
        world.add_spring(spring.with_damping(R::from_f64(0.02))).unwrap();
        numbers.push(number);
    }
    numbers
}

fn bits<R: Real>(world: &HeapWorld<R>, particles: &[u32]) -> Vec<u64> {
    let states = particles.iter().flat_map(|particle| {
        let [x, v]: [[R::Coordinate; 3]; 2] =
            [world.position(*particle).unwrap().into(), world.velocity(*particle).unwrap().into()];
        x.into_iter().chain(v)
    });
    states.map(|value| value.to_f64().to_bits()).collect()
}

/// Ropes that swing and balls in flight over a floor, alone or `among` others that rest; the numbers of those that move.
fn scene<R: Real>(among: bool, swing: f64) -> (HeapWorld<R>, Vec<u32>) {
    let mut world = empty();
    let mut moving = Vec::new();
    for rope in 0..30_u32 {
        let from = [0.3 * f64::from(rope), 0.0, 3.0];
        let swings = rope % 7 == 3;
        if swings {
            moving.extend(hang(&mut world, from, 12, [swing, 0.1 * f64::from(rope), 0.0]));
            moving.push(world.add_particle(particle(from, [0.2, 0.0, 1.0])).unwrap());
        } else if among {
            hang(&mut world, from, 3 + rope % 9, [0.0; 3]);
        }
    }
    let floor =
        Plane::through([R::Coordinate::ZERO; 3], GRAVITY.map(|g| R::Coordinate::from_f64(-g)), R::from_f64(0.7))
            .unwrap();
    world.add_plane(floor).unwrap();
    (world, moving)
}

fn step<R: Real>(world: &mut HeapWorld<R>, stepper: StepperName, response: CollisionForm, steps: u32) {
    let mut stepper = AnyStepper::named(stepper, 1e-6);
    let mut response = AnyResponse::named(response);
    for _ in 0..steps {
        world.step(stepper.any(), &mut response, R::from_f64(TIME_STEP)).unwrap();
    }
}

fn awake_as_if_alone<R: Real>() {
    let steppers =
        [StepperName::ExplicitEuler, StepperName::SemiImplicitEuler, StepperName::VelocityVerlet, StepperName::Auto];
    for stepper in steppers {
        for response in [CollisionForm::Reflect, CollisionForm::Project, CollisionForm::TimeOfImpact] {
            let (mut alone, movers) = scene::<R>(false, 1.0);
            step(&mut alone, stepper, response, 700);
            let (mut among, same) = scene::<R>(true, 1.0);
            among.set_sleep(Some(soon())).unwrap();
            step(&mut among, stepper, response, 700);
            let plan = *among.view().plan();
            assert_eq!((plan.islands, plan.islands_asleep), (30, 26), "{stepper} {response}");
            assert!(bits(&alone, &movers) == bits(&among, &same), "{stepper} {response}");
            // They would not be the same by chance.
            let (mut other, movers) = scene::<R>(false, 1.0 + R::EPSILON.to_f64());
            step(&mut other, stepper, response, 700);
            assert!(bits(&other, &movers) != bits(&among, &same), "{stepper} {response}");
        }
    }
}

#[test]
fn the_awake_move_as_if_alone() {
    awake_as_if_alone::<f32>();
    awake_as_if_alone::<f64>();
}

#[test]
fn what_sleeps_stays() {
    for stepper in steppers::all() {
        let mut world = empty::<f64>();
        let rope = hang(&mut world, [0.0, 0.0, 3.0], 5, [0.0; 3]);
        world.set_sleep(Some(soon())).unwrap();
        step(&mut world, stepper, CollisionForm::TimeOfImpact, 60);
        assert_eq!(world.view().plan().islands_asleep, 1, "{stepper}");
        assert!(rope.iter().all(|particle| world.velocity(*particle).unwrap().length() == 0.0));
        let before = bits(&world, &rope);
        let mut stepper_again = AnyStepper::named(stepper, 1e-6);
        for _ in 0..100 {
            let report = world.step(stepper_again.any(), &mut Project, TIME_STEP).unwrap();
            assert_eq!(report.islands_asleep, 1, "{stepper}");
        }
        assert!(before == bits(&world, &rope), "{stepper}");
        // No spring is looked at any more.
        let plan = *world.view().plan();
        assert_eq!((plan.springs_asleep, plan.asleep), (plan.springs, plan.particles), "{stepper}");
    }
}

#[test]
fn nothing_sleeps_unasked() {
    let mut world = empty::<f64>();
    hang(&mut world, [0.0, 0.0, 3.0], 5, [0.0; 3]);
    step(&mut world, StepperName::SemiImplicitEuler, CollisionForm::Project, 2000);
    let plan = *world.view().plan();
    assert_eq!((plan.islands, plan.islands_asleep, plan.asleep), (0, 0, 0));
}

/// Two ropes, asleep.
fn asleep() -> (HeapWorld<f64>, Vec<u32>) {
    let mut world = empty();
    let first = hang(&mut world, [0.0, 0.0, 3.0], 5, [0.0; 3]);
    hang(&mut world, [1.0, 0.0, 3.0], 5, [0.0; 3]);
    world.set_sleep(Some(soon())).unwrap();
    step(&mut world, StepperName::SemiImplicitEuler, CollisionForm::Project, 60);
    assert_eq!(world.view().plan().islands_asleep, 2);
    (world, first)
}

#[test]
fn every_change_from_outside_wakes() {
    type Change = fn(&mut HeapWorld<f64>, &[u32]);
    let changes: [(&str, u32, Change); 11] = [
        ("nothing", 2, |_, _| ()),
        ("a particle somewhere else", 2, |world, _| {
            world.add_particle(particle([5.0; 3], [1.0; 3])).unwrap();
        }),
        ("a position", 1, |world, rope| world.set_position(rope[3], [0.1, 0.0, 2.5]).unwrap()),
        ("a velocity", 1, |world, rope| world.set_velocity(rope[5], [0.0, 1.0, 0.0]).unwrap()),
        ("a pin's position", 1, |world, rope| world.set_position(rope[0], [0.1, 0.0, 3.0]).unwrap()),
        ("a pin's velocity", 1, |world, rope| world.set_velocity(rope[0], [0.1, 0.0, 0.0]).unwrap()),
        ("a pin that is driven", 1, |world, rope| world.drive(rope[0], [0.0, 0.0, 3.0], [0.1, 0.0, 0.0]).unwrap()),
        ("a pin let go", 1, |world, rope| world.set_hold(rope[0], Hold::Free).unwrap()),
        ("a spring between them", 0, |world, rope| {
            world.add_spring(Spring::new([rope[1], rope[5] + 2], 1.0, 0.1)).unwrap();
        }),
        ("gravity", 0, |world, _| world.set_gravity([0.0, 0.0, -9.0]).unwrap()),
        ("a plane", 0, |world, _| {
            world.add_plane(Plane::through([0.0, 0.0, 2.9], [0.0, 0.0, 1.0], 0.5).unwrap()).unwrap();
        }),
    ];
    for (name, still, change) in changes {
        let (mut world, rope) = asleep();
        let before = bits(&world, &rope);
        change(&mut world, &rope);
        assert_eq!(world.view().plan().islands_asleep, still, "{name}");
        step(&mut world, StepperName::SemiImplicitEuler, CollisionForm::Project, 5);
        assert_eq!(before == bits(&world, &rope), still == 2, "{name}");
    }
}

#[test]
fn a_moving_pin_keeps_awake_what_hangs_on_it() {
    let mut world = empty::<f64>();
    let rope = hang(&mut world, [0.0, 0.0, 3.0], 5, [0.0; 3]);
    world.set_sleep(Some(soon())).unwrap();
    // Slower than what would count as rest, and with all of the rope: only the pin tells.
    rope.iter().for_each(|particle| world.set_velocity(*particle, [0.0, 1e-3, 0.0]).unwrap());
    step(&mut world, StepperName::SemiImplicitEuler, CollisionForm::Project, 500);
    assert_eq!(world.view().plan().islands_asleep, 0);
    world.set_velocity(rope[0], [0.0; 3]).unwrap();
    step(&mut world, StepperName::SemiImplicitEuler, CollisionForm::Project, 60);
    assert_eq!(world.view().plan().islands_asleep, 1);
    // A pin that is told every step to stay where it is disturbs nobody.
    let place = world.position(rope[0]).unwrap();
    world.drive(rope[0], place, [0.0; 3]).unwrap();
    assert_eq!(world.view().plan().islands_asleep, 1);
}

/// Steps until something sleeps, at most so many times; says whether it does.
fn falls_asleep(world: &mut HeapWorld<f64>, steps: u32) -> bool {
    let mut stepper = VelocityVerlet::<f64, Heap>::new();
    (0..steps).any(|_| {
        world.step(&mut stepper, &mut Project, TIME_STEP).unwrap();
        world.view().plan().islands_asleep > 0
    })
}

#[test]
fn a_pendulum_does_not_sleep_where_it_turns() {
    // Periods of 2 s. The slower ones are below the threshold for longer at a time, 0.63 s of a second at 0.012 m/s, and
    // the slowest for ever.
    let sleep = Sleep::below(1e-2);
    for (speed, sleeps) in [(1.0, false), (0.1, false), (0.02, false), (0.012, false), (0.008, true)] {
        let mut world = empty::<f64>();
        let pin = world.add_particle(particle([0.0; 3], [0.0; 3]).pinned()).unwrap();
        let drawn_out = MASS * 9.81 / 1e3;
        let bob = world.add_particle(particle([0.0, 0.0, -1.0 - drawn_out], [speed, 0.0, 0.0])).unwrap();
        world.add_spring(Spring::new([pin, bob], 1e3, 1.0)).unwrap();
        world.set_sleep(Some(sleep)).unwrap();
        assert_eq!(falls_asleep(&mut world, 20_000), sleeps, "{speed} m/s");
    }
}

#[test]
fn an_oscillation_in_time_with_the_looks_does_not_sleep() {
    // Every look finds it where it turns round, without any speed.
    let sleep = Sleep::below(1e-2).after(0.08);
    for (amplitude, sleeps) in [(1e-3, false), (1e-6, true)] {
        let frequency = std::f64::consts::TAU / 0.01;
        let mut world = HeapWorld::<f64>::new();
        let pin = world.add_particle(particle([0.0; 3], [0.0; 3]).pinned()).unwrap();
        let bob = world.add_particle(particle([1.0 + amplitude, 0.0, 0.0], [0.0; 3])).unwrap();
        world.add_spring(Spring::new([pin, bob], MASS * frequency * frequency, 1.0)).unwrap();
        world.set_sleep(Some(sleep)).unwrap();
        assert_eq!(falls_asleep(&mut world, 5_000), sleeps, "{amplitude} m");
    }
}

#[test]
fn the_ledger_tells_what_sleep_has_taken() {
    let mut world = empty::<f64>();
    let rope = hang(&mut world, [0.0, 0.0, 3.0], 5, [0.0, 0.0, 0.015]);
    world.set_sleep(Some(soon())).unwrap();
    let mut stepper = VelocityVerlet::<f64, Heap>::new();
    let mut ledger = Ledger::open(&world.view());
    // A tenth of what the other tests step with: a step's own error is then far below the energy that is left.
    let dt = 0.1 * TIME_STEP;
    let (balance, before) = loop {
        let before = ledger.balance(&world.view());
        world.view().step_observed(&mut stepper, &mut Project, dt, &mut ledger).unwrap();
        let after = ledger.balance(&world.view());
        if after.lost_to_sleep > 0.0 {
            break (after, before);
        }
        assert!(world.time() < 20.0, "it never sleeps");
    };
    // Were it not told, all of it would be the integrator's.
    assert!((balance.remainder() - before.remainder()).abs() <= 1e-3 * balance.lost_to_sleep);
    assert_eq!(balance.kinetic, 0.0);
    // It had no more than at the threshold, and about what it had a step before: h is 0.03 at most.
    let most = 0.5 * MASS * (rope.len() - 1) as f64 * 2e-2_f64.powi(2);
    assert!(balance.lost_to_sleep <= most && (balance.lost_to_sleep - before.kinetic).abs() <= 0.1 * before.kinetic);
    for _ in 0..100 {
        world.view().step_observed(&mut stepper, &mut Project, dt, &mut ledger).unwrap();
    }
    assert_eq!(ledger.balance(&world.view()), balance);
}

#[test]
fn an_island_on_a_plane_sleeps_on_it() {
    let mut world = empty::<f64>();
    let [a, b] = [0.0, 0.2].map(|x| world.add_particle(particle([x, 0.0, 0.05], [0.0; 3])).unwrap());
    world.add_spring(Spring::new([a, b], STIFFNESS, 0.2).with_damping(0.1)).unwrap();
    world.add_plane(Plane::through([0.0; 3], [0.0, 0.0, 1.0], 0.3).unwrap()).unwrap();
    world.set_sleep(Some(soon())).unwrap();
    step(&mut world, StepperName::SemiImplicitEuler, CollisionForm::TimeOfImpact, 1000);
    assert_eq!(world.view().plan().islands_asleep, 1);
    let before = bits(&world, &[a, b]);
    step(&mut world, StepperName::SemiImplicitEuler, CollisionForm::TimeOfImpact, 1000);
    assert!(before == bits(&world, &[a, b]));
}

#[test]
fn a_threshold_that_is_none_is_refused() {
    let (mut world, _) = asleep();
    for speed in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(world.set_sleep(Some(Sleep::below(speed))).is_err());
        assert!(world.set_sleep(Some(Sleep::below(1.0).after(speed))).is_err());
    }
    // Nothing has changed by it.
    assert_eq!(world.view().plan().islands_asleep, 2);
    world.set_sleep(None).unwrap();
    assert_eq!(world.view().plan().islands_asleep, 0);
    step(&mut world, StepperName::SemiImplicitEuler, CollisionForm::Project, 100);
    assert_eq!(world.view().plan().islands_asleep, 0);
}
