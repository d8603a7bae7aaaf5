//! One step, beside the textbook loop on the same scene in the same group: compare within a group, not between runs.
#![allow(missing_docs, clippy::expect_used)]

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec3, Vec3, Vec3A};
use hooke::{Project, Real};
use hooke_benches::scenes::{GRAVITY, STEP};
use hooke_benches::textbook::{Response, Textbook};
use hooke_benches::vector::{Scalar, Vector};
use hooke_runner::model::Model;
use hooke_runner::scene::StepperName;
use hooke_runner::simulate::{AnyStepper, world};

/// s; stable on all of these scenes.
const TIME_STEP: f64 = 1e-4;

fn textbook<V: Vector>(group: &mut BenchmarkGroup<'_, WallTime>, label: &str, model: &Model)
where
    V::Real: Scalar,
{
    let mut textbook = Textbook::<V>::new(model, GRAVITY, Response::Project).expect("no keyframes");
    let dt = V::Real::from_f64(TIME_STEP);
    group.bench_function(format!("textbook semi-implicit-euler {label}"), |bencher| {
        bencher.iter(|| textbook.step_semi_implicit_euler(dt));
    });
}

fn ours<R: Real>(group: &mut BenchmarkGroup<'_, WallTime>, precision: &str, model: &Model) {
    for name in [StepperName::ExplicitEuler, StepperName::SemiImplicitEuler, StepperName::VelocityVerlet] {
        let mut world = world::<R>(model, GRAVITY).expect("a scene in range");
        let mut stepper = AnyStepper::named(name, 1e-6);
        let dt = R::from_f64(TIME_STEP);
        group.bench_function(format!("{name} {precision}"), |bencher| {
            bencher.iter(|| world.step(stepper.any(), &mut Project, dt));
        });
    }
}

fn step(criterion: &mut Criterion) {
    for (name, make) in STEP {
        let model = make();
        let mut group = criterion.benchmark_group(format!("step {name}"));
        group.sample_size(10).throughput(Throughput::Elements(model.springs.len().max(model.particles.len()) as u64));
        textbook::<Vec3>(&mut group, "Vec3", &model);
        textbook::<Vec3A>(&mut group, "Vec3A", &model);
        textbook::<DVec3>(&mut group, "DVec3", &model);
        ours::<f32>(&mut group, "f32", &model);
        ours::<f64>(&mut group, "f64", &model);
        group.finish();
    }
}

criterion_group!(benches, step);
criterion_main!(benches);
