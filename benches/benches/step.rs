//! One step, beside the textbook loop on the same scene in the same group: compare within a group, not between runs.
#![allow(missing_docs, clippy::expect_used)]

use std::path::Path;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec3, Vec3, Vec3A};
use hooke::{Project, Real};
use hooke_benches::textbook::{Response, Textbook};
use hooke_benches::vector::{Scalar, Vector};
use hooke_runner::scene::{Scene, StepperName};
use hooke_runner::simulate::{AnyStepper, world};

/// s; stable on all of these scenes.
const TIME_STEP: f64 = 1e-3;

fn scene(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    Scene::load(&path).expect("a sound scene")
}

fn textbook<V: Vector>(group: &mut BenchmarkGroup<'_, WallTime>, label: &str, scene: &Scene)
where
    V::Real: Scalar,
{
    let model = scene.model().expect("a scene that fits");
    let gravity = scene.settings().gravity;
    let mut textbook = Textbook::<V>::new(&model, gravity, Response::Project).expect("no keyframes");
    let dt = V::Real::from_f64(TIME_STEP);
    group.bench_function(format!("textbook semi-implicit-euler {label}"), |bencher| {
        bencher.iter(|| textbook.step_semi_implicit_euler(dt));
    });
}

fn ours<R: Real>(group: &mut BenchmarkGroup<'_, WallTime>, precision: &str, scene: &Scene) {
    let model = scene.model().expect("a scene that fits");
    for name in [StepperName::SemiImplicitEuler, StepperName::VelocityVerlet] {
        let mut world = world::<R>(&model, scene.settings().gravity).expect("a scene in range");
        let mut stepper = AnyStepper::named(name, 1e-6);
        let dt = R::from_f64(TIME_STEP);
        group.bench_function(format!("{name} {precision}"), |bencher| {
            bencher.iter(|| world.step(&mut stepper, &mut Project, dt));
        });
    }
}

fn step(criterion: &mut Criterion) {
    for name in ["cloth-32", "cloth-64", "rope-1000"] {
        let scene = scene(name);
        let springs = scene.model().expect("a scene that fits").springs.len() as u64;
        let mut group = criterion.benchmark_group(format!("step {name}"));
        group.throughput(Throughput::Elements(springs));
        textbook::<Vec3>(&mut group, "Vec3", &scene);
        textbook::<Vec3A>(&mut group, "Vec3A", &scene);
        textbook::<DVec3>(&mut group, "DVec3", &scene);
        ours::<f32>(&mut group, "f32", &scene);
        ours::<f64>(&mut group, "f64", &scene);
        group.finish();
    }
}

criterion_group!(benches, step);
criterion_main!(benches);
