//! What a spring costs as scenes grow, from a thousand springs to ten million: cloths, semi-implicit Euler.
#![allow(missing_docs, clippy::expect_used)]

use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use hooke::{Project, SemiImplicitEuler};
use hooke_benches::scenes::{GRAVITY, cloth};
use hooke_runner::simulate::world;

fn scale(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("scale");
    group.sample_size(10).measurement_time(Duration::from_secs(2));
    for side in [14, 42, 130, 410, 1300] {
        let model = cloth(side, 0.05);
        let springs = model.springs.len() as u64;
        let mut world = world::<f32>(&model, GRAVITY).expect("a scene in range");
        group.throughput(Throughput::Elements(springs));
        group.bench_function(BenchmarkId::new("springs", springs), |bencher| {
            bencher.iter(|| world.step(&mut SemiImplicitEuler, &mut Project, 1e-4));
        });
    }
    group.finish();
}

criterion_group!(benches, scale);
criterion_main!(benches);
