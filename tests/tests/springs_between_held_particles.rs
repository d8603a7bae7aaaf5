//! Springs between two held particles are left out, nobody can tell, and they are back once one of the two is let go.
#![allow(clippy::expect_used, missing_docs)]

use hooke::{Hold, Ledger, Real};
use hooke_benches::scenes::cloth;
use hooke_runner::model::{Hold as Held, Model};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::runs::Run;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
/// Particles along a side.
const SIDE: usize = 12;
/// Rows of it that are pinned: bend springs reach two rows, so that of the first no spring pulls at what moves.
const PINNED: usize = 3;

/// A cloth of which whole rows are pinned, as it has been stretched a little.
fn pinned_cloth() -> Model {
    let mut model = cloth(SIDE as u32, 0.05);
    for particle in &mut model.particles {
        particle.hold = Held::Free;
        particle.position = particle.position.map(|x| 1.01 * x);
    }
    model.particles.iter_mut().take(PINNED * SIDE).for_each(|particle| particle.hold = Held::Pinned);
    model
}

fn is_idle(model: &Model, between: [u32; 2]) -> bool {
    between.iter().all(|end| model.particles[*end as usize].hold != Held::Free)
}

fn run<R: Real>(model: &Model, stepper: StepperName) -> Run<R> {
    Run::new(model, GRAVITY, stepper, CollisionForm::Project)
}

/// Of all particles after some steps.
fn states<R: Real>(run: &mut Run<R>) -> Vec<[R::Vec3; 2]> {
    run.steps(100, 1e-3);
    run.world.view().states().map(|(position, velocity)| [position, velocity]).collect()
}

fn compare<R: Real>(stepper: StepperName) {
    let model = pinned_cloth();
    let mut without = model.clone();
    without.springs.retain(|spring| !is_idle(&model, spring.between));
    let idle = model.springs.len() - without.springs.len();
    assert!(idle > 100, "{idle} springs to leave out");

    let mut all = run::<R>(&model, stepper);
    assert_eq!(all.world.view().plan().idle, idle as u32);
    assert_eq!(all.world.view().plan().live(), without.springs.len() as u32);
    let mut alone = run::<R>(&without, stepper);
    assert_eq!(alone.world.view().plan().idle, 0);
    assert!(states(&mut all) == states(&mut alone), "{stepper}");

    // Let go of, they pull: the cloth that misses them moves otherwise from then on.
    let mut free = model.clone();
    free.particles.iter_mut().for_each(|particle| particle.hold = Held::Free);
    let (mut all, mut never, mut alone) =
        (run::<R>(&model, stepper), run::<R>(&free, stepper), run::<R>(&without, stepper));
    for particle in 0..(PINNED * SIDE) as u32 {
        for run in [&mut all, &mut alone] {
            run.world.view();
            run.world.set_hold(particle, Hold::Free).expect("a particle");
        }
    }
    assert_eq!(all.world.view().plan().idle, 0);
    let expected = states(&mut never);
    assert!(states(&mut all) == expected, "{stepper}, let go");
    assert!(states(&mut alone) != expected, "{stepper}: what is missing does not show");

    // And pinned again, they are left out again.
    for particle in 0..(PINNED * SIDE) as u32 {
        all.world.view();
        all.world.set_hold(particle, Hold::Pinned).expect("a particle");
    }
    assert_eq!(all.world.view().plan().idle, idle as u32);
}

#[test]
fn they_move_nothing() {
    for stepper in [StepperName::ExplicitEuler, StepperName::SemiImplicitEuler, StepperName::VelocityVerlet] {
        compare::<f32>(stepper);
        compare::<f64>(stepper);
    }
}

/// Their energy is none of the steps', but the scene's.
#[test]
fn they_count_in_the_ledger() {
    let model = pinned_cloth();
    let mut all = run::<f64>(&model, StepperName::VelocityVerlet);
    let elastic = Ledger::open(&all.world.view()).balance(&all.world.view()).elastic;
    let expected: f64 = model
        .springs
        .iter()
        .map(|spring| {
            let [from, to] = spring.between.map(|end| model.particles[end as usize].position);
            let length = (0..3).map(|axis| (to[axis] - from[axis]).powi(2)).sum::<f64>().sqrt();
            0.5 * spring.stiffness * (length - spring.rest_length).powi(2)
        })
        .sum();
    // Sums of some hundred terms.
    assert!((elastic - expected).abs() <= 1e-13 * expected, "{elastic} J, not {expected}");
}
