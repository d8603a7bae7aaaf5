//! A parser's terms, in a person's words.

use serde::de::{Expected, Unexpected};

/// What was found.
pub(super) fn found(unexpected: &Unexpected<'_>) -> String {
    match unexpected {
        Unexpected::Bool(boolean) => format!("`{boolean}`"),
        Unexpected::Unsigned(number) => format!("the number {number}"),
        Unexpected::Signed(number) => format!("the number {number}"),
        Unexpected::Float(number) => format!("the number {number:?}"),
        Unexpected::Str(text) => format!("the text {text:?}"),
        Unexpected::Unit => "null".to_owned(),
        Unexpected::Seq => "a list".to_owned(),
        Unexpected::Map => "a table".to_owned(),
        other => other.to_string(),
    }
}

/// What belongs there.
pub(super) fn expected(expected: &dyn Expected) -> String {
    let term = expected.to_string();
    match term.as_str() {
        "f64" => "a number".to_owned(),
        "u32" => "a whole number from 0 to 4294967295".to_owned(),
        "a boolean" => "true or false".to_owned(),
        "a string" => "a text in double quotes".to_owned(),
        "a sequence" => "a list".to_owned(),
        _ if term.starts_with("struct ") => "a table of keys and values".to_owned(),
        _ => match term.strip_prefix("an array of length ") {
            Some(length) => format!("a list of {length} numbers"),
            None => term,
        },
    }
}

/// Why a text is not of its format, and what stands where it stops being so.
pub(super) fn syntax(format: &str, why: &str, written: Option<&str>) -> String {
    match written.and_then(|written| written.lines().next()) {
        Some(written) if !written.trim().is_empty() => {
            format!("this is not {format}: {why}, at `{written}`")
        }
        _ => format!("this is not {format}: {why}"),
    }
}

/// `"a", "b", "c"`
pub(super) fn quoted(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    quoted.join(", ")
}

/// The name most like what was written, if any is like it at all.
pub(super) fn nearest<'a>(written: &str, names: &[&'a str]) -> Option<&'a str> {
    let likeness = |name: &&'a str| (strsim::jaro_winkler(written, name), *name);
    names
        .iter()
        .map(likeness)
        .max_by(|(a, _), (b, _)| a.total_cmp(b))
        .filter(|(likeness, _)| *likeness > 0.7)
        .map(|(_, name)| name)
}
