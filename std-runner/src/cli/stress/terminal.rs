//! What the terminal shows.

use crate::advice::limit_in_words;
use crate::cli::table::rows;
use crate::model::Model;
use crate::report::{found, limit_rows, limits_in_words, verdict_rows, wanting};
use crate::stress::battery::{Tried, Verdict};
use crate::stress::{Limit, Limits, Stressed};

/// The longest reason that a line has room for.
const LONGEST: usize = 110;

/// One stepper's limit, while others are being found.
pub(super) fn limit(limit: &Limit) -> String {
    format!("{}: {}", limit.stepper, found(limit))
}

/// One case, while others are being tried.
pub(super) fn case(tried: &Tried) -> String {
    let number = |verdict| tried.runs.iter().filter(|run| run.judged.verdict == verdict).count();
    let counts = Verdict::ALL.map(|verdict| (number(verdict), verdict)).into_iter().filter(|(count, _)| *count > 0);
    let counts: Vec<String> = counts.map(|(count, verdict)| format!("{count} {}", verdict.name())).collect();
    format!("{}: {}", tried.case.name, counts.join(", "))
}

/// Limits and battery of a scene.
pub(super) fn scene(model: &Model, stressed: &Stressed) -> String {
    let mut lines = vec![stressed.name.clone()];
    match &stressed.limits {
        Some(limits) => lines.extend(limited(model, limits)),
        None => lines.push("  no spring pulls at any free particle: nothing limits the time step".to_owned()),
    }
    lines.push(String::new());
    lines.extend(battery("battery: the scene made hard", stressed));
    lines.join("\n") + "\n"
}

/// The battery of the bodies beside all scenes.
pub(super) fn bodies(stressed: &Stressed) -> String {
    battery(&format!("battery: {}", stressed.name), stressed).join("\n") + "\n"
}

fn limited(model: &Model, limits: &Limits) -> Vec<String> {
    let mut lines = vec![format!("  {}", limits_in_words(limits))];
    lines.push(format!("  It is set by {}.", limit_in_words(model, &limits.blocks)));
    lines.push(String::new());
    lines.push("largest stable time step".to_owned());
    lines.extend(rows(&six(&limit_rows(limits)), 2));
    if limits.interrupted {
        lines.push("  interrupted: not all steppers were tried".to_owned());
    }
    lines
}

fn six(table: &[Vec<String>]) -> Vec<[String; 6]> {
    table.iter().map(|row| std::array::from_fn(|column| row.get(column).cloned().unwrap_or_default())).collect()
}

fn battery(title: &str, stressed: &Stressed) -> Vec<String> {
    let mut lines = vec![title.to_owned()];
    let table: Vec<[String; 9]> = verdict_rows(&stressed.tried)
        .iter()
        .map(|row| std::array::from_fn(|column| row.get(column).cloned().unwrap_or_default()))
        .collect();
    lines.extend(rows(&table, 2));
    for tried in &stressed.tried {
        let mut wanting = wanting(tried).into_iter().peekable();
        if let Some([name, ..]) = wanting.peek() {
            lines.push(format!("  {name}"));
        }
        let table: Vec<[String; 3]> =
            wanting.map(|[_, steppers, verdict, why]| [steppers, verdict, short(&why)]).collect();
        lines.extend(rows(&table, 4));
    }
    if stressed.interrupted {
        lines.push("  interrupted: not all cases were tried".to_owned());
    }
    lines
}

/// As much of it as a line has room for.
fn short(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{} …", &text[..end]),
        None => text.to_owned(),
    }
}
