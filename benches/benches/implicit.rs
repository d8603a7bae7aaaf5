//! One step of implicit Euler, with room for a factor and without: compare within a group, not between runs.
#![allow(missing_docs, clippy::expect_used)]

use std::path::Path;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use hooke::{ImplicitEuler, Project, Real};
use hooke_runner::model::{Model, ModelParticle, ModelSpring};
use hooke_runner::scene::Scene;
use hooke_runner::simulate::{FILL, Heap, world};

/// s; a frame.
const TIME_STEP: f64 = 1.0 / 60.0;
/// Steps before the first that is timed: what falls has come to pull by then.
const WARM_UP: u32 = 10;

/// N/m
const STIFF: f64 = 1e5;

fn load(name: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    Scene::load(&path).expect("a sound scene").model().expect("a scene that fits")
}

/// The rope of 1,000, shorter or longer.
fn rope(particles: u32) -> Model {
    let Model { particles: some, springs, .. } = load("rope-1000");
    let (first, second, spring) = (&some[0], &some[1], &springs[0]);
    let particle = |number: u32| match number {
        0 => *first,
        _ => ModelParticle { position: second.position.map(|component| component * f64::from(number)), ..*second },
    };
    let spring = |number: u32| ModelSpring { between: [number - 1, number], ..*spring };
    Model {
        particles: (0..particles).map(particle).collect(),
        springs: (1..particles).map(spring).collect(),
        ..Model::default()
    }
}

fn stiff(mut model: Model) -> Model {
    model.springs.iter_mut().for_each(|spring| spring.stiffness = STIFF);
    model
}

fn steps<R: Real, const FILL: usize>(group: &mut BenchmarkGroup<'_, WallTime>, model: &Model) {
    let mut world = world::<R>(model, [0.0, 0.0, -9.81]).expect("a model in range");
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
    let cloths = ["cloth-16", "cloth-32", "cloth-64"]
        .into_iter()
        .flat_map(|name| [(name.to_owned(), load(name)), (format!("stiff {name}"), stiff(load(name)))]);
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
