//! 100,000 balls bouncing on a plane for 10 s: exact flight at 60 frames a second, beside the textbook loop at steps of
//! 1e-3 s. Both run in turns, and what is printed is the shortest time of each and how many times faster exact flight is.
//!
//! The textbook loop is timed over 200 of its 10,000 steps, from the start, and multiplied by 50. What it does in a step
//! does not depend on where the balls are, but for the few that it reflects. Exact flight is timed over all its frames.
#![allow(missing_docs, clippy::expect_used)]

use std::hint::black_box;
use std::time::Instant;

use glam::{DVec3, Vec3, Vec3A};
use hooke::{Auto, Real, TimeOfImpact};
use hooke_benches::avx2;
use hooke_benches::scenes::{self, GRAVITY};
use hooke_benches::textbook::{Response, Textbook};
use hooke_benches::vector::{Scalar, Vector};
use hooke_runner::model::Model;
use hooke_runner::simulate::{Heap, world};

/// s
const TIME_STEP: f64 = 1e-3;
/// Of 10,000.
const STEPS: u32 = 200;
/// 10 s at 60 a second.
const FRAMES: u32 = 600;
/// Each runs so often, in turns: other programs slow down neighbours in time alike.
const ROUNDS: u32 = 10;

fn textbook<V: Vector>(model: &Model) -> f64
where
    V::Real: Scalar,
{
    stepping(model, Textbook::<V>::step_semi_implicit_euler)
}

/// Compiled for AVX2.
fn avx2_textbook<V: Vector>(model: &Model) -> f64
where
    V::Real: Scalar,
{
    stepping(model, avx2::step_semi_implicit_euler::<V>)
}

/// How long 10,000 steps take, s.
fn stepping<V: Vector>(model: &Model, step: impl Fn(&mut Textbook<V>, V::Real)) -> f64
where
    V::Real: Scalar,
{
    let mut textbook = Textbook::<V>::new(model, GRAVITY, Response::Project).expect("no keyframes");
    let dt = V::Real::from_f64(TIME_STEP);
    // The first steps find nothing in the caches.
    (0..10).for_each(|_| step(&mut textbook, dt));
    let start = Instant::now();
    (0..STEPS).for_each(|_| step(&mut textbook, dt));
    let elapsed = start.elapsed().as_secs_f64();
    black_box(textbook);
    elapsed * 10_000.0 / f64::from(STEPS)
}

/// How long all frames take, s.
fn ours<R: Real>(model: &Model) -> f64 {
    let mut world = world::<R>(model, GRAVITY).expect("a scene in range");
    let (mut stepper, mut response) = (Auto::<R, Heap>::new(1e-6), TimeOfImpact::<R, Heap>::new());
    let start = Instant::now();
    for frame in 1..=FRAMES {
        let (length, end) = (R::from_f64(1.0 / 60.0), f64::from(frame) / 60.0);
        let stepped = world.view().step_to(&mut stepper, &mut response, length, end, &mut ());
        stepped.expect("a step that can be taken");
    }
    let elapsed = start.elapsed().as_secs_f64();
    black_box(world);
    elapsed
}

/// Times several in turns, and returns the shortest time of each.
fn shortest<const COUNT: usize>(model: &Model, runs: [fn(&Model) -> f64; COUNT]) -> [f64; COUNT] {
    let mut shortest = [f64::INFINITY; COUNT];
    for _ in 0..ROUNDS {
        for (shortest, run) in shortest.iter_mut().zip(runs) {
            *shortest = shortest.min(run(model));
        }
    }
    shortest
}

fn main() {
    race("100,000 balls that fall straight, 10 s", &scenes::balls(100_000));
    race("100,000 balls that are thrown, 10 s", &scenes::thrown_balls(100_000));
}

fn race(name: &str, model: &Model) {
    println!("{name}");
    let single: [fn(&Model) -> f64; 5] =
        [textbook::<Vec3>, textbook::<Vec3A>, avx2_textbook::<Vec3>, avx2_textbook::<Vec3A>, ours::<f32>];
    tell("f32", ["Vec3", "Vec3A", "Vec3 AVX2", "Vec3A AVX2"], shortest(model, single));
    tell("f64", ["DVec3", "DVec3 AVX2"], shortest(model, [textbook::<DVec3>, avx2_textbook::<DVec3>, ours::<f64>]));
}

/// What the textbook loops took, and ours after them, s.
fn tell<const RIVALS: usize, const ALL: usize>(precision: &str, rivals: [&str; RIVALS], times: [f64; ALL]) {
    let auto = times[ALL - 1];
    let told = rivals.iter().zip(times).map(|(rival, time)| format!("{rival} {time:.2} s"));
    println!("{precision}: textbook {}; auto {auto:.3} s", told.collect::<Vec<_>>().join(", "));
    let fastest = times.iter().take(RIVALS).fold(f64::INFINITY, |least, time| least.min(*time));
    println!("{precision}: auto is {:.1} times faster than the fastest of them", fastest / auto);
}
