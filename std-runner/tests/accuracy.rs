//! The parts of a run to an accuracy, each against what it has to be.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke_runner::accuracy::{Choice, Estimate, Knot, Pace, Ratio, quintic};
use hooke_runner::scene::{CollisionForm, Precision, StepperName};

/// A point on a circle of radius 1 with unit speed, and how it moves.
fn on_circle(time: f64) -> Knot {
    let (sin, cos) = time.sin_cos();
    Knot { position: [cos, sin, 0.0], velocity: [-sin, cos, 0.0], acceleration: [-cos, -sin, 0.0] }
}

fn off(one: [f64; 3], other: [f64; 3]) -> f64 {
    one.iter().zip(other).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The largest error of the curve over an arc, in position and in velocity.
fn curve_errors(length: f64) -> (f64, f64) {
    let (start, end) = (on_circle(0.3), on_circle(0.3 + length));
    (1..16).map(|part| f64::from(part) / 16.0).fold((0.0, 0.0), |(place, speed): (f64, f64), s| {
        let truth = on_circle(0.3 + s * length);
        let (position, velocity) = quintic(&start, &end, length, s);
        (place.max(off(position, truth.position)), speed.max(off(velocity, truth.velocity)))
    })
}

#[test]
fn curves_are_of_sixth_order_and_their_error_is_as_told() {
    for length in [0.8, 0.4, 0.2] {
        let ((place, speed), (half_place, half_speed)) = (curve_errors(length), curve_errors(0.5 * length));
        // Of sixth order in position and of fifth in velocity; a cubic would show 4 and 3.
        assert!(((place / half_place).log2() - 6.0).abs() < 0.1, "{length}: {place:e} {half_place:e}");
        assert!(((speed / half_speed).log2() - 5.0).abs() < 0.15, "{length}: {speed:e} {half_speed:e}");
        // (h/2)⁶/720 at most; the sixth derivative of the circle is 1.
        let most = (0.5 * length).powi(6) / 720.0;
        assert!(place < 1.001 * most && place > 0.9 * most, "{length}: {place:e} of {most:e}");
    }
}

#[test]
fn curves_begin_and_end_where_they_should() {
    let (start, end) = (on_circle(1.0), on_circle(2.5));
    for (s, knot) in [(0.0, start), (1.0, end)] {
        let (position, velocity) = quintic(&start, &end, 1.5, s);
        assert!(off(position, knot.position) < 1e-15 && off(velocity, knot.velocity) < 1e-15, "{s}");
    }
}

fn choice(ratio: Ratio, order: u32, precision: Precision) -> Choice {
    Choice {
        stepper: StepperName::Dop853,
        precision,
        companion: precision,
        ratio,
        collision: CollisionForm::TimeOfImpact,
        time_step: 0.01,
        longest: 0.02,
        order,
        cost: 0.0,
    }
}

/// Two runs whose errors are those of their order: how many times too large the estimate of the finer one's is.
fn exaggeration(ratio: Ratio, order: u32, precision: Precision, has_planes: bool) -> f64 {
    let estimate = Estimate::of(&choice(ratio, order, precision), 1.0, has_planes);
    let error = 1e-9;
    let difference = error * (ratio.value().powi(order as i32) - 1.0);
    estimate.error(difference) / error
}

#[test]
fn estimates_are_exact_up_to_sixth_order_and_cautious_beyond() {
    for ratio in [Ratio::FiveFourths, Ratio::Two] {
        for order in 1..=6 {
            let exaggerated = exaggeration(ratio, order, Precision::F64, false);
            assert!((exaggerated - 1.0).abs() < 1e-12, "{ratio:?} {order}: {exaggerated}");
        }
        assert!(exaggeration(ratio, 8, Precision::F64, false) > 1.5);
        // What rounds, and what hits planes, may be a third off at most: never more than three errors are taken for one.
        for (precision, has_planes) in [(Precision::F32, false), (Precision::F64, true)] {
            let estimate = Estimate::of(&choice(ratio, 8, precision), 1.0, has_planes);
            assert!(estimate.error(3e-6) >= 0.999e-6);
        }
    }
}

#[test]
fn far_runs_and_runs_that_are_no_numbers_are_not_read_as_near() {
    let estimate = Estimate::of(&choice(Ratio::Two, 8, Precision::F64), 2.0, false);
    assert!((estimate.error(0.05) - 0.05 / 63.0).abs() < 1e-12);
    assert!((estimate.error(0.07) - 0.07).abs() < 1e-12, "no small change of a scene of 2 m");
    assert!(estimate.error(f64::NAN).is_infinite());
    assert!(estimate.error(f64::INFINITY).is_infinite());
    for error in [1e-6, 1e-3, 0.5] {
        let difference = estimate.difference(error);
        assert!(estimate.error(0.999 * difference) <= error, "{error}");
    }
}

/// A run whose error grows by c(t) dtᵖ a second, paced for an error of 1 mm: its error and its steps.
fn paced(order: u32, first: f64, c: impl Fn(f64) -> f64) -> (f64, f64) {
    let (duration, longest) = (10.0, 1.0);
    let mut pace = Pace::new(first, longest, order, 1e-3, duration);
    let (mut time, mut error, mut steps) = (0.0, 0.0, 0.0);
    while time < duration {
        let dt = pace.time_step().min(duration - time);
        error += c(time) * dt.powi(order as i32) * dt;
        time += dt;
        steps += 1.0;
        pace.hear(error, time);
    }
    (error, steps)
}

#[test]
fn paced_runs_use_up_what_they_may_and_no_more() {
    for order in [2, 4, 8] {
        // The step that would do, were it taken from the start.
        let even = |c: f64| 10.0 / (1e-3 / (10.0 * c)).powf(1.0 / f64::from(order));
        for c in [1e-2, 1.0, 1e2] {
            for first in [1e-3, 1e-2] {
                let (error, steps) = paced(order, first, |_| c);
                assert!(error <= 1e-3, "{order} {c} {first}: {error:e}");
                // Of low order it aims at a fifth of the error, which takes the root of 5 as many steps; and it begins shorter.
                let allowed = if order == 2 { 3.0 } else { 2.0 } * even(c).max(10.0) + 100.0;
                assert!(steps <= allowed, "{order} {c} {first}: {steps} steps of {allowed}");
            }
        }
        // What gets harder on the way is noticed. (A hundred times harder of a sudden would be too much for order 2: then a
        // run goes back.)
        let (error, _) = paced(order, 1e-2, |time| if time < 3.0 { 0.1 } else { 1.0 });
        assert!(error <= 1e-3, "{order}: {error:e}");
    }
}

#[test]
fn who_comes_back_takes_shorter_steps_and_never_the_failed_ones_again() {
    let mut pace = Pace::new(0.1, 0.2, 4, 1e-3, 10.0);
    pace.come_back(1.0, 0.1);
    assert!(pace.time_step() <= 0.03, "{}", pace.time_step());
    for _ in 0..100 {
        pace.hear(0.0, 1.0);
    }
    assert!(pace.time_step() <= 0.1);
    pace.limit(0.05);
    assert!(pace.time_step() <= 0.05);
}
