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

/// How long 10,000 steps take, s.
fn textbook<V: Vector>(model: &Model) -> f64
where
    V::Real: Scalar,
{
    let mut textbook = Textbook::<V>::new(model, GRAVITY, Response::Project).expect("no keyframes");
    let dt = V::Real::from_f64(TIME_STEP);
    // The first steps find nothing in the caches.
    (0..10).for_each(|_| textbook.step_semi_implicit_euler(dt));
    let start = Instant::now();
    (0..STEPS).for_each(|_| textbook.step_semi_implicit_euler(dt));
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
    let model = scenes::balls(100_000);
    println!("100,000 balls, 10 s");
    let [scalar, aligned, auto] = shortest(&model, [textbook::<Vec3>, textbook::<Vec3A>, ours::<f32>]);
    println!("f32: textbook Vec3 {scalar:.2} s, Vec3A {aligned:.2} s; auto {auto:.3} s");
    println!("f32: auto is {:.1} times faster than the faster of the two", scalar.min(aligned) / auto);
    let [double, auto] = shortest(&model, [textbook::<DVec3>, ours::<f64>]);
    println!("f64: textbook DVec3 {double:.2} s; auto {auto:.3} s");
    println!("f64: auto is {:.1} times faster", double / auto);
}
