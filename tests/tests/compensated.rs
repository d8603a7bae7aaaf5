//! `f32` with its rounding kept: it converges like `f64`, wherever it is.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use hooke::{Compensated, Fixed, Particle, Real, World};
use hooke_runner::model::{Hold, Model, ModelParticle, ModelPlane, ModelSpring};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::moment::Moment;
use hooke_tests::runs::Run;
use hooke_tests::{measure, scenes};

/// How long an oscillator swings, s: 100 rad.
const DURATION: f64 = 100.0;

/// Steps that add up to `duration` (s), to the bit.
fn steps<R: Real>(run: &mut Run<R>, count: usize, duration: f64) {
    let time = |step: usize| duration * step as f64 / count as f64;
    for step in 1..=count {
        let dt = R::from_f64(time(1));
        run.world.view().step_to(run.stepper.any(), &mut run.response, dt, time(step), &mut ()).unwrap();
    }
}

/// Of x = 1 + cos(t)/4, `away` from the origin along every axis: the error at the end, m.
fn error<R: Real>(stepper: StepperName, count: usize, away: f64) -> f64 {
    let particle =
        |x: f64, hold| ModelParticle { position: [away + x, away, -away], velocity: [0.0; 3], mass: 1.0, hold };
    let model = Model {
        particles: vec![particle(0.0, Hold::Pinned), particle(1.25, Hold::Free)],
        springs: vec![ModelSpring { between: [0, 1], stiffness: 1.0, damping: 0.0, rest_length: 1.0 }],
        ..Model::default()
    };
    let mut run = Run::<R>::new(&model, [0.0; 3], stepper, CollisionForm::Reflect);
    steps(&mut run, count, DURATION);
    (run.moment().position[1][0] - away - 1.0 - 0.25 * DURATION.cos()).abs()
}

/// A million steps: Verlet's own error is 5e-9 m there, that of plain `f32` ten thousand times as much.
#[test]
fn an_oscillator_over_a_million_steps() {
    let error = |away| error::<Compensated>(StepperName::VelocityVerlet, 1_000_000, away);
    let (near, far) = (error(0.0), error(1e4));
    assert!(near < 1e-7, "{near:e}");
    assert!(far < 2.0 * near, "{far:e}, not {near:e}");
    let plain = self::error::<f32>(StepperName::VelocityVerlet, 1_000_000, 0.0);
    assert!(plain > 1e-5, "{plain:e}");
}

/// At 10 km from the origin `f32` has a millimetre between neighbours: nothing is left of a swing of a quarter of a metre.
#[test]
fn far_from_the_origin_nothing_is_lost() {
    for stepper in
        [StepperName::SemiImplicitEuler, StepperName::VelocityVerlet, StepperName::Rk4, StepperName::BlanesMoanS6]
    {
        let [double, kept, plain] =
            [error::<f64>, error::<Compensated>, error::<f32>].map(|of| of(stepper, 10_000, 1e4));
        assert!(kept < 1.05 * double + 1e-7, "{stepper}: {kept:e}, not {double:e}");
        assert!(plain > 1e-3, "{stepper}: {plain:e}");
    }
}

/// Coefficients are rounded to `f32`, and those of DOP853 reach 43: what that makes of each acceleration adds up over
/// 100 rad. Plain `f32` is a hundred times worse.
#[test]
fn high_orders_reach_the_rounding_of_their_coefficients() {
    let steppers = [
        (StepperName::Rk4, 100_000, 1e-7),
        (StepperName::BlanesMoanS6, 100_000, 1e-7),
        (StepperName::DormandPrinceRkn8, 100_000, 5e-7),
        (StepperName::Dop853, 100_000, 5e-6),
    ];
    for (stepper, count, most) in steppers {
        let [kept, plain] = [error::<Compensated>, error::<f32>].map(|of| of(stepper, count, 0.0));
        assert!(kept < most, "{stepper}: {kept:e}");
        assert!(plain > 100.0 * kept, "{stepper}: {plain:e}, {kept:e}");
    }
}

/// A cloth let go, in short steps: plain `f32` is off by what it rounds, the other by its parameters' rounding alone.
#[test]
fn a_cloth_is_that_of_double_precision() {
    fn end<R: Real>() -> Moment {
        let (model, settings) = scenes::load("cloth-32");
        let stepper = StepperName::VelocityVerlet;
        let mut run = Run::<R>::new(&model, settings.gravity, stepper, CollisionForm::Reflect);
        steps(&mut run, 8192, 0.5);
        run.moment()
    }
    let double = end::<f64>();
    let [kept, plain] = [end::<Compensated>(), end::<f32>()].map(|moment| measure::position_error(&moment, &double));
    assert!(kept < 1e-6, "{kept:e}");
    assert!(plain > 10.0 * kept, "{plain:e}, {kept:e}");
}

