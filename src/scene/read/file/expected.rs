//! What the format of scene files has at a path, looked up in its JSON Schema.

use std::sync::LazyLock;

use serde_json::Value;
use serde_path_to_error::{Path, Segment};

use super::SceneFile;

/// JSON Schema of scene files, made from their types when it is first needed.
pub static SCHEMA: LazyLock<Value> = LazyLock::new(|| schemars::schema_for!(SceneFile).to_value());

/// Part of the schema: what is expected at a path.
#[derive(Clone, Copy)]
pub struct Expected(&'static Value);

impl Expected {
    /// What is expected at `path`, and whether the path goes on into a list where an object with named fields is
    /// expected. `None` if the format has nothing there.
    pub fn at(path: &Path) -> Option<(Self, bool)> {
        let mut expected = Self(&SCHEMA);
        for segment in path {
            match segment {
                Segment::Seq { .. } if expected.fields().is_some() => {
                    return Some((expected, true));
                }
                Segment::Seq { .. } => expected = expected.step("items")?,
                Segment::Map { key } | Segment::Enum { variant: key } => {
                    expected = expected.key(key)?;
                }
                Segment::Unknown => {}
            }
        }
        Some((expected, false))
    }

    /// Part of this one under a keyword, without references and without what stands beside `null`.
    fn step(self, keyword: &str) -> Option<Self> {
        let mut part = self.0.get(keyword)?;
        loop {
            if let Some(reference) = part["$ref"].as_str() {
                part = SCHEMA.pointer(reference.strip_prefix('#')?)?;
            } else if part["anyOf"][1]["type"] == "null" {
                part = &part["anyOf"][0];
            } else {
                return Some(Self(part));
            }
        }
    }

    /// What is expected of the field `key` of an object, or of the kind `key`.
    fn key(self, key: &str) -> Option<Self> {
        let fields = Self(self.0.get("properties").unwrap_or(&Value::Null));
        let kinds = self.0["oneOf"].as_array().into_iter().flatten();
        fields
            .step(key)
            .or_else(|| {
                self.step("additionalProperties")
                    .filter(|other| other.0.is_object())
            })
            .or_else(|| kinds.map(Self).find_map(|kind| kind.key(key)))
    }

    /// Names of the fields of an object: those that must be there, or else all. `None` for any other value.
    pub fn fields(self) -> Option<Vec<&'static str>> {
        let all = self.0["properties"].as_object()?;
        let required = self.0["required"].as_array().into_iter().flatten();
        let required: Vec<_> = required.filter_map(Value::as_str).collect();
        let all = || all.keys().map(String::as_str).collect();
        Some(if required.is_empty() { all() } else { required })
    }

    /// Kinds of which one is named as the key of an object, such as `sphere`.
    pub fn kinds(self) -> Vec<&'static str> {
        let kinds = self.0["oneOf"].as_array().into_iter().flatten();
        let kind = |kind: &'static Value| kind["required"][0].as_str();
        kinds.filter_map(kind).collect()
    }

    /// Length of a list, if all have the same.
    pub fn length(self) -> Option<u64> {
        self.0["maxItems"].as_u64()
    }

    /// Whether it is one of several kinds or words.
    pub fn is_choice(self) -> bool {
        self.0["oneOf"].is_array()
    }

    /// Example of an object, with its values left open; the first of several kinds.
    pub fn example(self) -> String {
        let kinds = self.kinds();
        if let Some(fields) = self.fields() {
            let fields: Vec<_> = fields.iter().map(|f| format!("\"{f}\": ...")).collect();
            format!("{{{}}}", fields.join(", "))
        } else if let Some(kind) = kinds.first() {
            let fields = self.key(kind).map_or("...".to_string(), Self::example);
            format!("{{\"{kind}\": {fields}}}")
        } else {
            "...".to_string()
        }
    }

    /// What is expected, in plain words.
    pub fn in_words(self) -> String {
        let kind = &self.0["type"];
        let kind = kind.as_str().or_else(|| kind[0].as_str());
        match (kind, self.0["format"].as_str()) {
            (Some("number"), _) => "a number".to_string(),
            (Some("integer"), Some("uint32")) => format!("a whole number from 0 to {}", u32::MAX),
            (Some("integer"), Some("int32")) => {
                format!("a whole number from {} to {}", i32::MIN, i32::MAX)
            }
            (Some("integer"), _) => "a whole number from 0 up".to_string(),
            (Some("array"), _) => match self.length() {
                Some(length) => format!("a list of length {length}"),
                None => "a list".to_string(),
            },
            (Some("object"), _) if self.0["additionalProperties"].is_object() => {
                "an object {...} with a name for each entry".to_string()
            }
            (Some("object"), _) => "an object {...}".to_string(),
            (Some("string"), _) => "a string".to_string(),
            _ if !self.kinds().is_empty() => "an object {...} that names its kind".to_string(),
            _ => {
                let words = self.0["oneOf"].as_array().into_iter().flatten();
                let words: Vec<String> = words.map(|word| word["const"].to_string()).collect();
                format!("one of {}", words.join(", "))
            }
        }
    }
}
