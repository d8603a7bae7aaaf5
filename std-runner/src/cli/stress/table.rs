//! All figures as one table: a row for each quantity, run and cell.

use std::io::Write;

use crate::stress::battery::{Run, Tried};
use crate::stress::{Found, Limit, Map, Stressed, Trend};

/// One figure. What it does not have is left empty.
#[derive(Clone, Copy, Debug, Default, serde::Serialize)]
struct Row<'a> {
    scene: &'a str,
    /// `limit`, `run` or `cell`.
    kind: &'static str,
    stepper: &'a str,
    precision: &'a str,
    /// Of limits: which figure. Of runs: what is hard. Of cells: the damping.
    group: &'a str,
    /// Of runs: the case.
    name: &'a str,
    steps: Option<u64>,
    /// s
    time_step: Option<f64>,
    /// Of cells: times the scene's.
    stiffness: Option<f64>,
    verdict: &'a str,
    /// Of limits: s, or the factor of a step. Of runs: the error, relative.
    value: Option<f64>,
    /// s
    seconds: Option<f64>,
    reason: &'a str,
}

pub(super) fn write(all: &[Stressed], to: impl Write) -> Result<(), csv::Error> {
    let mut writer = csv::Writer::from_writer(to);
    for stressed in all {
        let scene = stressed.name.as_str();
        for limit in stressed.limits.iter().flat_map(|limits| &limits.steppers) {
            limit_rows(scene, limit).into_iter().try_for_each(|row| writer.serialize(row))?;
        }
        for tried in &stressed.tried {
            tried.runs.iter().try_for_each(|run| writer.serialize(run_row(scene, tried, run)))?;
        }
        for map in &stressed.maps {
            cell_rows(scene, map).try_for_each(|row| writer.serialize(row))?;
        }
    }
    writer.flush()?;
    Ok(())
}

fn limit_rows<'a>(scene: &'a str, limit: &Limit) -> [Row<'a>; 5] {
    let row = Row { scene, kind: "limit", stepper: limit.stepper.name(), precision: "f64", ..Row::default() };
    let figure = |group, value| Row { group, value: Some(value), ..row };
    let (verdict, found) = match limit.found {
        Found::Limit(dt) => ("largest stable", dt),
        Found::Stable(dt) => ("stable up to", dt),
        Found::Grows(dt) => ("grows down to", dt),
    };
    let [below, above] = limit.growth.map(|growth| {
        let verdict = match growth.trend {
            Trend::Damped => "damped",
            Trend::Kept => "kept",
            Trend::Growing => "growing",
        };
        (verdict, growth)
    });
    [
        figure("bound", limit.bound),
        figure("theory", limit.theory),
        Row { verdict, ..figure("found", found) },
        Row { verdict: below.0, steps: Some(below.1.steps), ..figure("growth below", below.1.factor) },
        Row { verdict: above.0, steps: Some(above.1.steps), ..figure("growth above", above.1.factor) },
    ]
}

fn run_row<'a>(scene: &'a str, tried: &'a Tried, run: &'a Run) -> Row<'a> {
    Row {
        scene,
        kind: "run",
        stepper: run.runner.stepper.name(),
        precision: run.runner.precision.name(),
        group: tried.case.group.name(),
        name: &tried.case.name,
        steps: Some(tried.case.steps),
        time_step: Some(tried.case.time_step()),
        verdict: run.judged.verdict.name(),
        value: run.judged.error,
        seconds: Some(run.seconds),
        reason: &run.judged.reason,
        ..Row::default()
    }
}

fn cell_rows<'a>(scene: &'a str, map: &'a Map) -> impl Iterator<Item = Row<'a>> {
    map.panels.iter().flat_map(move |panel| {
        let rows = map.stiffness.iter().flat_map(|stiffness| map.time_steps.iter().map(move |dt| (*stiffness, *dt)));
        rows.zip(&panel.cells).map(move |((stiffness, time_step), fate)| Row {
            scene,
            kind: "cell",
            stepper: map.stepper.name(),
            precision: "f64",
            group: &panel.damping,
            time_step: Some(time_step),
            stiffness: Some(stiffness),
            verdict: fate.name(),
            ..Row::default()
        })
    })
}
