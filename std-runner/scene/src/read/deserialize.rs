//! The tree into any type that serde can fill, with faults that keep their place.

use std::fmt;
use std::ops::Range;

use serde::de::value::StrDeserializer;
use serde::de::{
    DeserializeSeed, Deserializer, Error, Expected, IntoDeserializer, MapAccess, SeqAccess, Unexpected, Visitor,
};
use serde::forward_to_deserialize_any;

use super::super::error::Refusal;
use super::key_path::KeyPath;
use super::tree::{Entry, Node, Value};
use super::words;

/// Why a tree does not fit a type.
#[derive(Debug)]
pub(super) struct Fault {
    path: KeyPath,
    span: Option<Range<usize>>,
    kind: FaultKind,
}

#[derive(Debug)]
enum FaultKind {
    Mismatch { found: String, expected: String },
    UnknownKey { key: String, known: &'static [&'static str] },
    UnknownName { name: String, known: &'static [&'static str] },
    MissingKey(&'static str),
    Other(String),
}

impl Fault {
    /// At this place, if it is not yet known to be somewhere inside of it.
    fn at(mut self, span: &Range<usize>) -> Self {
        self.span.get_or_insert_with(|| span.clone());
        self
    }
}

impl From<FaultKind> for Fault {
    fn from(kind: FaultKind) -> Self {
        Self { path: KeyPath::default(), span: None, kind }
    }
}

impl Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        FaultKind::Other(message.to_string()).into()
    }

    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        let (found, expected) = (words::found(&found), words::expected(expected));
        FaultKind::Mismatch { found, expected }.into()
    }

    fn invalid_value(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::invalid_type(found, expected)
    }

    fn invalid_length(length: usize, expected: &dyn Expected) -> Self {
        let (found, expected) = (format!("a list of {length}"), words::expected(expected));
        FaultKind::Mismatch { found, expected }.into()
    }

    fn unknown_variant(name: &str, known: &'static [&'static str]) -> Self {
        let name = name.to_owned();
        FaultKind::UnknownName { name, known }.into()
    }

    fn unknown_field(key: &str, known: &'static [&'static str]) -> Self {
        let key = key.to_owned();
        FaultKind::UnknownKey { key, known }.into()
    }

    fn missing_field(key: &'static str) -> Self {
        FaultKind::MissingKey(key).into()
    }
}

impl std::error::Error for Fault {}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = if self.path.is_top() { "the scene".to_owned() } else { format!("`{}`", self.path) };
        match &self.kind {
            FaultKind::Mismatch { found, expected } => {
                write!(formatter, "{place}: expected {expected}, found {found}")
            }
            FaultKind::UnknownKey { key, .. } => write!(formatter, "{place} has no key `{key}`"),
            FaultKind::UnknownName { name, .. } => {
                write!(formatter, "{place} is {name:?}, which is no name it can have")
            }
            FaultKind::MissingKey(key) => write!(formatter, "{place} needs the key `{key}`"),
            FaultKind::Other(message) => write!(formatter, "{place}: {message}"),
        }
    }
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Self {
        let (label, remedy) = match &fault.kind {
            FaultKind::Mismatch { found, expected } if found == "a table" && expected == "a list" => {
                let key = &fault.path;
                let remedy = format!("write `[[{key}]]` with two brackets, or `\"{key}\": [{{…}}]` in JSON");
                ("one table".to_owned(), remedy)
            }
            FaultKind::Mismatch { expected, .. } => ("this".to_owned(), format!("write {expected}")),
            FaultKind::UnknownKey { key, known } => {
                let among = format!("The keys here are {}", known.join(", "));
                ("unknown key".to_owned(), did_you_mean(words::nearest(key, known), &among))
            }
            FaultKind::UnknownName { name, known } => {
                let among = format!("The names are {}", words::quoted(known));
                ("unknown name".to_owned(), did_you_mean(words::nearest(name, known), &among))
            }
            FaultKind::MissingKey(key) => {
                (format!("no `{key}` in here"), format!("add a line `{key} = …`, or `\"{key}\": …` in JSON"))
            }
            FaultKind::Other(_) => ("this".to_owned(), "write it as the example in the documentation does".to_owned()),
        };
        Self { message: fault.to_string(), span: fault.span, label, remedy }
    }
}

