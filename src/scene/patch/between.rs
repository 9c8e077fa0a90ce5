//! The merge patch that leads from one scene file to another.

use serde_json::{Map, Value};

use super::section::{Section, elements};

/// Changes by section, name and field.
pub fn between(before: &Value, after: &Value) -> Map<String, Value> {
    let mut patch = Map::new();
    for section in Section::ALL {
        let change = if section.has_names() {
            let named = elements(before, section).into_iter().filter_map(|element| {
                let fields = |scene: &Value| scene.pointer(&element.pointer).cloned();
                let change = difference(fields(before), fields(after))?;
                Some((element.name, change))
            });
            let named: Map<String, Value> = named.collect();
            (!named.is_empty()).then_some(Value::Object(named))
        } else {
            let value = |scene: &Value| scene.get(section.key()).cloned();
            difference(value(before), value(after))
        };
        patch.extend(change.map(|change| (section.key().to_owned(), change)));
    }
    patch
}

/// The patch that makes one value another; `None` if they are the same. Null takes a field away.
fn difference(before: Option<Value>, after: Option<Value>) -> Option<Value> {
    match (before, after) {
        (before, after) if before == after => None,
        (Some(Value::Object(mut before)), Some(Value::Object(after))) => {
            let mut changes = Map::new();
            for (name, value) in after {
                let change = difference(before.remove(&name), Some(value));
                changes.extend(change.map(|change| (name, change)));
            }
            // What is left is there no more. The parts of a group are told by themselves.
            changes.extend(before.into_iter().map(|(name, _)| (name, Value::Null)));
            changes.remove("objects");
            (!changes.is_empty()).then_some(Value::Object(changes))
        }
        (_, after) => after.or(Some(Value::Null)),
    }
}
