//! Runs to an accuracy keep to it, say how well, and cost little more than the cheapest run that would have.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, missing_docs)]

use hooke_runner::scene::{MaxError, Precision};
use hooke_tests::accuracies::{Kept, Known};
use hooke_tests::drawn::drawn;
use hooke_tests::scene_runs::shipped;

const ERRORS: [f64; 3] = [1e-2, 1e-4, 1e-6];

fn asked(error: f64) -> MaxError {
    MaxError { precision: Some(Precision::F64), ..MaxError::of(error) }
}

fn told(known: &Known, error: f64, kept: &Kept, best: Option<f64>) -> String {
    let Kept { error: truly, attained, .. } = kept;
    let choice = &attained.choice;
    let held = attained.held_until.map_or_else(String::new, |until| format!(", held until {until:.3} s"));
    let cost = best.map_or_else(String::new, |best| format!(", {:.2} times the cheapest", attained.cost / best));
    format!(
        "{}: {error:.0e} asked, {:.1e} known, {truly:.1e} true, {:.1e} estimated{held}; {} {} beside {}, {:?}, {} returns, {} restarts{cost}",
        known.name,
        known.reference.floor(),
        attained.estimate,
        choice.stepper,
        choice.precision,
        choice.companion,
        choice.ratio,
        attained.returns,
        attained.restarts,
    )
}

/// What the criterion is: in at least 95 % of runs within what was asked for, never three times that unsaid.
fn judge(results: &[(f64, Kept)]) {
    let within = results.iter().filter(|(error, kept)| kept.error <= *error).count();
    assert!(within as f64 >= 0.95 * results.len() as f64, "{within} of {} within", results.len());
    for (error, kept) in results {
        assert!(kept.error <= 3.0 * error, "{error:e}: {:e} and unsaid", kept.error);
    }
}

/// Drawn scenes, each error.
#[test]
fn drawn_scenes_keep_to_what_was_asked_for() {
    let mut results = Vec::new();
    for number in 0..10 {
        let (name, model, settings) = drawn(number);
        let known = Known::new(name, model, &settings);
        for error in ERRORS {
            let kept = known.run(&asked(error));
            println!("{}", told(&known, error, &kept, None));
            results.push((error, kept));
        }
    }
    judge(&results);
}

/// The whole table: every shipped scene and ten that are drawn, each error in f64, with the cost of the cheapest fixed
/// choice beside it. It takes many minutes:
/// `cargo test --release -p hooke-tests --test max_error -- --ignored --nocapture`. With SCENE set, only scenes that
/// have this in their name.
#[test]
#[ignore = "it takes many minutes"]
fn costs_beside_the_cheapest_fixed_choice() {
    let only = std::env::var("SCENE").unwrap_or_default();
    let drawn = (0..10).map(drawn).filter(|(name, ..)| name.contains(&only));
    let drawn = drawn.map(|(name, model, settings)| Known::new(name, model, &settings));
    let shipped = shipped().into_iter().filter(|path| path.to_string_lossy().contains(&only));
    let mut results = Vec::new();
    for known in drawn.chain(shipped.map(|path| Known::of(&path))) {
        let best = known.cheapest(&ERRORS, &[Precision::F64]);
        println!("{}: no error below {:.1e} m is known", known.name, known.reference.floor());
        for (error, best) in ERRORS.into_iter().zip(best) {
            let kept = known.run(&asked(error));
            println!("  {} {best:?}", told(&known, error, &kept, best.map(|(.., cost)| cost)));
            results.push((error, kept));
        }
    }
    judge(&results);
}
