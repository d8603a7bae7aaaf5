//! How long a step is.

use std::fmt;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer};

/// The length of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum TimeStep {
    /// Chosen for the scene when it is prepared.
    #[default]
    Auto,
    /// s, more than 0
    Seconds(f64),
}

impl fmt::Display for TimeStep {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Auto => formatter.write_str("auto"),
            Self::Seconds(seconds) => write!(formatter, "{seconds:?}"),
        }
    }
}

impl FromStr for TimeStep {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "auto" => Ok(Self::Auto),
            _ => text
                .parse()
                .map(Self::Seconds)
                .map_err(|_| format!("expected a number of seconds or auto, found {text:?}")),
        }
    }
}

impl<'de> Deserialize<'de> for TimeStep {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Seconds)
    }
}

struct Seconds;

impl Visitor<'_> for Seconds {
    type Value = TimeStep;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a number of seconds or \"auto\"")
    }

    fn visit_f64<E: Error>(self, seconds: f64) -> Result<TimeStep, E> {
        Ok(TimeStep::Seconds(seconds))
    }

    fn visit_i64<E: Error>(self, seconds: i64) -> Result<TimeStep, E> {
        Ok(TimeStep::Seconds(seconds as f64))
    }

    fn visit_u64<E: Error>(self, seconds: u64) -> Result<TimeStep, E> {
        Ok(TimeStep::Seconds(seconds as f64))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<TimeStep, E> {
        match text {
            "auto" => Ok(TimeStep::Auto),
            _ => Err(E::invalid_value(serde::de::Unexpected::Str(text), &self)),
        }
    }
}

impl JsonSchema for TimeStep {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "TimeStep".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "The length of a step, s, or \"auto\".",
            "anyOf": [{ "type": "number", "exclusiveMinimum": 0 }, { "const": "auto" }]
        })
    }
}

impl serde::Serialize for TimeStep {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Auto => serializer.serialize_str("auto"),
            Self::Seconds(seconds) => serializer.serialize_f64(*seconds),
        }
    }
}
