//! Scenes that leave their stepper and their time step open keep within a thousandth of their size.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, missing_docs)]

use hooke_runner::scene::{Settings, StepperName, TimeStep};
use hooke_tests::accuracies::Known;
use hooke_tests::drawn::drawn;

/// A scene that magnifies a small change more than so many times by its end is no scene that pilots over a prefix can tell
/// the end of; no run goes beside this one to notice.
const FORESEEN: f64 = 1e3;
/// There, errors are this many times larger at most.
const UNFORESEEN: f64 = 10.0;

fn knowns() -> Vec<Known> {
    let known = |(name, model, settings)| Known::new(name, model, &settings);
    (0..10).map(drawn).map(known).collect()
}

#[test]
fn errors_are_within_a_thousandth_of_the_size() {
    let parts = knowns().into_iter().map(|known| {
        let (aimed, error) = known.aimed();
        assert!((aimed.error - 1e-3 * known.model.size()).abs() < 1e-12 * known.model.size());
        let Settings { stepper, time_step, .. } = aimed.settings;
        let (part, growth) = (error / aimed.error, known.reference.growth);
        println!("{}: {stepper}, {time_step}, {part:.3} of what is aimed at, growth {growth:.1e}", known.name);
        assert!(part <= if growth < FORESEEN { 1.0 } else { UNFORESEEN }, "{}: {part}", known.name);
        part
    });
    let parts: Vec<f64> = parts.collect();
    // And not as they would be if nobody looked for the longest steps that do: some come near.
    assert!(parts.iter().any(|part| *part > 0.03), "{parts:?}");
}

/// What is done where nothing can be found, a quarter of the stability bound, does not keep to it.
#[test]
fn a_part_of_the_stability_bound_does_not_suffice() {
    let missed = knowns().into_iter().filter(|known| {
        let error = 1e-3 * known.model.size();
        let settings = Settings { stepper: StepperName::Auto, time_step: TimeStep::Auto, ..known.settings.clone() };
        known.ran(&settings, error) > error
    });
    assert!(missed.count() > 0);
}
