//! How a scene is rendered if the user asks for nothing else: a field for every knob that scene files can set.

use std::borrow::Cow;
use std::fmt;
use std::sync::LazyLock;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error, MapAccess, VariantAccess, Visitor,
};
use serde::ser::SerializeMap as _;
use serde::{Deserialize, Serialize, Serializer};

use crate::scene::settings::knob::{Kind, Knob, Value, Word};
use crate::scene::settings::knobs::knobs;

/// What is left out has the default of the program.
#[derive(Clone, Debug, Default)]
pub struct SettingsFile {
    /// What they are there for.
    pub note: Option<String>,
    /// The knobs that are set, in the order of their table.
    pub values: Vec<(&'static Knob, Value)>,
}

/// Names of the fields.
static KEYS: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    let keys = in_files().map(|knob| &*knob.key().leak());
    std::iter::once("note").chain(keys).collect()
});

/// The knobs that scene files can set.
fn in_files() -> impl Iterator<Item = &'static Knob> {
    knobs().filter(|knob| knob.in_files)
}

impl PartialEq for SettingsFile {
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&(&Knob, Value), &(&Knob, Value))| a.0.flag == b.0.flag && a.1 == b.1;
        self.note == other.note
            && self.values.len() == other.values.len()
            && self.values.iter().zip(&other.values).all(same)
    }
}

impl Serialize for SettingsFile {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("note", &self.note)?;
        for (knob, value) in &self.values {
            map.serialize_entry(&knob.key(), value)?;
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for SettingsFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Fields;

        impl<'de> Visitor<'de> for Fields {
            type Value = SettingsFile;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("struct SettingsFile")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<SettingsFile, A::Error> {
                let mut note = None;
                let mut given: Vec<Option<Option<Value>>> = vec![None; KEYS.len()];
                while let Some(key) = map.next_key_seed(Name(Key))? {
                    let index = KEYS.iter().position(|known| *known == key).unwrap_or(0);
                    if given[index].is_some() {
                        return Err(A::Error::duplicate_field(KEYS[index]));
                    }
                    let knob = index.checked_sub(1).and_then(|i| in_files().nth(i));
                    given[index] = Some(if let Some(knob) = knob {
                        map.next_value_seed(OfKind(knob.kind))?
                    } else {
                        note = map.next_value()?;
                        None
                    });
                }
                let values = in_files().zip(given.into_iter().skip(1));
                let values = values.filter_map(|(knob, value)| Some((knob, value??)));
                Ok(SettingsFile {
                    note,
                    values: values.collect(),
                })
            }
        }

        deserializer.deserialize_struct("SettingsFile", &[], Fields)
    }
}

/// Reads a value of this kind, or null.
#[derive(Clone, Copy)]
struct OfKind(Kind);

impl<'de> DeserializeSeed<'de> for OfKind {
    type Value = Option<Value>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        Ok(match self.0 {
            Kind::Size => Option::deserialize(deserializer)?.map(Value::Size),
            Kind::Count { .. } => {
                let count = Option::<u32>::deserialize(deserializer)?;
                count.map(|n| Value::Whole(n.into()))
            }
            Kind::Whole(_) => Option::deserialize(deserializer)?.map(Value::Whole),
            Kind::Real { .. } => Option::deserialize(deserializer)?.map(Value::Real),
            Kind::Text(_) => Option::deserialize(deserializer)?.map(Value::Text),
            Kind::Choices(_) => Option::deserialize(deserializer)?.map(Value::List),
            Kind::Choice(words) => deserializer.deserialize_option(OneOf(words()))?,
        })
    }
}

/// Reads one of these words, or null.
struct OneOf(Vec<Word>);

impl<'de> Visitor<'de> for OneOf {
    type Value = Option<Value>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a word")
    }

    fn visit_none<E: Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_unit<E: Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_enum("word", &[], self)
    }

    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<Self::Value, A::Error> {
        let (name, content) = data.variant_seed(Name(self.0))?;
        content.unit_variant()?;
        Ok(Some(Value::Text(name)))
    }
}

/// Reads a name, and checks it.
struct Name<T>(T);

/// Names that are possible at one point of a file.
trait Names {
    /// An error if a name is none of them.
    fn check<E: Error>(&self, name: &str) -> Result<(), E>;
}

/// Names of fields.
struct Key;

impl Names for Key {
    fn check<E: Error>(&self, name: &str) -> Result<(), E> {
        let known = KEYS.contains(&name);
        known
            .then_some(())
            .ok_or_else(|| E::unknown_field(name, &KEYS))
    }
}

impl Names for Vec<Word> {
    fn check<E: Error>(&self, name: &str) -> Result<(), E> {
        if self.iter().any(|word| word.name == name) {
            return Ok(());
        }
        let known: Vec<String> = self.iter().map(|word| format!("`{}`", word.name)).collect();
        let message = format!(
            "unknown variant `{name}`, expected one of {}",
            known.join(", ")
        );
        Err(E::custom(message))
    }
}

impl<'de, T: Names> DeserializeSeed<'de> for Name<T> {
    type Value = String;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<String, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<T: Names> Visitor<'_> for Name<T> {
    type Value = String;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a name")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<String, E> {
        self.0.check(name).map(|()| name.to_owned())
    }
}

impl JsonSchema for SettingsFile {
    fn schema_name() -> Cow<'static, str> {
        "SettingsFile".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let note =
            json_schema!({ "type": ["string", "null"], "description": "What they are there for." });
        let fields = in_files().map(|knob| (knob.key(), knob.schema()));
        let fields: serde_json::Map<String, serde_json::Value> =
            std::iter::once(("note".to_owned(), note))
                .chain(fields)
                .map(|(key, schema)| (key, schema.to_value()))
                .collect();
        json_schema!({
            "type": "object",
            "description": "How a scene is rendered if the user asks for nothing else. What is left out has the default of the program.",
            "properties": fields,
            "additionalProperties": false,
        })
    }
}

impl Knob {
    /// JSON Schema of its values, and of null.
    fn schema(&self) -> Schema {
        let description = format!("{}.", self.doc);
        match self.kind {
            Kind::Size => json_schema!({
                "type": ["array", "null"], "description": description, "minItems": 2, "maxItems": 2,
                "items": { "type": "integer", "format": "uint32", "minimum": 0 },
            }),
            Kind::Count { .. } => json_schema!({
                "type": ["integer", "null"], "description": description, "format": "uint32", "minimum": 0,
            }),
            Kind::Whole(_) => json_schema!({
                "type": ["integer", "null"], "description": description, "format": "uint64", "minimum": 0,
            }),
            Kind::Real { .. } => json_schema!({
                "type": ["number", "null"], "description": description, "format": "double",
            }),
            Kind::Text(_) => {
                json_schema!({ "type": ["string", "null"], "description": description })
            }
            Kind::Choices(words) => json_schema!({
                "type": ["array", "null"], "description": description, "items": one_of(&words()),
            }),
            Kind::Choice(words) => json_schema!({
                "description": description, "anyOf": [one_of(&words()), { "type": "null" }],
            }),
        }
    }
}

/// JSON Schema of words.
fn one_of(words: &[Word]) -> serde_json::Value {
    let words = words.iter().map(|word| match word.doc {
        "" => serde_json::json!({ "type": "string", "const": word.name }),
        doc => serde_json::json!({ "type": "string", "const": word.name, "description": format!("{doc}.") }),
    });
    serde_json::json!({ "oneOf": words.collect::<Vec<_>>() })
}
