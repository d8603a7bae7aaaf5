//! Limits and verdicts as tables and in words, for pages and terminals alike.

use crate::scene::Precision;
use crate::stress::battery::{Case, Group, Run, Runner, Tried, Verdict};
use crate::stress::{Found, Growth, Limit, Limits, Trend};
use crate::units::{count, counted, seconds, short};

/// What limits time steps.
#[must_use]
pub fn limits_in_words(limits: &Limits) -> String {
    let Limits { frequency, blocks, compressed, .. } = limits;
    let buckling = match compressed {
        0 => String::new(),
        number => format!(" Buckling of {} that are compressed is left out.", counted(*number as u64, "spring")),
    };
    format!(
        "The highest frequency at the start is {} rad/s, damped by {} of critical; the bound from the springs of each \
         particle is {} rad/s.{buckling}",
        short(frequency.highest),
        short(frequency.damping_ratio),
        short(blocks.frequency)
    )
}

/// A row for each stepper, below a head.
#[must_use]
pub fn limit_rows(limits: &Limits) -> Vec<Vec<String>> {
    let head = ["stepper", "bound", "theory", "found", "bound/found", "in a step, a change becomes"];
    let rows = limits.steppers.iter().map(|limit| {
        let part = match limit.found {
            Found::Limit(dt) if limit.bound.is_finite() => format!("{:.3}", limit.bound / dt),
            _ => String::new(),
        };
        [limit.stepper.to_string(), step(limit.bound), step(limit.theory), found(limit), part, sides(limit)].to_vec()
    });
    std::iter::once(head.map(str::to_owned).to_vec()).chain(rows).collect()
}

fn step(dt: f64) -> String {
    match dt {
        0.0 => "none".to_owned(),
        f64::INFINITY => "any".to_owned(),
        dt => seconds(dt),
    }
}

/// What trying has shown.
#[must_use]
pub fn found(limit: &Limit) -> String {
    match limit.found {
        Found::Limit(dt) => seconds(dt),
        Found::Stable(dt) => format!("any up to {}", seconds(dt)),
        Found::Grows(dt) => format!("none down to {}", seconds(dt)),
    }
}

fn sides(limit: &Limit) -> String {
    let [below, above] = &limit.growth;
    match limit.found {
        Found::Limit(_) => format!("{} at 0.99 of found, {} at 1.01", factor(below), factor(above)),
        Found::Stable(_) => format!("{} at the longest", factor(below)),
        Found::Grows(_) => format!("{} at the shortest", factor(below)),
    }
}

fn factor(growth: &Growth) -> String {
    match growth.trend {
        Trend::Kept => "1".to_owned(),
        _ if growth.factor < 1e-3 => "0".to_owned(),
        _ if (growth.factor - 1.0).abs() < 1e-3 => {
            format!("1 {:+.1e}", growth.factor - 1.0).replace("1 -", "1 − ").replace("1 +", "1 + ")
        }
        _ => format!("{:.3}", growth.factor),
    }
}

/// How many runs of each group have each verdict, below a head.
#[must_use]
pub fn verdict_rows(tried: &[Tried]) -> Vec<Vec<String>> {
    let head = std::iter::once(String::new()).chain(Verdict::ALL.map(|verdict| verdict.name().to_owned()));
    let mut groups: Vec<Group> = tried.iter().map(|tried| tried.case.group).collect();
    groups.sort();
    groups.dedup();
    let row = |group: Group| {
        let of_group = || tried.iter().filter(move |tried| tried.case.group == group).flat_map(|tried| &tried.runs);
        let number = |verdict| match of_group().filter(|run| run.judged.verdict == verdict).count() {
            0 => String::new(),
            number => count(number as u64),
        };
        std::iter::once(group.name().to_owned()).chain(Verdict::ALL.map(number)).collect()
    };
    std::iter::once(head.collect()).chain(groups.into_iter().map(row)).collect()
}

/// Every run that is wrong, exploded, refused, too slow or a defect, below a head; those of one case that came to the same are
/// one row, and each case is named once.
#[must_use]
pub fn wanting_rows(tried: &[Tried]) -> Vec<Vec<String>> {
    let head = ["case", "verdict", "why", "stepper"].map(str::to_owned).to_vec();
    let rows = tried.iter().flat_map(|tried| wanting(tried).into_iter().enumerate()).map(|(number, row)| {
        let [case, stepper, verdict, why] = row;
        vec![if number == 0 { case } else { String::new() }, verdict, why, stepper]
    });
    std::iter::once(head).chain(rows).collect()
}

/// The same of one case: its name, the steppers, the verdict, and why.
#[must_use]
pub fn wanting(tried: &Tried) -> Vec<[String; 4]> {
    let mut kinds: Vec<(Verdict, &str, Vec<Runner>)> = Vec::new();
    for Run { runner, judged, .. } in tried.runs.iter().filter(|run| run.judged.verdict > Verdict::Stable) {
        let is_alike = |kind: &&mut (Verdict, &str, Vec<Runner>)| kind.0 == judged.verdict && kind.1 == judged.reason;
        match kinds.iter_mut().find(is_alike) {
            Some((.., runners)) => runners.push(*runner),
            None => kinds.push((judged.verdict, &judged.reason, vec![*runner])),
        }
    }
    let Case { name, steps, .. } = &*tried.case;
    let name = format!("{name}, {} of {}", counted(*steps, "step"), seconds(tried.case.time_step()));
    let row = |(verdict, reason, runners): (Verdict, &str, Vec<Runner>)| {
        [name.clone(), names(&runners), verdict.name().to_owned(), reason.to_owned()]
    };
    kinds.into_iter().map(row).collect()
}

/// A stepper that is there in every precision is named once.
fn names(runners: &[Runner]) -> String {
    let mut names: Vec<String> = Vec::new();
    for runner in runners {
        let of_stepper = runners.iter().filter(|other| other.stepper == runner.stepper).count();
        let name = if of_stepper == Precision::ALL.len() { runner.stepper.to_string() } else { runner.to_string() };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.join(", ")
}
