//! Which particles of a grid are pinned: by a name for several, or by place for one.

use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{SeqAccessDeserializer, StrDeserializer};
use serde::de::{Error, IgnoredAny, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::error::Problem;

/// A name, or the place of a particle along each side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Selector<Name, const SIDES: usize> {
    Named(Name),
    At([u32; SIDES]),
}

impl<Name, const SIDES: usize> Selector<Name, SIDES> {
    /// Refuses places outside of the grid.
    pub(super) fn check(&self, number: usize, counts: [u32; SIDES]) -> Result<(), Problem> {
        let Self::At(place) = self else { return Ok(()) };
        if place.iter().zip(&counts).all(|(place, count)| place < count) {
            return Ok(());
        }
        let last = counts.map(|count| count - 1);
        let rule = format!("the places go from {:?} to {last:?}", [0; SIDES]);
        Err(Problem::item("pinned", number, place, rule, "pin a particle that exists; places count from 0"))
    }
}

impl<'de, Name, const SIDES: usize> Deserialize<'de> for Selector<Name, SIDES>
where
    Name: Deserialize<'de>,
    [u32; SIDES]: Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NameOrPlace(PhantomData))
    }
}

struct NameOrPlace<Selected>(PhantomData<Selected>);

impl<'de, Name, const SIDES: usize> Visitor<'de> for NameOrPlace<Selector<Name, SIDES>>
where
    Name: Deserialize<'de>,
    [u32; SIDES]: Deserialize<'de>,
{
    type Value = Selector<Name, SIDES>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "a name in double quotes or a list of {SIDES} whole numbers")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Self::Value, E> {
        Name::deserialize(StrDeserializer::new(name)).map(Selector::Named)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut places: A) -> Result<Self::Value, A::Error> {
        let place = <[u32; SIDES]>::deserialize(SeqAccessDeserializer::new(&mut places))?;
        let mut length = SIDES;
        while places.next_element::<IgnoredAny>()?.is_some() {
            length += 1;
        }
        if length > SIDES {
            return Err(A::Error::invalid_length(length, &self));
        }
        Ok(Selector::At(place))
    }
}

impl<Name, const SIDES: usize> JsonSchema for Selector<Name, SIDES>
where
    Name: JsonSchema,
    [u32; SIDES]: JsonSchema,
{
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        format!("{}OrPlace", Name::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (name, place) = (generator.subschema_for::<Name>(), generator.subschema_for::<[u32; SIDES]>());
        json_schema!({ "anyOf": [name, place] })
    }
}