/// 0.1 has no end in binary: `f32` has 24 digits of it, and its residual 24 more.
#[test]
fn coordinates_are_told_as_they_were_given() {
    let mut world = World::<Compensated, 1, 0, 0>::new();
    let given = [0.1, 1e4 + 0.1, -0.3e-3];
    let particle = world.add_particle(Particle::at(given).with_velocity(given)).unwrap();
    let near = |told: glam::DVec3| {
        let told = told.to_array();
        told.iter().zip(given).all(|(told, given)| (told - given).abs() <= given.abs() * 2.0_f64.powi(-48))
    };
    assert!(near(world.position(particle).unwrap()) && near(world.velocity(particle).unwrap()));
    world.set_position(particle, [0.0; 3]).unwrap();
    assert!(!near(world.position(particle).unwrap()));
    world.set_position(particle, given).unwrap();
    assert!(near(world.position(particle).unwrap()));
    assert!(near(world.view().position(particle).unwrap()));
    assert_eq!(world.view().states().count(), 1);
}

/// A step is a rounding of `f32` off: without what one owes the next, a thousand seconds would be 3e-6 s short.
#[test]
fn steps_add_up_to_the_time() {
    let mut world = World::<Compensated, 1, 0, 0>::new();
    let particle = world.add_particle(Particle::at([0.0; 3]).with_velocity([1.0, 0.0, 0.0])).unwrap();
    let mut stepper = hooke::VelocityVerlet::<Compensated, Fixed<1, 0, 0>>::new();
    for step in 1..=100_000 {
        let (dt, end) = (Compensated::from_f64(1e-2), 1e-2 * f64::from(step));
        world.view().step_to(&mut stepper, &mut hooke::Reflect, dt, end, &mut ()).unwrap();
    }
    let x = world.position(particle).unwrap().x;
    // Residuals of a kilometre have 2⁻⁴⁸ of it; 100,000 of those add up like their root.
    assert!((x - 1000.0).abs() < 1e-8, "{x}");
}

/// A throw, with a hit located inside the step or without: what flies along a stepper's path keeps its rounding too.
#[test]
fn what_flies_freely_keeps_its_rounding() {
    fn error<R: Real>(form: CollisionForm) -> f64 {
        let start = ModelParticle { position: [0.0; 3], velocity: [0.1, 0.0, 3.0], mass: 1.0, hold: Hold::Free };
        let floor = ModelPlane { point: [0.0, 0.0, -500.0], normal: [0.0, 0.0, 1.0], restitution: 0.5 };
        let model = Model { particles: vec![start], planes: vec![floor], ..Model::default() };
        let mut run = Run::<R>::new(&model, [0.0, 0.0, -9.81], StepperName::VelocityVerlet, form);
        steps(&mut run, 100_000, 10.0);
        let [x, _, z] = run.moment().position[0];
        (x - 1.0).abs() + (z - (30.0 - 0.5 * 9.81 * 100.0)).abs()
    }
    for form in [CollisionForm::Reflect, CollisionForm::TimeOfImpact] {
        // Gravity itself is rounded: 6e-8 of 490 m at most.
        let kept = error::<Compensated>(form);
        assert!(kept < 3e-5, "{form}: {kept:e}");
        assert!(error::<f32>(form) > 100.0 * kept, "{form}");
    }
}

/// What has come to rest on a plane is told as lying there, without what it had lost in rounding on its way.
#[test]
fn a_bounce_leaves_no_residual() {
    for form in [CollisionForm::Reflect, CollisionForm::Project, CollisionForm::TimeOfImpact] {
        let particle = |x: f64, z: f64| ModelParticle {
            position: [x, 0.0, z],
            velocity: [0.0, 0.0, -140.000_003],
            mass: 1.0,
            hold: Hold::Free,
        };
        let floor = ModelPlane { point: [0.0; 3], normal: [0.0, 0.0, 1.0], restitution: 0.0 };
        let spring = ModelSpring { between: [1, 2], stiffness: 1.0, damping: 0.0, rest_length: 1.0 };
        let particles = vec![particle(0.0, 3.000_000_03), particle(1.0, 3.000_000_03), particle(2.0, 3.000_000_03)];
        let model = Model { particles, springs: vec![spring], planes: vec![floor], ..Model::default() };
        let mut run = Run::<Compensated>::new(&model, [0.0; 3], StepperName::VelocityVerlet, form);
        steps(&mut run, 100, 0.1);
        for velocity in run.moment().velocity {
            assert_eq!(velocity[2], 0.0, "{form}");
        }
    }
}
