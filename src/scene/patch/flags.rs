//! A patch as values of `--change`, one for each value that it changes.

use std::collections::BTreeSet;

use serde_json::{Map, Value};

use super::number::written;
use super::section::{Section, elements};

/// All changes, such as `material.glass.ior=1.3`.
pub fn flags(patch: &Map<String, Value>, scene: &Value) -> Vec<String> {
    let mut flags = Vec::new();
    for section in Section::ALL {
        let Some(change) = patch.get(section.key()) else {
            continue;
        };
        match change {
            Value::Object(named) if section.has_names() => {
                let known = elements(scene, section).into_iter();
                let known: BTreeSet<String> = known.map(|element| element.name).collect();
                for (name, fields) in named {
                    let path = format!("{}.{}", section.singular(), word(name, &known));
                    leaves(&path, fields, &mut flags);
                }
            }
            _ => leaves(section.singular(), change, &mut flags),
        }
    }
    flags
}

/// How many values are changed.
pub fn count(patch: &Map<String, Value>) -> usize {
    let of = |value: &Value| match value {
        Value::Object(fields) => count(fields),
        _ => 1,
    };
    patch.values().map(of).sum()
}

/// Adds the changes below a path.
fn leaves(path: &str, value: &Value, flags: &mut Vec<String>) {
    match value {
        Value::Object(fields) if !fields.is_empty() => {
            for (name, value) in fields {
                leaves(&format!("{path}.{name}"), value, flags);
            }
        }
        _ => flags.push(format!("{path}={}", written(value))),
    }
}

/// A name as it stands in a path: in quotation marks where it would be read as another one.
fn word(name: &str, known: &BTreeSet<String>) -> String {
    let is_plain = name
        .chars()
        .all(|c| c.is_alphanumeric() || "_-/# ".contains(c));
    let dotted = format!("{name}.");
    let longer = known.range(dotted.clone()..).next();
    if is_plain && !longer.is_some_and(|longer| longer.starts_with(&dotted)) {
        return name.to_owned();
    }
    Value::from(name).to_string()
}
