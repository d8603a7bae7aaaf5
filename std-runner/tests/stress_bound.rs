//! The block bound never exceeds the limit that bisection finds, on 200 random scenes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::sync::atomic::AtomicBool;

use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::scene::StepperName;
use hooke_runner::stress::{Found, limits};

/// For trials of some hundred steps: growth of a few thousandths a step can be told.
const WORK: f64 = 1e5;

/// From 0 to 1, by a linear congruence (Knuth's MMIX).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Evenly in the logarithm.
    fn over(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.next())
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() * count as f64) as usize
    }
}

/// 2 to 30 particles, masses and stiffnesses over three decades, springs stretched, slack and compressed, half of all scenes
/// damped, a spring for each particle to an earlier one and some more.
fn scene(seed: u64) -> Model {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    random.next();
    let count = 2 + random.below(29);
    let mut model = Model::default();
    for number in 0..count {
        let position = [0; 3].map(|_| random.between(-1.0, 1.0));
        let hold = if number > 0 && random.below(8) == 0 { Hold::Pinned } else { Hold::Free };
        let mass = random.over(0.03, 30.0);
        model.particles.push(ModelParticle { position, velocity: [0.0; 3], mass, hold });
    }
    let is_damped = seed.is_multiple_of(2);
    for number in 1..count + random.below(2 * count) {
        let from = if number < count { number } else { 1 + random.below(count - 1) };
        let between = [from, random.below(from)];
        let [a, b] = between.map(|end| model.particles[end].position);
        let length = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let stiffness = random.over(1.0, 1000.0);
        let damping = if is_damped { stiffness * random.over(1e-4, 0.3) } else { 0.0 };
        let rest_length = length * random.between(0.5, 1.3);
        model.springs.push(ModelSpring { between: between.map(|end| end as u32), stiffness, damping, rest_length });
    }
    model
}

fn found(stepper: StepperName, model: &Model) -> (f64, f64) {
    let limits = limits(model, &[stepper], WORK, &AtomicBool::new(false), |_| ()).unwrap().expect("a free end");
    let limit = &limits.steppers[0];
    match limit.found {
        Found::Limit(dt) => (limit.bound, dt),
        other => panic!("{stepper} is stable up to something: {other:?}"),
    }
}

/// Explicit Euler's is no such bound: it is only where that may be stable at all.
#[test]
fn the_bound_never_exceeds_the_limit_on_200_scenes() {
    let mut slackest = 1.0_f64;
    for seed in 0..200 {
        let model = scene(seed);
        if model
            .springs
            .iter()
            .all(|spring| spring.between.iter().all(|end| model.particles[*end as usize].hold == Hold::Pinned))
        {
            continue;
        }
        for stepper in
            [StepperName::SemiImplicitEuler, StepperName::VelocityVerlet, StepperName::Rk4, StepperName::Dop853]
        {
            // Each of them on a part of the scenes, and the first two on all.
            if !seed.is_multiple_of(4) && [StepperName::Rk4, StepperName::Dop853].contains(&stepper) {
                continue;
            }
            let (bound, limit) = found(stepper, &model);
            // The bisection ends at steps that differ by 5e-4; what it finds is the lower one.
            assert!(bound <= limit * (1.0 + 5e-4), "{seed}, {stepper}: {bound} > {limit}");
            slackest = slackest.min(bound / limit);
        }
    }
    // It is no bound that is safe because it is far too small.
    assert!(slackest > 0.3, "{slackest}");
}

/// A bound that is a tenth too large would be found out.
#[test]
fn a_larger_bound_exceeds_it() {
    let exceeds = |seed: u64| {
        let (bound, limit) = found(StepperName::VelocityVerlet, &scene(seed));
        1.1 * bound > limit * (1.0 + 5e-4)
    };
    assert!((1..40).filter(|seed| exceeds(*seed)).count() > 10);
}
