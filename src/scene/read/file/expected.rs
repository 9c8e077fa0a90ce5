//! What the format of scene files has at a place, looked up in its JSON Schema.

use std::sync::LazyLock;

use serde_json::Value;

use super::SceneFile;

/// JSON Schema of scene files, made from their types when it is first needed.
pub static SCHEMA: LazyLock<Value> = LazyLock::new(|| schemars::schema_for!(SceneFile).to_value());

/// Part of the schema: what is expected at a place.
#[derive(Clone, Copy)]
pub struct Expected {
    part: &'static Value,
    /// Sentence about it, if there is one.
    about: Option<&'static str>,
}

impl Expected {
    /// What a whole file is.
    pub fn scene() -> Self {
        Self::of(&SCHEMA)
    }

    /// Part of the schema, without references and without what stands beside `null`.
    fn of(mut part: &'static Value) -> Self {
        let about = part["description"].as_str();
        loop {
            let target = part["$ref"].as_str().and_then(|r| r.strip_prefix('#'));
            if let Some(target) = target.and_then(|t| SCHEMA.pointer(t)) {
                part = target;
            } else if part["anyOf"][1]["type"] == "null" {
                part = &part["anyOf"][0];
            } else {
                return Self { part, about };
            }
        }
    }

    fn list(self, keyword: &str) -> impl Iterator<Item = &'static Value> {
        self.part[keyword].as_array().into_iter().flatten()
    }

    /// The one of its alternatives, mostly the only one, that has a type.
    pub fn of_type(self, wanted: &str) -> Option<Self> {
        let one_of_them = self.list("anyOf").map(Self::of);
        let mut all = one_of_them.chain([self]);
        all.find(|e| e.part["type"] == wanted || e.part["type"][0] == wanted)
    }

    /// Whether `null` can stand here.
    pub fn takes_null(field: &Value) -> bool {
        field["type"][1] == "null" || field["anyOf"][1]["type"] == "null"
    }

    /// Field of an object, or the entry that has any name, and whether `null` can stand there.
    pub fn field(self, key: &str) -> Option<(Self, bool)> {
        let other = &self.part["additionalProperties"];
        let field = self.part["properties"].get(key);
        let field = field.or_else(|| Some(other).filter(|o| o.is_object()))?;
        Some((Self::of(field), Self::takes_null(field)))
    }

    /// Names of all fields of an object.
    pub fn fields(self) -> Vec<&'static str> {
        let all = self.part["properties"].as_object().into_iter().flatten();
        all.map(|(name, _)| name.as_str()).collect()
    }

    /// Names of the fields that an object must have.
    pub fn required(self) -> impl Iterator<Item = &'static str> {
        self.list("required").filter_map(Value::as_str)
    }

    /// Kinds of which one is named as the key of an object, such as `sphere`.
    pub fn kinds(self) -> Vec<&'static str> {
        let kinds = self.list("oneOf");
        kinds
            .filter_map(|kind| kind["required"][0].as_str())
            .collect()
    }

    /// What stands behind the key of a kind.
    pub fn kind(self, name: &str) -> Option<Self> {
        let mut kinds = self.list("oneOf").map(Self::of);
        kinds.find_map(|kind| Some(kind.field(name)?.0))
    }

    /// Words of which one is expected.
    pub fn words(self) -> Vec<&'static str> {
        self.list("oneOf")
            .filter_map(|word| word["const"].as_str())
            .collect()
    }

    /// Elements of a list, and their number if all such lists have the same.
    pub fn items(self) -> Option<(Self, Option<u64>)> {
        let list = self.of_type("array")?;
        Some((
            Self::of(&list.part["items"]),
            list.part["maxItems"].as_u64(),
        ))
    }

    /// Whether it is a list of so many numbers.
    pub fn has_numbers(self, count: u64) -> bool {
        self.items()
            .is_some_and(|(item, n)| n == Some(count) && item.of_type("number").is_some())
    }

    /// The smallest and the largest number, if it is a whole one.
    pub fn whole(self) -> Option<[i128; 2]> {
        let whole = self.of_type("integer")?;
        Some(match whole.part["format"].as_str() {
            Some("uint32") => [0, u32::MAX.into()],
            Some("int32") => [i32::MIN.into(), i32::MAX.into()],
            _ => [0, u64::MAX.into()],
        })
    }

    /// Example of it; objects inside are left out where it is the `inner` part of one.
    pub fn example(self, inner: bool) -> String {
        let object = |this: Self| {
            let field = |name| {
                this.field(name)
                    .map_or(String::new(), |(f, _)| f.example(true))
            };
            let fields = this
                .required()
                .map(|name| format!("\"{name}\": {}", field(name)));
            format!("{{{}}}", fields.collect::<Vec<_>>().join(", "))
        };
        let (kinds, words) = (self.kinds(), self.words());
        if let Some(kind) = kinds.first() {
            self.example_of(kind, inner)
        } else if let Some(word) = words.first() {
            format!("\"{word}\"")
        } else if self.of_type("number").or(self.of_type("integer")).is_some() {
            "1".to_owned()
        } else if self.of_type("string").is_some() {
            "\"...\"".to_owned()
        } else if let Some((item, length)) = self.items() {
            match length {
                Some(3) if std::ptr::eq(self.part, &raw const SCHEMA["$defs"]["Rgb"]) => {
                    "[r, g, b]".to_owned()
                }
                Some(3) if self.has_numbers(3) => "[x, y, z]".to_owned(),
                Some(length) => {
                    format!("[{}]", vec![item.example(true); length as usize].join(", "))
                }
                None => format!("[{}, ...]", item.example(true)),
            }
        } else if inner || self.required().next().is_none() {
            "{...}".to_owned()
        } else {
            object(self)
        }
    }

    /// Example of a kind, such as `{"sphere": {"name": "...", ...}}`.
    pub fn example_of(self, kind: &str, inner: bool) -> String {
        let fields = self
            .kind(kind)
            .map_or(String::new(), |fields| fields.example(inner));
        format!("{{\"{kind}\": {fields}}}")
    }

    /// Field with an example of its value, and what it is.
    pub fn as_field(self, name: &str) -> String {
        let field = format!("\"{name}\": {}", self.example(false));
        let Some(about) = self.about else {
            return field;
        };
        let about = about
            .split([';', '.'])
            .next()
            .unwrap_or_default()
            .replace('\n', " ");
        let mut letters = about.chars();
        let first = letters.next().map(|c| c.to_ascii_lowercase());
        format!(
            "{field} ({}{})",
            first.unwrap_or_default(),
            letters.as_str()
        )
    }

    /// What is expected, in plain words.
    pub fn in_words(self) -> String {
        let (kinds, words) = (self.kinds(), self.words());
        if !kinds.is_empty() {
            return "an object {...} that names its kind".to_owned();
        }
        if let [word] = &words[..] {
            return format!("\"{word}\"");
        }
        if !words.is_empty() {
            return format!("one of \"{}\"", words.join("\", \""));
        }
        let number = self.of_type("number").map(|_| "a number".to_owned());
        let whole = self.whole().map(|[least, most]| match most {
            most if most > u32::MAX.into() => format!("a whole number from {least} up"),
            most => format!("a whole number from {least} to {most}"),
        });
        let list = self.items().map(|(_, length)| match length {
            Some(length) => format!("a list of length {length}"),
            None => "a list".to_owned(),
        });
        let text = self.of_type("string").map(|_| "a text \"...\"".to_owned());
        let object = self.of_type("object").map(|o| {
            let entries = if o.fields().is_empty() {
                " with a name for each entry"
            } else {
                ""
            };
            format!("an object {{...}}{entries}")
        });
        let all: Vec<String> = [number, whole, list, text, object]
            .into_iter()
            .flatten()
            .collect();
        all.join(" or ")
    }
}
