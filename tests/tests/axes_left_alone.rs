//! Along an axis that nothing moves along, states are not written again and again: nobody can tell, and once something
//! does move along it, it is written.
#![allow(clippy::expect_used, missing_docs)]

use hooke::{Real, Sleep};
use hooke_benches::scenes::balls;
use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::runs::Run;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
const FRAME: f64 = 1.0 / 60.0;
/// More than a block of them, and no whole number of blocks.
const BALLS: u32 = 333;
/// Until all have bounced: the highest falls for 1.4 s.
const FRAMES: u32 = 120;

fn run<R: Real>(model: &Model) -> Run<R> {
    Run::new(model, GRAVITY, StepperName::Auto, CollisionForm::TimeOfImpact)
}

fn states<R: Real>(run: &mut Run<R>) -> Vec<([f64; 3], [f64; 3])> {
    let moment = run.moment();
    moment.position.into_iter().zip(moment.velocity).collect()
}

/// Balls that fall straight stay above where they were, in every frame, whoever looks ahead in between.
fn stay<R: Real>() {
    let model = balls(BALLS);
    let mut run = run::<R>(&model);
    let start = states(&mut run);
    for frame in 0..FRAMES {
        if frame % 3 == 1 {
            let time = f64::from(frame) * FRAME + 0.3 * FRAME;
            let ahead = run.world.view().free_at(run.stepper.any(), time).map(Iterator::count);
            assert_eq!(ahead, Some(BALLS as usize));
        }
        run.steps(1, FRAME);
        for ((position, velocity), (began, _)) in states(&mut run).iter().zip(&start) {
            assert_eq!(position[..2], began[..2], "frame {frame}");
            assert_eq!(velocity[..2], [0.0; 2], "frame {frame}");
        }
    }
    // They did bounce.
    assert!(states(&mut run).iter().zip(&start).all(|((_, velocity), _)| velocity[2].abs() < 14.0));
    assert!(states(&mut run).iter().any(|(_, velocity)| velocity[2] > 1.0));
}

/// One that is pushed moves as far as its velocity takes it, and nobody else moves along that axis.
fn pushed<R: Real>(accuracy: f64) {
    let mut run = run::<R>(&balls(BALLS));
    run.steps(7, FRAME);
    let before = states(&mut run);
    let push = [0.75, 0.0, 0.0].map(R::Coordinate::from_f64);
    run.world.set_velocity(17, push).expect("a ball");
    run.steps(8, FRAME);
    for (number, ((position, _), (began, _))) in states(&mut run).iter().zip(&before).enumerate() {
        let expected = if number == 17 { began[0] + 0.75 * 8.0 * FRAME } else { began[0] };
        assert!((position[0] - expected).abs() <= accuracy, "ball {number}: {} m, not {expected}", position[0]);
        assert_eq!(position[1], began[1], "ball {number}");
    }
}

/// Islands that fall asleep change who is in which slot: a mass at rest on its spring beside the balls.
fn beside_a_sleeper<R: Real>() {
    let mut model = balls(BALLS);
    let place = |z: f64, hold| ModelParticle { position: [-3.0, -2.0, z], velocity: [0.0; 3], mass: 0.25, hold };
    // The spring's extension is m g/k.
    let end = 4.0 - 1.0 - 0.25 * 9.81 / 100.0;
    model.particles.insert(0, place(end, Hold::Free));
    model.particles.insert(0, place(4.0, Hold::Pinned));
    model.springs.push(ModelSpring { between: [0, 1], stiffness: 100.0, damping: 1.0, rest_length: 1.0 });
    let mut run = run::<R>(&model);
    let sleep = Sleep::below(R::from_f64(0.05)).after(R::from_f64(0.2));
    run.world.set_sleep(Some(sleep)).expect("sound");
    let start = states(&mut run);
    for frame in 0..FRAMES {
        run.steps(1, FRAME);
        for (number, ((position, velocity), (began, _))) in states(&mut run).iter().zip(&start).enumerate().skip(2) {
            assert_eq!(position[..2], began[..2], "frame {frame}, ball {number}");
            assert_eq!(velocity[..2], [0.0; 2], "frame {frame}, ball {number}");
        }
    }
    assert_eq!(run.world.view().plan().islands_asleep, 1);
}

#[test]
fn an_island_that_falls_asleep_beside_them_changes_nothing() {
    beside_a_sleeper::<f32>();
    beside_a_sleeper::<f64>();
}

#[test]
fn what_falls_straight_stays_above_where_it_was() {
    stay::<f32>();
    stay::<f64>();
}

#[test]
fn what_is_pushed_moves() {
    // A few roundings at 100 m.
    pushed::<f32>(2e-5);
    pushed::<f64>(1e-13);
}

/// A slanting plane throws them along an axis that neither they nor gravity have.
#[test]
fn a_slanting_plane_throws_them_aside() {
    let mut model = balls(BALLS);
    model.planes[0].normal = [0.6, 0.0, 0.8];
    model.planes[0].point = [0.0, 0.0, -100.0];
    let mut run = run::<f64>(&model);
    run.steps(20 * FRAMES as usize, FRAME);
    let states = states(&mut run);
    assert!(states.iter().all(|(_, velocity)| velocity[1] == 0.0));
    assert!(states.iter().filter(|(_, velocity)| velocity[0] > 1.0).count() > BALLS as usize / 2);
}
