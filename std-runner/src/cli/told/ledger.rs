//! The energy ledger as a table.

use hooke::Balance;

use crate::cli::table::{numbers, rows};

/// One line an energy, and what the integrator itself added or lost.
pub(super) fn ledger(balance: &Balance) -> Vec<String> {
    let mut entries = vec![
        (" ", "kinetic", balance.kinetic),
        ("+", "elastic", balance.elastic),
        ("+", "gravitational", balance.gravitational),
        ("+", "lost to damping", balance.lost_to_damping),
        ("+", "lost in impacts", balance.lost_in_impacts),
        ("+", "lost to sleep", balance.lost_to_sleep),
        ("-", "work of moving pins", balance.work_of_pins),
        ("-", "at the start", balance.opened_with),
        ("=", "the integrator's own error", balance.remainder()),
    ];
    // Where nothing has fallen asleep there is nothing to say.
    entries.retain(|(_, name, value)| *name != "lost to sleep" || *value != 0.0);
    let values = numbers(&entries.iter().map(|(.., value)| *value).collect::<Vec<_>>());
    let mut table: Vec<[String; 4]> = entries
        .iter()
        .zip(values)
        .map(|((sign, name, _), value)| [(*sign).to_owned(), (*name).to_owned(), value, String::new()])
        .collect();
    if let Some([.., note]) = table.last_mut() {
        *note = relative(balance);
    }
    let mut lines = vec!["energy ledger, J".to_owned()];
    lines.extend(rows(&table, 2));
    lines
}

fn relative(balance: &Balance) -> String {
    let scale = balance.scale();
    if scale > 0.0 { format!("{:.1e} of the largest", balance.remainder().abs() / scale) } else { String::new() }
}
