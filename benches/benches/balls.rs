//! 100,000 balls bouncing on a plane for 10 s: exact flight at 60 frames a second, beside the textbook loop at steps of
//! 1e-3 s. Compare within the group, not between runs.
//!
//! The textbook loop is timed over 100 of its 10,000 steps, from the start: multiply by 100. What it does in a step does
//! not depend on where the balls are, but for the few that it reflects.
#![allow(missing_docs, clippy::expect_used)]

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
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
const STEPS: u32 = 100;
/// 10 s at 60 a second.
const FRAMES: u32 = 600;

fn textbook<V: Vector>(group: &mut BenchmarkGroup<'_, WallTime>, label: &str, model: &Model)
where
    V::Real: Scalar,
{
    let mut textbook = Textbook::<V>::new(model, GRAVITY, Response::Project).expect("no keyframes");
    let dt = V::Real::from_f64(TIME_STEP);
    group.bench_function(format!("textbook semi-implicit-euler {label}, 0.1 s"), |bencher| {
        bencher.iter(|| (0..STEPS).for_each(|_| textbook.step_semi_implicit_euler(dt)));
    });
}

fn ours<R: Real>(group: &mut BenchmarkGroup<'_, WallTime>, precision: &str, model: &Model) {
    group.bench_function(format!("auto {precision}, 10 s"), |bencher| {
        let start = || world::<R>(model, GRAVITY).expect("a scene in range");
        bencher.iter_with_setup(start, |mut world| {
            let (mut stepper, mut response) = (Auto::<R, Heap>::new(1e-6), TimeOfImpact::<R, Heap>::new());
            for frame in 1..=FRAMES {
                let (length, end) = (R::from_f64(1.0 / 60.0), f64::from(frame) / 60.0);
                let stepped = world.view().step_to(&mut stepper, &mut response, length, end, &mut ());
                stepped.expect("a step that can be taken");
            }
            world
        });
    });
}

fn balls(criterion: &mut Criterion) {
    let model = scenes::balls(100_000);
    let mut group = criterion.benchmark_group("balls");
    group.sample_size(10);
    textbook::<Vec3>(&mut group, "Vec3", &model);
    textbook::<Vec3A>(&mut group, "Vec3A", &model);
    ours::<f32>(&mut group, "f32", &model);
    textbook::<DVec3>(&mut group, "DVec3", &model);
    ours::<f64>(&mut group, "f64", &model);
    group.finish();
}

criterion_group!(benches, balls);
criterion_main!(benches);
