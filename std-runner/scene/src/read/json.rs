//! JSON into the tree.
//!
//! The parser tells no places of what it accepts, but the raw values it hands out are slices of the text, so each
//! knows where it stands.

use std::fmt;
use std::ops::Range;

use serde::Deserialize;
use serde::de::{MapAccess, Visitor};
use serde_json::value::RawValue;

use super::super::error::Refusal;
use super::tree::{Entry, Node, Value};
use super::words;

/// Lists in tables in lists go no deeper in a scene than this, with room to spare.
const DEEPEST: usize = 32;

/// Reads a whole document.
pub(super) fn parse(text: &str) -> Result<Node, Refusal> {
    let raw: &RawValue = serde_json::from_str(text).map_err(|error| syntax(text, &error))?;
    node(text, raw, 0)
}

fn node(text: &str, raw: &RawValue, depth: usize) -> Result<Node, Refusal> {
    let written = raw.get();
    let start = written.as_ptr() as usize - text.as_ptr() as usize;
    let span = start..start + written.len();
    if depth > DEEPEST {
        return Err(Refusal {
            span: Some(start..start + 1),
            message: format!("this is nested more than {DEEPEST} deep"),
            label: "too deep".to_owned(),
            remedy: "nothing in a scene is nested that deep: take some brackets away".to_owned(),
        });
    }
    // Everything is well-formed by now; only a number can still be more than a machine can hold.
    let too_large = |_| Refusal::not_a_number(span.clone(), written);
    let value = match written.as_bytes().first() {
        Some(b'{') => {
            let RawTable(pairs) = serde_json::from_str(written).map_err(too_large)?;
            let mut entries = Vec::<Entry>::with_capacity(pairs.len());
            for (key, raw) in pairs {
                let node = node(text, raw, depth + 1)?;
                let key_span = key_span(text, &key, &node.span);
                if entries.iter().any(|entry| entry.key == key) {
                    return Err(Refusal {
                        span: Some(key_span),
                        message: format!("the key `{key}` is written twice"),
                        label: "again here".to_owned(),
                        remedy: format!(
                            "keep one `{key}`; several things of a kind go into one list, `[{{…}}, {{…}}]`"
                        ),
                    });
                }
                entries.push(Entry { key, key_span, node });
            }
            Value::Table(entries)
        }
        Some(b'[') => {
            let items: Vec<&RawValue> = serde_json::from_str(written).map_err(too_large)?;
            let items = items.into_iter().map(|raw| node(text, raw, depth + 1));
            Value::List(items.collect::<Result<_, Refusal>>()?)
        }
        _ => match serde_json::from_str(written).map_err(too_large)? {
            serde_json::Value::Bool(boolean) => Value::Boolean(boolean),
            serde_json::Value::String(text) => Value::Text(text),
            serde_json::Value::Number(number) => match (number.as_i64(), number.as_f64()) {
                (Some(integer), _) => Value::Integer(integer),
                (None, Some(number)) => Value::Number(number),
                (None, None) => return Err(Refusal::not_a_number(span, number)),
            },
            _ => Value::Null,
        },
    };
    Ok(Node { span, value })
}

/// Where and why a text is not JSON.
fn syntax(text: &str, error: &serde_json::Error) -> Refusal {
    let line_start: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
    let mut start = (line_start + error.column().saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let end = start + text[start..].chars().next().map_or(0, char::len_utf8);
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let message = message.strip_suffix(&place).unwrap_or(&message);
    Refusal {
        span: Some(start..end),
        message: words::syntax("JSON", message, text.get(start..end)),
        label: "the text stops being JSON here".to_owned(),
        remedy: "write keys and texts in double quotes, a comma between items and none after the last".to_owned(),
    }
}

/// Where the key before a value stands.
fn key_span(text: &str, key: &str, value: &Range<usize>) -> Range<usize> {
    let before = text[..value.start].trim_end();
    let before = before.strip_suffix(':').unwrap_or(before).trim_end();
    let before = before.strip_suffix('"').unwrap_or(before);
    // A key written with escapes is longer than it reads: point at its value instead.
    if before.ends_with(key) { before.len() - key.len()..before.len() } else { value.clone() }
}

/// A table's keys and unread values, in file order, repeated keys and all.
struct RawTable<'text>(Vec<(String, &'text RawValue)>);

impl<'text> Deserialize<'text> for RawTable<'text> {
    fn deserialize<D: serde::Deserializer<'text>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pairs;
        impl<'text> Visitor<'text> for Pairs {
            type Value = RawTable<'text>;

            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("a table")
            }

            fn visit_map<A: MapAccess<'text>>(self, mut map: A) -> Result<RawTable<'text>, A::Error> {
                let mut pairs = Vec::new();
                while let Some(pair) = map.next_entry()? {
                    pairs.push(pair);
                }
                Ok(RawTable(pairs))
            }
        }
        deserializer.deserialize_map(Pairs)
    }
}