fn did_you_mean(nearest: Option<&str>, among: &str) -> String {
    match nearest {
        Some(nearest) => format!("Did you mean `{nearest}`? {among}"),
        None => among.to_owned(),
    }
}

impl Value {
    fn unexpected(&self) -> Unexpected<'_> {
        match self {
            Self::Null => Unexpected::Unit,
            Self::Boolean(boolean) => Unexpected::Bool(*boolean),
            Self::Integer(integer) => Unexpected::Signed(*integer),
            Self::Number(number) => Unexpected::Float(*number),
            Self::Text(text) => Unexpected::Str(text),
            Self::Date(date) => Unexpected::Other(date),
            Self::List(_) => Unexpected::Seq,
            Self::Table(_) => Unexpected::Map,
        }
    }
}

impl Node {
    fn visit<'de, V: Visitor<'de>>(&self, visitor: V) -> Result<V::Value, Fault> {
        match &self.value {
            Value::Null => visitor.visit_unit(),
            Value::Boolean(boolean) => visitor.visit_bool(*boolean),
            Value::Integer(integer) => visitor.visit_i64(*integer),
            Value::Number(number) => visitor.visit_f64(*number),
            Value::Text(text) => visitor.visit_str(text),
            Value::Date(_) => Err(Fault::invalid_type(self.value.unexpected(), &visitor)),
            Value::List(items) => visitor.visit_seq(Items { items: items.iter(), next: 0 }),
            Value::Table(entries) => visitor.visit_map(Entries { entries: entries.iter(), current: None }),
        }
    }
}

impl<'de> Deserializer<'de> for &Node {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.visit(visitor).map_err(|fault| fault.at(&self.span))
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, Fault> {
        match &self.value {
            // An array takes what it needs and would not see that there is more.
            Value::List(items) if items.len() != length => {
                Err(Fault::invalid_length(items.len(), &visitor).at(&self.span))
            }
            _ => self.deserialize_any(visitor),
        }
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _keys: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match &self.value {
            Value::Table(_) => self.deserialize_any(visitor),
            // Serde would take a list for a struct without its keys.
            other => Err(Fault::invalid_type(other.unexpected(), &visitor).at(&self.span)),
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let result = match &self.value {
            Value::Text(text) => visitor.visit_enum(text.as_str().into_deserializer()),
            other => {
                let expected = format!("one of {}", words::quoted(names));
                Err(Fault::invalid_type(other.unexpected(), &expected.as_str()))
            }
        };
        result.map_err(|fault: Fault| fault.at(&self.span))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct
        newtype_struct seq tuple_struct map identifier ignored_any
    }
}

struct Items<'tree> {
    items: std::slice::Iter<'tree, Node>,
    next: usize,
}

impl<'de> SeqAccess<'de> for Items<'_> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Fault> {
        let Some(item) = self.items.next() else {
            return Ok(None);
        };
        let index = self.next;
        self.next += 1;
        let value = seed.deserialize(item);
        value.map(Some).map_err(|fault| Fault { path: fault.path.inside_index(index), ..fault })
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len())
    }
}

struct Entries<'tree> {
    entries: std::slice::Iter<'tree, Entry>,
    current: Option<&'tree Entry>,
}

impl<'de> MapAccess<'de> for Entries<'_> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Fault> {
        self.current = self.entries.next();
        let Some(entry) = self.current else {
            return Ok(None);
        };
        let key: StrDeserializer<'_, Fault> = entry.key.as_str().into_deserializer();
        seed.deserialize(key).map(Some).map_err(|fault| fault.at(&entry.key_span))
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Fault> {
        let Some(entry) = self.current else {
            return Err(Fault::custom("a value was asked for before its key"));
        };
        let value = seed.deserialize(&entry.node);
        value.map_err(|fault| Fault { path: fault.path.inside_key(&entry.key), ..fault })
    }
}
