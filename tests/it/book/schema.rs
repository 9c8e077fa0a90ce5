//! A JSON Schema of the program as the book shows it: types, their fields, and words.

use serde_json::Value;

/// A type of the schema.
pub struct Described {
    /// Its name in the schema.
    pub name: String,
    /// What it is.
    pub doc: String,
    /// Its fields; of a choice of objects those of all.
    pub fields: Vec<Field>,
    /// The words that it may be, each with what it means.
    pub words: Vec<(String, String)>,
}

/// A field of a type.
pub struct Field {
    pub name: String,
    pub doc: String,
    pub required: bool,
    /// What it is if it is left out, as JSON.
    pub default: Option<String>,
    pub schema: Value,
}

/// The schema of a format of the program.
pub struct Schema {
    pub whole: Value,
    pub types: Vec<Described>,
}

impl Schema {
    /// The schema that `raytree schema FORMAT` prints.
    pub fn of(format: &str) -> Self {
        let whole: Value =
            serde_json::from_str(&super::printed(&["schema", format])).expect("JSON");
        let defs = whole["$defs"].as_object().expect("types");
        let root = described(whole["title"].as_str().expect("a title"), &whole);
        let types =
            std::iter::once(root).chain(defs.iter().map(|(name, value)| described(name, value)));
        Self {
            types: types.collect(),
            whole,
        }
    }

    /// A type by its name.
    pub fn named(&self, name: &str) -> &Described {
        self.types
            .iter()
            .find(|t| t.name == name)
            .unwrap_or_else(|| panic!("there is no type {name}"))
    }

    /// The type with fields, or of words, that a value of a schema is or has in it.
    pub fn within<'a>(&'a self, schema: &'a Value) -> Option<&'a Described> {
        let options = schema["anyOf"]
            .as_array()
            .map_or([].as_slice(), Vec::as_slice);
        let mut near = vec![schema, &schema["items"], &schema["additionalProperties"]];
        near.extend(options);
        let name = near
            .iter()
            .find_map(|s| s["$ref"].as_str()?.strip_prefix("#/$defs/"))?;
        Some(self.named(name)).filter(|t| !t.fields.is_empty() || !t.words.is_empty())
    }

    /// Why a value does not fit a schema of this one.
    pub fn refuses(&self, schema: &Value, value: &Value) -> Option<String> {
        let mut schema = schema.clone();
        schema["$defs"] = self.whole["$defs"].clone();
        let validator = jsonschema::validator_for(&schema).expect("a schema");
        validator
            .validate(value)
            .err()
            .map(|error| error.to_string())
    }
}

fn text(value: &Value) -> String {
    super::made::cell(value.as_str().unwrap_or_default())
}

fn described(name: &str, schema: &Value) -> Described {
    let mut fields = fields_of(schema);
    let options = ["oneOf", "anyOf"]
        .iter()
        .filter_map(|key| schema[*key].as_array())
        .flatten();
    for option in options {
        for mut field in fields_of(option) {
            field.required = false;
            if field.doc.is_empty() {
                field.doc = text(&option["description"]);
            }
            if !fields.iter().any(|known: &Field| known.name == field.name) {
                fields.push(field);
            }
        }
    }
    Described {
        name: name.to_owned(),
        doc: text(&schema["description"]),
        fields,
        words: words_of(schema),
    }
}

fn fields_of(schema: &Value) -> Vec<Field> {
    let empty = serde_json::Map::new();
    let properties = schema["properties"].as_object().unwrap_or(&empty);
    let required = schema["required"].as_array();
    let field = |(name, schema): (&String, &Value)| Field {
        name: name.clone(),
        doc: text(&schema["description"]),
        required: required.is_some_and(|names| names.iter().any(|n| n == name)),
        default: schema.get("default").map(default),
        schema: schema.clone(),
    };
    properties.iter().map(field).collect()
}

/// A default value, without what is null in it.
fn default(value: &Value) -> String {
    let mut value = value.clone();
    if let Some(object) = value.as_object_mut() {
        object.retain(|_, value| !value.is_null());
    }
    value.to_string().replace(".0", "")
}

/// The words of a choice of words.
pub fn words_of(schema: &Value) -> Vec<(String, String)> {
    let inner = schema["anyOf"].as_array().into_iter().flatten();
    let options = std::iter::once(schema)
        .chain(inner)
        .filter_map(|s| s["oneOf"].as_array())
        .flatten();
    let word = |option: &Value| {
        Some((
            option["const"].as_str()?.to_owned(),
            text(&option["description"]),
        ))
    };
    options.filter_map(word).collect()
}
