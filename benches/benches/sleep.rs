//! A thousand ropes, of which ten swing: with the others asleep, and without. Compare the two.
#![allow(missing_docs, clippy::expect_used)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use hooke::{Particle, Project, Sleep, Spring};
use hooke_runner::scene::StepperName;
use hooke_runner::simulate::{AnyStepper, HeapWorld};

/// s
const TIME_STEP: f32 = 1e-3;
const ROPES: u16 = 1000;
/// Particles of each.
const LENGTH: u16 = 100;
const MASS: f32 = 0.01;
const STIFFNESS: f32 = 1000.0;
const GRAVITY: f32 = 9.81;

/// They hang at rest, each spring drawn out by the weight below it, but for every hundredth.
fn ropes() -> HeapWorld<f32> {
    let mut world = HeapWorld::new();
    world.set_gravity([0.0, 0.0, -GRAVITY]).expect("finite");
    for rope in 0..ROPES {
        let speed = if rope % 100 == 37 { 1.0 } else { 0.0 };
        let mut place = [0.0, 0.2 * f32::from(rope), 20.0];
        let mut last = world.add_particle(Particle::at(place).with_mass(MASS).pinned()).expect("room");
        for below in (1..LENGTH).rev() {
            place[2] -= 0.1 + f32::from(below) * MASS * GRAVITY / STIFFNESS;
            let particle = Particle::at(place).with_mass(MASS).with_velocity([speed, 0.0, 0.0]);
            let next = world.add_particle(particle).expect("room");
            world.add_spring(Spring::new([last, next], STIFFNESS, 0.1).with_damping(0.1)).expect("room");
            last = next;
        }
    }
    world
}

fn sleep(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("1000 ropes, 10 swinging");
    group.throughput(Throughput::Elements(u64::from(ROPES) * u64::from(LENGTH - 1)));
    for name in [StepperName::SemiImplicitEuler, StepperName::VelocityVerlet] {
        for (label, sleep) in [("all awake", None), ("990 asleep", Some(Sleep::below(0.05).after(0.04)))] {
            let mut world = ropes();
            world.set_sleep(sleep).expect("sound");
            let mut stepper = AnyStepper::named(name, 1e-6);
            for _ in 0..100 {
                world.step(stepper.any(), &mut Project, TIME_STEP).expect("stable");
            }
            assert_eq!(world.view().plan().islands_asleep, if sleep.is_some() { 990 } else { 0 });
            group.bench_function(format!("{name} {label}"), |bencher| {
                bencher.iter(|| world.step(stepper.any(), &mut Project, TIME_STEP));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, sleep);
criterion_main!(benches);
