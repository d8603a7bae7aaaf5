//! `hooke bench` against a scene with a closed form, and against what each order must show.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use std::io::Write;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use hooke_runner::bench::{Asked, Bench, Compared, Course, Kept, MOMENTS, Point, Swept, bench, winners};
use hooke_runner::model::Model;
use hooke_runner::scene::{Precision, Scene, Settings, StepperName};

/// x = 1 + 0.1 cos 2t: it has come back by the end, after π, and is at the middle at two of the checkpoints.
const OSCILLATOR: &str = "duration = 3.141592653589793\n\
    [[particle]]\nposition = [0.0, 0.0, 0.0]\npinned = true\n\
    [[particle]]\nposition = [1.1, 0.0, 0.0]\nmass = 1.0\n\
    [[spring]]\nbetween = [0, 1]\nstiffness = 4.0\nrest_length = 1.0\n";

/// Enough for every order to show.
const SHORT: Duration = Duration::from_millis(1);

fn load(toml: &str) -> (Model, Settings) {
    let mut file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    file.write_all(toml.as_bytes()).unwrap();
    let scene = Scene::load(file.path()).expect("a sound scene");
    (scene.model().expect("a scene that fits"), scene.settings().clone())
}

fn measured(toml: &str) -> Bench {
    ended(toml, &AtomicBool::new(false)).expect("nobody interrupts")
}

fn ended(toml: &str, interrupted: &AtomicBool) -> Option<Bench> {
    let (model, settings) = load(toml);
    let (model, settings, kept) = (&model, &settings, &Kept::default());
    let compared = Compared::Throughout;
    let course = Course { model, settings, compared, longest: SHORT, kept, is_traced: false, interrupted };
    bench(&course, |_| ()).expect("a scene that runs")
}

fn of(bench: &Bench, stepper: StepperName, precision: Precision) -> &Swept {
    let is = |swept: &&Swept| swept.contender.stepper == stepper && swept.contender.precision == precision;
    bench.swept.iter().find(is).expect("every stepper runs")
}

/// By how much two successive errors fall, as an order.
fn order([coarse, fine]: [&Point; 2]) -> f64 {
    (coarse.error.unwrap() / fine.error.unwrap()).log2()
}

#[test]
fn the_reference_is_the_closed_form_and_orders_are_those_of_the_steppers() {
    let bench = measured(OSCILLATOR);
    assert_eq!(bench.reference.states.len() as u64, MOMENTS);
    for (moment, state) in bench.reference.states.iter().enumerate() {
        let phase = 2.0 * std::f64::consts::PI * (moment + 1) as f64 / MOMENTS as f64;
        // Rounding, of some thousand steps at most.
        assert!((state.positions[1][0] - (1.0 + 0.1 * phase.cos())).abs() < 1e-12, "{state:?}");
        assert!((state.velocities[1][0] + 0.2 * phase.sin()).abs() < 1e-12, "{state:?}");
    }
    assert!(bench.reference.settled < 1e-11, "{}", bench.reference.settled);
    let (stepper, distance) = bench.reference.confirmed.unwrap();
    assert!(stepper == StepperName::DormandPrinceRkn8 && distance < 1e-11, "{distance}");
    // It is stable: a change of the start stays what it is, but for what the direction makes of it.
    assert!((0.5..10.0).contains(&bench.reference.growth), "{}", bench.reference.growth);
    for (stepper, expected) in
        [(StepperName::SemiImplicitEuler, 1.0), (StepperName::VelocityVerlet, 2.0), (StepperName::Rk4, 4.0)]
    {
        let points = &of(&bench, stepper, Precision::F64).points;
        let found = order([&points[3], &points[4]]);
        assert!((found - expected).abs() < 0.15, "{stepper}: {found}");
    }
}

#[test]
fn high_orders_win_at_small_errors_and_single_precision_never_does() {
    let bench = measured(OSCILLATOR);
    let winners = winners(&bench);
    assert!(winners.len() >= 9, "{winners:?}");
    for winner in winners.iter().filter(|winner| winner.error < 1e-7) {
        let (contender, point) = winner.run.expect("somebody gets there");
        assert_eq!(contender.precision, Precision::F64, "{winner:?}");
        assert!([StepperName::Dop853, StepperName::DormandPrinceRkn8, StepperName::Rk4].contains(&contender.stepper));
        assert!(point.error.unwrap() <= winner.error);
    }
    // A tenth of a metre is all that there is to be wrong by.
    let floors: Vec<f64> = bench
        .swept
        .iter()
        .filter(|swept| swept.contender.precision == Precision::F32)
        .map(|swept| swept.points.iter().filter_map(|point| point.error).fold(f64::INFINITY, f64::min))
        .collect();
    assert!(floors.iter().all(|floor| *floor > 1e-8), "{floors:?}");
}

/// Damping is nothing that the Nyström method knows: it does not run, and everybody else does.
#[test]
fn who_cannot_step_a_scene_does_not_run() {
    let bench = measured(&OSCILLATOR.replace("rest_length", "damping = 0.1\nrest_length"));
    let ran = |stepper| bench.swept.iter().any(|swept| swept.contender.stepper == stepper);
    assert!(StepperName::ALL.iter().all(|stepper| ran(*stepper) == stepper.knows_damping()));
}

/// Ten times as small a tolerance makes errors about ten times as small with some more steps: 10^(1/8) = 1.33 times as many
/// with DOP853, 10^(1/7) = 1.39 with the Nyström method. Only steps that are given double.
#[test]
fn steppers_that_choose_their_steps_are_swept_over_the_tolerance() {
    let bench = measured(OSCILLATOR);
    for stepper in StepperName::ALL.iter().copied() {
        let is = |swept: &&Swept| swept.contender.stepper == stepper && swept.contender.precision == Precision::F64;
        let adaptive = bench.swept.iter().filter(is).find(|swept| swept.contender.is_adaptive);
        assert_eq!(adaptive.is_some(), stepper.estimates_errors(), "{stepper}");
        let given = bench.swept.iter().filter(is).find(|swept| !swept.contender.is_adaptive).unwrap();
        assert!(given.points.iter().all(|point| point.asked == Asked::Steps(point.steps)), "{given:?}");
        let Some(Swept { points, contender }) = adaptive else { continue };
        assert_eq!(contender.to_string(), format!("{stepper} adaptive f64"));
        let tolerances: Vec<Option<f64>> = points.iter().map(|point| point.asked.tolerance()).collect();
        assert_eq!(tolerances[..4], [1e-2, 1e-3, 1e-4, 1e-5].map(Some));
        // Sixteen checkpoints end parts: the loosest tolerances do not come to bear.
        for pair in points.windows(2).filter(|pair| pair[0].steps > 32) {
            let growth = pair[1].steps as f64 / pair[0].steps as f64;
            assert!((1.1..1.7).contains(&growth), "{stepper}: {pair:?}");
        }
        for point in points {
            let (error, tolerance) = (point.error.unwrap(), point.asked.tolerance().unwrap());
            // Of what is half a metre large, in tens of steps.
            assert!(error < 10.0 * tolerance + 1e-12, "{stepper}: {point:?}");
            assert!((point.time_step * point.steps as f64 - bench.duration).abs() < 1e-12);
        }
    }
}

#[test]
fn interrupted_before_there_is_a_reference_there_is_nothing() {
    assert!(ended(OSCILLATOR, &AtomicBool::new(true)).is_none());
}
