//! The worlds do what they are there for: else all machines might agree on nothing in particular.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use hooke::{Lanes, StepReport};
use hooke_everywhere::{Form, Machine, Precision, Reached, Row, Scene, StepperName};

/// What all steps of a row tell.
fn reports(row: Row) -> Vec<StepReport> {
    let mut reports = Vec::new();
    row.follow(Machine { lanes: Lanes::Avx512, workers: None }, &mut |reached| match reached {
        Reached::Step { report, .. } => reports.push(*report),
        Reached::Refused(error) => panic!("{row}: {error}"),
        Reached::Unbuilt(error) => panic!("{row}: {error}"),
    });
    reports
}

fn row(scene: Scene, stepper: StepperName) -> Row {
    Row { scene, stepper, precision: Precision::F64, form: Form::TimeOfImpact }
}

#[test]
fn every_row_has_a_name_that_finds_it() {
    assert_eq!(Row::all().count(), 8 * 14 * 3 * 3);
    for row in Row::all() {
        assert_eq!(Row::of(row.to_string().split(' ')), Some(row));
    }
    assert_eq!(Row::of("rope rk4 f64 bounce".split(' ')), None);
}

#[test]
fn something_hits_a_plane_in_every_world_but_that_of_sleepers() {
    for scene in Scene::ALL {
        for form in Form::ALL {
            let row = Row { form: *form, ..row(*scene, StepperName::SemiImplicitEuler) };
            let hits: u32 = reports(row).iter().map(|report| report.hits).sum();
            assert_eq!(hits > 0, *scene != Scene::Sleepers, "{row}: {hits}");
        }
    }
}

#[test]
fn linear_systems_are_solved_in_both_ways() {
    let ways = |scene| {
        let reports = reports(row(scene, StepperName::ImplicitEuler));
        let sum = |what: fn(&StepReport) -> u32| reports.iter().map(what).sum::<u32>();
        [sum(|report| report.factorisations), sum(|report| report.linear_iterations)]
    };
    assert!(ways(Scene::Stiff)[0] > 0);
    let [factorisations, iterations] = ways(Scene::Cloth);
    assert!(factorisations == 0 && iterations > 0);
}

#[test]
fn one_rope_falls_asleep_and_one_does_not() {
    let reports = reports(row(Scene::Sleepers, StepperName::SemiImplicitEuler));
    assert_eq!(reports.first().unwrap().islands_asleep, 0);
    assert_eq!(reports.last().unwrap().islands_asleep, 1);
}

#[test]
fn a_spring_without_length_is_met() {
    let reports = reports(row(Scene::Everything, StepperName::ExplicitEuler));
    assert!(reports.iter().any(|report| report.degenerate_springs > 0));
}

#[test]
fn steps_of_its_own_choice_are_more_than_one() {
    let reports = reports(row(Scene::Everything, StepperName::AdaptiveDop853));
    assert!(reports.iter().map(|report| report.parts).sum::<u32>() > reports.len() as u32);
}
