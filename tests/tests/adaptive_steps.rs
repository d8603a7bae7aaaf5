//! Steps as long as an error estimate allows: errors follow the tolerance, at the estimate's order, bounces and all.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use hooke::{
    AdaptiveDop853, AdaptiveDormandPrinceRkn8, Project, Reflect, Response, StepError, StepReport, Stepper, TimeOfImpact,
};
use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::simulate::{Heap, HeapWorld, world};
use hooke_tests::moment::Moment;
use hooke_tests::problems::bouncing_oscillator::BouncingOscillator;
use hooke_tests::problems::{Problem, bouncing, smooth};
use hooke_tests::{digest, measure};

type Dop853 = AdaptiveDop853<f64, Heap>;
type Rkn8 = AdaptiveDormandPrinceRkn8<f64, Heap>;

fn moment(world: &mut HeapWorld<f64>) -> Moment {
    let view = world.view();
    view.states().fold(Moment::default(), |moment, (x, v)| moment.with(x.to_array(), v.to_array()))
}

/// The largest error at four times, m, and what all steps reported together.
fn run(problem: &Problem, stepper: &mut impl Stepper<f64>, response: &mut impl Response<f64>) -> (f64, StepReport) {
    let mut world = world::<f64>(&problem.model, problem.gravity).unwrap();
    let (mut total, mut error) = (StepReport::default(), 0.0_f64);
    for quarter in 1..=4 {
        let end = 0.25 * f64::from(quarter) * problem.duration;
        let dt = end - world.time();
        total.add(&world.view().step_to(stepper, response, dt, end, &mut ()).expect("a step that can be taken"));
        assert!((world.time() - end).abs() < 1e-15 * end, "{}", problem.name);
        error = error.max(measure::position_error(&moment(&mut world), &(problem.exact)(end)));
    }
    (error, total)
}

/// Smooth problems that springs pull in, for methods that know damping or do not.
fn swinging(with_damping: bool) -> impl Iterator<Item = Problem> {
    smooth().into_iter().filter(move |problem| {
        let springs = &problem.model.springs;
        !springs.is_empty() && (with_damping || springs.iter().all(|spring| spring.damping == 0.0))
    })
}

/// Errors of parts add up, or turn about: a hundred parts make a hundred errors at most, and an estimate is of the formula
/// of lower order, so it is far too careful.
#[test]
fn errors_stay_near_the_tolerance() {
    for tolerance in [1e-5, 1e-7, 1e-9] {
        for problem in swinging(true) {
            let (error, _) = run(&problem, &mut Dop853::new(tolerance), &mut Reflect);
            assert!(error < 100.0 * tolerance, "{}, {tolerance:e}: {error:e}", problem.name);
        }
        for problem in swinging(false) {
            let (error, _) = run(&problem, &mut Rkn8::new(tolerance), &mut Reflect);
            assert!(error < 100.0 * tolerance, "{}, {tolerance:e}: {error:e}", problem.name);
        }
    }
}

/// As the estimate falls with the eighth power of the length, or the seventh, so does the work grow with its root.
#[test]
fn work_grows_at_the_order_of_the_estimate() {
    fn order<S: Stepper<f64>>(adaptive: fn(f64) -> S) -> f64 {
        let [coarse, fine] = [1e-11, 1e-16].map(|tolerance| {
            let mut world = world::<f64>(&stiff(0.0), [0.0; 3]).unwrap();
            // 32 periods, in whose turning points lengths change a little.
            f64::from(world.step(&mut adaptive(tolerance), &mut Reflect, 20.0).unwrap().force_evaluations)
        });
        1e5_f64.ln() / (fine / coarse).ln()
    }
    let (dop853, rkn8) = (order(Dop853::new), order(Rkn8::new));
    assert!((dop853 - 8.0).abs() < 0.4, "{dop853}");
    assert!((rkn8 - 7.0).abs() < 0.4, "{rkn8}");
}

/// Time of impact cuts at each hit, and the part after it begins anew: errors are those of the smooth problems.
#[test]
fn bounces_keep_the_tolerance() {
    for problem in bouncing().into_iter().filter(|problem| !problem.model.springs.is_empty()) {
        // Whether it touches the plane there is up to the last digits.
        if problem.name.ends_with("equilibrium 0.08, restitution 0") {
            continue;
        }
        let mut response = TimeOfImpact::<f64, Heap>::new();
        let (error, report) = run(&problem, &mut Dop853::new(1e-9), &mut response);
        assert!(error < 1e-6, "{}: {error:e}", problem.name);
        assert!(report.hits > 0, "{}", problem.name);
    }
}

/// 1 kg on 100 N/m, let go from rest.
fn stiff(speed: f64) -> Model {
    let particle = |x: f64, speed: f64, hold| ModelParticle {
        position: [x, 0.0, 0.0],
        velocity: [speed, 0.0, 0.0],
        mass: 1.0,
        hold,
    };
    Model {
        particles: vec![particle(0.0, 0.0, Hold::Pinned), particle(1.5, speed, Hold::Free)],
        springs: vec![ModelSpring { between: [0, 1], stiffness: 100.0, damping: 0.0, rest_length: 1.0 }],
        ..Model::default()
    }
}

