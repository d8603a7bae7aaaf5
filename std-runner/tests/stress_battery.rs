//! The battery of `hooke stress`: what it says of runs that are known to be right, wrong, or impossible.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::scene::{CollisionForm, Precision, StepperName};
use hooke_runner::stress::battery::{
    Case, Effort, Group, Known, Moment, Observed, Run, Runner, Tried, Verdict, bodies, judge, observe, try_case,
};

const EFFORT: Effort = Effort { longest: Duration::from_secs(20), steps: 0.02 };

fn never() -> AtomicBool {
    AtomicBool::new(false)
}

fn tried(name: &str, only: &[StepperName]) -> Tried {
    let case = bodies(EFFORT.steps).into_iter().find(|case| case.name == name).expect("a case of that name");
    try_case(case, only, EFFORT, &never())
}

fn of(tried: &Tried, stepper: StepperName, precision: Precision) -> &Run {
    tried.runs.iter().find(|run| run.runner == Runner { stepper, precision }).expect("it ran")
}

/// 1 kg on 1 N/m, for so many steps of so long, of which nothing is known but that energy stays.
fn oscillator(time_step: f64, steps: u64) -> Case {
    let particle = |x: f64, hold| ModelParticle { position: [x, 0.0, 0.0], velocity: [0.0; 3], mass: 1.0, hold };
    Case {
        group: Group::AsItIs,
        name: "an oscillator".to_owned(),
        model: Model {
            particles: vec![particle(0.0, Hold::Pinned), particle(1.1, Hold::Free)],
            springs: vec![ModelSpring { between: [0, 1], stiffness: 1.0, damping: 0.0, rest_length: 1.0 }],
            ..Model::default()
        },
        gravity: [0.0; 3],
        duration: steps as f64 * time_step,
        steps,
        collision: CollisionForm::TimeOfImpact,
        most_hits: None,
        known: Known::Energy,
    }
}

const VERLET: Runner = Runner { stepper: StepperName::VelocityVerlet, precision: Precision::F64 };

/// No body beside the scenes is beyond the method that is exact on all of them, but for those that no number can hold.
#[test]
fn nothing_goes_wrong_in_silence_and_wedges_are_exact() {
    for case in bodies(EFFORT.steps) {
        let group = case.group;
        let steppers = [StepperName::SemiImplicitEuler, StepperName::Dop853, StepperName::Auto];
        for run in try_case(case, &steppers, EFFORT, &never()).runs {
            assert_ne!(run.judged.verdict, Verdict::Defect, "{run:?}");
            if group == Group::Wedges {
                assert_eq!(run.judged.verdict, Verdict::Exact, "{run:?}");
            }
        }
    }
}

#[test]
fn verdicts_are_those_that_theory_has() {
    let runs = tried("an oscillator: damped by 0 of critical, steps of 1e-2 s", &[]);
    assert_eq!(of(&runs, StepperName::Dop853, Precision::F64).judged.verdict, Verdict::Exact);
    assert_eq!(of(&runs, StepperName::VelocityVerlet, Precision::F64).judged.verdict, Verdict::Accurate);
    // It gains h²/2 of its energy a step: over 200 steps of h = 0.061, 45 %.
    assert_eq!(of(&runs, StepperName::ExplicitEuler, Precision::F64).judged.verdict, Verdict::Wrong);
    // h = 6.1 is past every limit.
    let runs = tried("an oscillator: damped by 0 of critical, steps of 1e0 s", &[]);
    assert_eq!(of(&runs, StepperName::VelocityVerlet, Precision::F64).judged.verdict, Verdict::Exploded);
    assert_eq!(of(&runs, StepperName::ImplicitEuler, Precision::F64).judged.verdict, Verdict::Wrong);
    // Neighbours in f32 are 0.06 m apart there, and the swing is of 0.1 m.
    let runs = tried("an oscillator: 1e6 m from the origin", &[StepperName::VelocityVerlet]);
    assert_eq!(of(&runs, StepperName::VelocityVerlet, Precision::F32).judged.verdict, Verdict::Wrong);
    assert_eq!(of(&runs, StepperName::VelocityVerlet, Precision::F64).judged.verdict, Verdict::Accurate);
    // 2⁻¹⁴⁰ kg has no inverse in f32.
    let runs = tried("an oscillator: all masses times 2^-140", &[StepperName::VelocityVerlet]);
    assert_eq!(of(&runs, StepperName::VelocityVerlet, Precision::F32).judged.verdict, Verdict::Refused);
}

/// What leaves the finite numbers is refused at that step, with its time.
#[test]
fn an_explosion_is_told_with_its_time() {
    let case = Arc::new(oscillator(10.0, 400));
    let observed = observe(&case, VERLET, EFFORT.longest, &never());
    let judged = judge(&case, Precision::F64, &observed);
    assert_eq!(judged.verdict, Verdict::Exploded);
    assert!(judged.reason.contains("particle 1 in the step after") && judged.reason.contains("state was kept"));
}

/// A run without end is ended by the clock, and says how far it was.
#[test]
fn what_takes_too_long_is_ended() {
    let case = Arc::new(oscillator(1e-3, 4_000_000_000));
    let begun = std::time::Instant::now();
    let observed = observe(&case, VERLET, Duration::from_millis(200), &never());
    assert_eq!(judge(&case, Precision::F64, &observed).verdict, Verdict::TookTooLong);
    assert!(begun.elapsed() < Duration::from_secs(10));
    let interrupted = AtomicBool::new(true);
    assert!(matches!(observe(&case, VERLET, EFFORT.longest, &interrupted), Observed::Interrupted));
}

/// The judge itself: a run that is off by a little, by much, and beyond all bounds; and one hit too many.
#[test]
fn the_judge_tells_small_errors_from_large_ones() {
    let quarter = |x: f64| vec![[0.0; 3], [x, 0.0, 0.0]];
    let expected = vec![quarter(1.0), quarter(0.9), quarter(1.0), quarter(1.1)];
    let known = Known::Motion { positions: expected.clone(), uncertainty: 0.0 };
    let case = Case { known, most_hits: Some(3), ..oscillator(0.1, 8) };
    let observed = |by: f64, hits: u64| {
        let moment = |position: &Vec<[f64; 3]>| Moment {
            position: vec![position[0], [position[1][0] + by, 0.0, 0.0]],
            velocity: vec![[0.0; 3]; 2],
        };
        let moments = std::iter::once(Moment::default()).chain(expected.iter().map(moment)).collect();
        let end = hooke_runner::stress::battery::End::Finished;
        Observed::Ran { moments, end, hits, unconverged: 0, degenerate: 0 }
    };
    // It moves by 0.2 m.
    for (by, hits, expected) in [
        (1e-15, 0, Verdict::Exact),
        (1e-3, 3, Verdict::Accurate),
        (1e-2, 0, Verdict::Wrong),
        (1e3, 0, Verdict::Exploded),
        (f64::NAN, 0, Verdict::Defect),
        (0.0, 4, Verdict::Wrong),
    ] {
        assert_eq!(judge(&case, Precision::F64, &observed(by, hits)).verdict, expected, "{by}, {hits}");
    }
}
