//! One step of implicit Euler, with room for a factor and without: compare within a group, not between runs.
#![allow(missing_docs, clippy::expect_used)]

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use hooke::{ImplicitEuler, Project, Real};
use hooke_benches::scenes::{GRAVITY, cloth, rope};
use hooke_runner::model::Model;
use hooke_runner::simulate::{FILL, Heap, world};

/// s; a frame.
const TIME_STEP: f64 = 1.0 / 60.0;
/// Steps before the first that is timed: what falls has come to pull by then.
const WARM_UP: u32 = 10;

/// N/m
const STIFF: f64 = 1e5;

fn stiff(mut model: Model) -> Model {
    model.springs.iter_mut().for_each(|spring| spring.stiffness = STIFF);
    model
}

fn steps<R: Real, const FILL: usize>(group: &mut BenchmarkGroup<'_, WallTime>, model: &Model) {
    let mut world = world::<R>(model, GRAVITY).expect("a model in range");
    let mut stepper = ImplicitEuler::<R, Heap, FILL>::new(1e-6);
    let dt = R::from_f64(TIME_STEP);
    let solver = stepper.linear_solver(&world.view(), dt).expect("room on the heap");
    let room = if FILL == 0 {
        "conjugate gradients"
    } else if solver.is_direct() {
        "factor"
    } else {
        "factor if needed"
    };
    for _ in 0..WARM_UP {
        world.step(&mut stepper, &mut Project, dt).expect("a step that can be taken");
    }
    group.bench_function(room, |bencher| {
        bencher.iter(|| world.step(&mut stepper, &mut Project, dt));
    });
}

fn implicit(criterion: &mut Criterion) {
    let ropes = [100, 1_000, 10_000, 100_000].map(|particles| (format!("rope {particles}"), rope(particles)));
    let cloths = [16, 32, 64].into_iter().flat_map(|side| {
        let soft = cloth(side, 0.05);
        [(format!("cloth-{side}"), soft.clone()), (format!("stiff cloth-{side}"), stiff(soft))]
    });
    for (name, model) in ropes.into_iter().chain(cloths) {
        let mut group = criterion.benchmark_group(format!("implicit {name}"));
        group.throughput(Throughput::Elements(model.springs.len() as u64)).sample_size(10);
        steps::<f64, FILL>(&mut group, &model);
        steps::<f64, 0>(&mut group, &model);
        group.finish();
    }
}

criterion_group!(benches, implicit);
criterion_main!(benches);