/// A second is 1.6 periods: far too long for one part, so the first ones are refused, and none once the length is known.
#[test]
fn parts_that_turn_out_too_long_are_taken_again() {
    let mut world = world::<f64>(&stiff(0.0), [0.0; 3]).unwrap();
    let mut stepper = Dop853::new(1e-9);
    assert_eq!(stepper.part(), None);
    let first = world.step(&mut stepper, &mut Project, 1.0).unwrap();
    assert!(first.rejected >= 2, "{first:?}");
    let part = stepper.part().unwrap();
    assert!((0.01..0.2).contains(&part), "{part}");
    let later = world.step(&mut stepper, &mut Project, 1.0).unwrap();
    assert!(later.rejected <= 1, "{later:?}");
    // A step shorter than a part is one part.
    let short = world.step(&mut stepper, &mut Project, 1e-3).unwrap();
    assert_eq!((short.rejected, short.force_evaluations), (0, 12), "{short:?}");
}

/// A spring that is pulled apart at 1e156 m/s has a length beyond all numbers after 13 ms, however short the parts.
#[test]
fn a_step_that_fails_in_a_later_part_leaves_the_state() {
    for response in [true, false] {
        let mut world = world::<f64>(&stiff(1e156), [0.0; 3]).unwrap();
        let mut stepper = Dop853::new(1e300);
        let before = digest::of(&world.view());
        let step = 0.1;
        let failed = if response {
            world.step(&mut stepper, &mut Reflect, step)
        } else {
            world.step(&mut stepper, &mut TimeOfImpact::<f64, Heap>::new(), step)
        };
        assert_eq!(failed, Err(StepError::NonFinite { particle: 1 }));
        assert_eq!((digest::of(&world.view()), world.time()), (before, 0.0));
    }
}

/// The same estimate on a wrong method would let errors through: a fixed step of the length that the loosest tolerance
/// chooses misses the tightest.
#[test]
fn a_fixed_step_misses_what_a_tolerance_meets() {
    let problem = swinging(true).find(|problem| problem.name == "oscillator, damping ratio 0, gravity 0").unwrap();
    let mut loose = Dop853::new(1e-3);
    run(&problem, &mut loose, &mut Reflect);
    let part = loose.part().unwrap();
    let (error, _) = run(&problem, &mut Dop853::new(1e-10), &mut Reflect);
    let mut world = world::<f64>(&problem.model, problem.gravity).unwrap();
    let mut fixed = hooke::Dop853::<f64, Heap>::new();
    let count = (problem.duration / part).ceil();
    (0..count as u32).for_each(|_| {
        world.step(&mut fixed, &mut Reflect, problem.duration / count).unwrap();
    });
    let missed = measure::position_error(&moment(&mut world), &(problem.exact)(problem.duration));
    assert!(error < 1e-8 && missed > 100.0 * error, "{error:e}, {missed:e}");
}

/// One step of many seconds is that of many short ones: more hits than any part may have, and bounces that come to rest only
/// when they do.
#[test]
fn a_long_step_is_many_short_ones() {
    for (equilibrium, restitution, duration) in [(0.08, 1.0, 60.0), (-0.1, 0.8, 2.3), (-0.1, 0.8, 2.6)] {
        let problem = BouncingOscillator::new(equilibrium, restitution).problem();
        let end = |count: u32| {
            let mut world = world::<f64>(&problem.model, problem.gravity).unwrap();
            let (mut stepper, mut response) = (Dop853::new(1e-10), TimeOfImpact::<f64, Heap>::new());
            for _ in 0..count {
                world.step(&mut stepper, &mut response, duration / f64::from(count)).unwrap();
            }
            moment(&mut world)
        };
        let error = measure::position_error(&end(1), &end(1000));
        // Hundreds of parts and bounces at most, each off by 1e-10 m.
        assert!(error < 1e-6, "{equilibrium}, {restitution}, {duration} s: {error:e}");
    }
}

/// Nothing is below no tolerance: it is refused, and so is one that is no number. One that no part meets ends all the same,
/// and the report tells.
#[test]
fn what_no_part_can_meet_ends() {
    let mut world = world::<f64>(&stiff(0.0), [0.0; 3]).unwrap();
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = world.step(&mut Dop853::new(tolerance), &mut Reflect, 1e-3);
        assert_eq!(refused, Err(StepError::Tolerance), "{tolerance}");
    }
    let report = world.step(&mut Dop853::new(1e-300), &mut Reflect, 1e-3).unwrap();
    assert!(!report.converged && report.residual > 1.0, "{report:?}");
    let mut single = hooke_runner::simulate::world::<f32>(&stiff(0.0), [0.0; 3]).unwrap();
    let mut stepper = AdaptiveDop853::<f32, Heap>::new(1e-30);
    assert!(!single.step(&mut stepper, &mut Reflect, 1e-2).unwrap().converged);
    assert!((single.time() - 1e-2).abs() < 1e-9);
}
