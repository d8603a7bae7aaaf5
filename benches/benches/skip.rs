//! Each thing that a scene may not need: a step with it, and without. Compare within a group, not between runs; the
//! binary `skips` takes turns between the two, and counts their instructions.
#![allow(missing_docs)]

use criterion::{Criterion, criterion_group, criterion_main};
use hooke_benches::skips::PAIRS;

fn skips(criterion: &mut Criterion) {
    for pair in &PAIRS {
        let mut group = criterion.benchmark_group(format!("skip {}", pair.name));
        for (label, make) in [("with", pair.with), ("without", pair.without)] {
            let mut steps = make();
            group.bench_function(label, |bencher| bencher.iter(|| steps(1)));
        }
        group.finish();
    }
}

criterion_group!(benches, skips);
criterion_main!(benches);
