//! Each thing that a scene may not need: a step with it, and without. Compare within a group, not between runs.
#![allow(missing_docs, clippy::expect_used)]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use hooke::{Project, SemiImplicitEuler};
use hooke_benches::scenes::{GRAVITY, cloth};
use hooke_runner::model::{Hold, Model, ModelPlane};
use hooke_runner::simulate::{HeapWorld, world};

const TIME_STEP: f32 = 1e-4;

fn plane_at(height: f64) -> ModelPlane {
    ModelPlane { point: [0.0, 0.0, height], normal: [0.0, 0.0, 1.0], restitution: 0.5 }
}

fn built(model: &Model, gravity: [f64; 3]) -> HeapWorld<f32> {
    world::<f32>(model, gravity).expect("a scene in range")
}

fn pair(criterion: &mut Criterion, name: &str, with: HeapWorld<f32>, without: HeapWorld<f32>) {
    let mut group = criterion.benchmark_group(format!("skip {name}"));
    for (label, mut world) in [("with", with), ("without", without)] {
        group.bench_function(label, |bencher| {
            bencher.iter(|| black_box(world.step(&mut SemiImplicitEuler, &mut Project, TIME_STEP)));
        });
    }
    group.finish();
}

fn skips(criterion: &mut Criterion) {
    let whole = cloth(64, 0.05);
    let changed = |change: &dyn Fn(&mut Model)| {
        let mut model = whole.clone();
        change(&mut model);
        built(&model, GRAVITY)
    };
    let plain = || built(&whole, GRAVITY);
    pair(criterion, "gravity", plain(), built(&whole, [0.0; 3]));
    pair(criterion, "damping", plain(), built(&cloth(64, 0.0), GRAVITY));
    pair(
        criterion,
        "damping of most springs",
        plain(),
        changed(&|model| model.springs.iter_mut().skip(4000).for_each(|spring| spring.damping = 0.0)),
    );
    pair(
        criterion,
        "springs that vary",
        changed(&|model| {
            for (number, spring) in model.springs.iter_mut().enumerate() {
                spring.stiffness *= 1.0 + 1e-3 * (number % 7) as f64;
            }
        }),
        plain(),
    );
    // Four planes: below the cloth where it hangs and so tested particle by particle, or where it cannot reach them.
    let planes = |height: f64| changed(&|model: &mut Model| model.planes = vec![plane_at(height); 4]);
    pair(criterion, "planes out of reach", planes(1.0 + 1e-6), planes(-100.0));
    pair(criterion, "planes", planes(-100.0), plain());
    pair(
        criterion,
        "pinned particles",
        changed(&|model| {
            for particle in model.particles.iter_mut().step_by(2) {
                particle.hold = Hold::Pinned;
            }
        }),
        plain(),
    );
}

criterion_group!(benches, skips);
criterion_main!(benches);
