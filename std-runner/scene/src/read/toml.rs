//! TOML into the tree.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::super::error::Refusal;
use super::tree::{Entry, Node, Value};
use super::words;

/// Reads a whole document.
pub(super) fn parse(text: &str) -> Result<Node, Refusal> {
    let document = DeTable::parse(text).map_err(|error| syntax(text, &error))?;
    let span = document.span();
    table(span, document.get_ref())
}

/// Where and why a text is not TOML.
fn syntax(text: &str, error: &toml::de::Error) -> Refusal {
    let span = error.span();
    let written = span.clone().and_then(|span| text.get(span));
    if error.message() == "duplicate key" {
        let key = written.unwrap_or_default();
        return Refusal {
            span,
            message: format!("the key `{key}` is written twice"),
            label: "again here".to_owned(),
            remedy: format!("keep one `{key}`; several things of a kind each go under a `[[…]]` header"),
        };
    }
    Refusal {
        span,
        message: words::syntax("TOML", error.message(), written),
        label: "the text stops being TOML here".to_owned(),
        remedy: "write `key = value` lines, and `[[particle]]` and the like above those of each thing; \
                 texts go in double quotes, commas between the items of a list"
            .to_owned(),
    }
}

fn table(span: Range<usize>, table: &DeTable<'_>) -> Result<Node, Refusal> {
    let entries = table.iter().map(|(key, value)| {
        Ok::<_, Refusal>(Entry { key: key.get_ref().to_string(), key_span: key.span(), node: node(value)? })
    });
    let value = Value::Table(entries.collect::<Result<_, Refusal>>()?);
    Ok(Node { span, value })
}

fn node(value: &Spanned<DeValue<'_>>) -> Result<Node, Refusal> {
    let span = value.span();
    let value = match value.get_ref() {
        DeValue::String(text) => Value::Text(text.to_string()),
        DeValue::Integer(integer) => match i64::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(integer) => Value::Integer(integer),
            Err(_) => return Err(Refusal::not_a_number(span, integer)),
        },
        DeValue::Float(float) => match float.as_str().parse::<f64>() {
            // Only the words `inf` and `-inf` mean infinity; `1e999` is a slip of the pen.
            Ok(number) if number.is_finite() || !float.as_str().contains(['e', 'E', '.']) => Value::Number(number),
            _ => return Err(Refusal::not_a_number(span, float)),
        },
        DeValue::Boolean(boolean) => Value::Boolean(*boolean),
        DeValue::Datetime(date) => Value::Date(format!("the date {date}")),
        DeValue::Array(items) => Value::List(items.iter().map(node).collect::<Result<_, Refusal>>()?),
        DeValue::Table(inner) => return table(span, inner),
    };
    Ok(Node { span, value })
}
