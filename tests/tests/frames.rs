//! Frames: when they are taken, what they hold between steps, and that they change nothing.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::path::{Path, PathBuf};

use hooke_runner::scene::{Settings, StepperName, TimeStep};
use hooke_runner::simulate::Schedule;
use hooke_tests::measure::{position_error, velocity_error};
use hooke_tests::order::observed;
use hooke_tests::scene_runs::{Recorded, run_scene};

fn scene(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)
}

fn frames(name: &str, change: impl FnOnce(&mut Settings)) -> Vec<Recorded> {
    run_scene::<f64>(&scene(name), change).1
}

#[test]
fn the_first_frame_is_the_start_and_the_last_is_the_end() {
    for (duration, rate, count) in [(1.0, 60.0, 61), (0.99, 25.0, 26), (0.5, 3.0, 3), (0.01, 1.0, 2)] {
        let frames = frames("vertical-spring.toml", |settings| {
            (settings.duration, settings.frame_rate) = (duration, rate);
        });
        assert_eq!(frames.len(), count, "{duration} s at {rate} frames/s");
        for (number, (time, _)) in frames.iter().enumerate() {
            let expected = if number + 1 == count { duration } else { number as f64 / rate };
            assert_eq!(*time, expected, "frame {number} of {duration} s at {rate} frames/s");
        }
    }
}

#[test]
fn a_duration_that_is_no_whole_number_of_steps_ends_with_a_shorter_one() {
    let schedule = Schedule::new(1.0, Some(0.3), 10.0);
    assert_eq!(schedule.steps(), 4);
    assert!((schedule.short_step().unwrap() - 0.1).abs() < 1e-15);
    assert_eq!(schedule.step_end(4), 1.0);
    // 0.1 is not a binary fraction, but ten of it are 1 all the same.
    assert_eq!(Schedule::new(1.0, Some(0.1), 10.0).short_step(), None);
    assert_eq!(Schedule::new(3.0, Some(1e-3), 10.0).steps(), 3000);
    assert_eq!(Schedule::new(2e-3, Some(1e-2), 10.0).short_step(), Some(2e-3));
}

/// At 60, 30, 20 and 12 frames a second, the frames at the same times are the same to the bit: with springs, in exact
/// flight, in a mixture, on tracks, and with a step that no frame falls on.
#[test]
fn the_trajectory_does_not_depend_on_the_frame_rate() {
    for name in ["jelly-on-a-slope.toml", "bouncing-balls.toml", "funnel.toml", "whip.toml"] {
        let run = |rate: f64| {
            frames(name, |settings| {
                (settings.frame_rate, settings.duration) = (rate, 1.0);
                if settings.time_step != TimeStep::Auto {
                    settings.time_step = TimeStep::Seconds(7e-4);
                }
            })
        };
        let all = run(60.0);
        for (rate, every) in [(30.0, 2), (20.0, 3), (12.0, 5)] {
            for ((time, moment), (all_time, all_moment)) in run(rate).iter().zip(all.iter().step_by(every)) {
                assert!((time - all_time).abs() < 1e-12);
                assert_eq!(moment, all_moment, "{name} at {rate} frames/s, t = {time}");
            }
        }
    }
}

/// Between two steps of a smooth motion the cubic is right to the fourth order: halving a step that already resolves
/// the motion changes the frame by the stepper's second order, not by the interpolation's.
#[test]
fn frames_between_steps_keep_the_steppers_order() {
    let fine = frames("vertical-spring.toml", |settings| {
        (settings.duration, settings.frame_rate) = (1.0, 7.0);
        settings.time_step = TimeStep::Seconds(1e-5);
    });
    let error = |dt: f64| {
        let frames = frames("vertical-spring.toml", |settings| {
            (settings.duration, settings.frame_rate) = (1.0, 7.0);
            settings.time_step = TimeStep::Seconds(dt);
        });
        let errors = frames.iter().zip(&fine).map(|((_, a), (_, b))| position_error(a, b).max(velocity_error(a, b)));
        errors.fold(0.0, f64::max)
    };
    let order = observed(&[0.04, 0.02, 0.01, 0.005], error);
    assert!((1.9..2.2).contains(&order.slope), "{order:?}");
}

/// A particle in exact flight is on its arc at every frame, also where springs are stepped in between.
#[test]
fn frames_of_exact_flight_are_on_the_arc() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mixed.toml");
    let text = r#"
        gravity = [0.0, 0.0, -8.0]
        duration = 0.7
        time_step = 0.05
        frame_rate = 60
        stepper = "auto"
        [[particle]]
        position = [0.0, 0.0, 1.0]
        pinned = true
        [[particle]]
        position = [2.0, 0.0, 1.0]
        velocity = [1.0, 0.5, 2.0]
        [[particle]]
        position = [0.0, 0.3, 0.5]
        [[spring]]
        between = [0, 2]
        stiffness = 20.0
        [[plane]]
        point = [0.0, 0.0, 0.0]
        normal = [0.0, 0.0, 1.0]
        restitution = 0.5
    "#;
    std::fs::write(&path, text).unwrap();
    let (_, frames) = run_scene::<f64>(&path, |_| {});
    assert_eq!(frames.len(), 43);
    for (time, moment) in frames {
        // It first lands after (2 + √20)/8 = 0.81 s.
        let expected = [2.0 + time, 0.5 * time, 1.0 + 2.0 * time - 4.0 * time * time];
        let off = moment.position[1].iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-14, "{off:e} off the arc at {time}");
    }
}

#[test]
fn a_coarser_step_would_be_noticed() {
    let run = |dt| {
        frames("vertical-spring.toml", |settings| {
            settings.time_step = TimeStep::Seconds(dt);
            settings.stepper = StepperName::SemiImplicitEuler;
        })
    };
    assert_ne!(run(2e-3).last(), run(1e-3).last());
}
