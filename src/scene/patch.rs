//! Changes of a scene file: a merge patch (RFC 7396) in which lights and objects stand by their names, as materials do.
//!
//! A patch changes fields of what is there. It adds nothing, removes nothing and renames nothing, so that every name in it means
//! the same before and after.

mod between;
mod flags;
mod merge;
mod number;
mod section;
#[cfg(test)]
mod tests;
mod typed;

use std::collections::HashMap;
use std::io::Read as _;
use std::path::Path;

use serde_json::{Map, Value};

use super::FileId;
use super::limits::MAX_PATCH_BYTES;
use super::printable::printable;
use super::read::error::{Problem, SceneError};
use super::read::files::regular;
use merge::merge;
use section::{Element, Section, elements, unknown};

/// Changes by section of the scene file, name (where a section has names) and field.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Patch(Map<String, Value>);

impl Patch {
    /// Reads the text of a patch. Whether a scene has what it changes is asked by [`Patch::apply`].
    pub fn from_json(text: &str) -> Result<Self, Problem> {
        if text.len() > MAX_PATCH_BYTES {
            return Err(too_long());
        }
        let read = serde_json::from_str(text);
        let patch = read.map(Self).map_err(|error| {
            Problem::new(
                format!("this is no patch: {error}"),
                "a patch is one object, such as {\"materials\": {\"glass\": {\"ior\": 1.3}}}",
            )
        })?;
        patch.check_sections().map(|()| patch)
    }

    /// Reads the patch in a file, and tells which file that is.
    pub fn read(path: &Path) -> Result<(Self, Option<FileId>), SceneError> {
        let shown = path.display().to_string();
        let read = || {
            let (file, _) = regular(path, ".json")?;
            let id = FileId::of(&file, path).ok();
            let mut bytes = Vec::new();
            // One byte more than it may have.
            let read = file
                .take(MAX_PATCH_BYTES as u64 + 1)
                .read_to_end(&mut bytes);
            read.map_err(|error| {
                Problem::new(format!("it cannot be read: {error}"), "check the file")
            })?;
            let text = String::from_utf8_lossy(&bytes);
            Ok((Self::from_json(&text)?, id))
        };
        read().map_err(|problem: Problem| problem.in_file(&shown))
    }

    /// One change as it is typed, such as `material.glass.ior=1.3`, to what the JSON of `scene` has now.
    pub fn typed(text: &str, scene: &Value) -> Result<Self, Problem> {
        typed::typed(text, scene).map(Self)
    }

    /// The changes that lead from one scene file's JSON to another's. Both have the same things in the same order.
    pub fn between(before: &Value, after: &Value) -> Result<Self, Problem> {
        let patch = Self(between::between(before, after));
        if patch.to_json().len() > MAX_PATCH_BYTES {
            return Err(too_long());
        }
        Ok(patch)
    }

    /// True if it changes nothing.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many values it changes.
    pub fn count(&self) -> usize {
        flags::count(&self.0)
    }

    /// The text of a file of it.
    pub fn to_json(&self) -> String {
        number::lines(&self.0, 0) + "\n"
    }

    /// Its changes as the values of `--change`; `scene` is the JSON of what it changes.
    pub fn flags(&self, scene: &Value) -> Vec<String> {
        flags::flags(&self.0, scene)
    }

    /// Changes the JSON of a scene file. What the new values mean is asked by the reader.
    pub fn apply(&self, scene: &mut Value) -> Result<(), Problem> {
        self.check_sections()?;
        for section in Section::ALL {
            let Some(change) = self.0.get(section.key()) else {
                continue;
            };
            if !section.has_names() {
                section.check_fields(section.singular(), change)?;
                merge(&mut scene[section.key()], change);
                continue;
            }
            let Value::Object(named) = change else {
                return Err(Problem::new(
                    format!("`{}` is no object {{...}} in the patch", section.key()),
                    format!(
                        "write \"{}\": {{\"NAME\": {{\"FIELD\": VALUE}}}}",
                        section.key()
                    ),
                ));
            };
            let known = elements(scene, section);
            let by_name: HashMap<&str, &Element> = known
                .iter()
                .map(|element| (element.name.as_str(), element))
                .collect();
            for (name, fields) in named {
                let found = by_name.get(name.as_str());
                let found = found.ok_or_else(|| unknown(section, name, &known, scene))?;
                section.check_fields(name, fields)?;
                if let Some(place) = scene.pointer_mut(&found.pointer) {
                    merge(place, fields);
                }
            }
        }
        Ok(())
    }

    fn check_sections(&self) -> Result<(), Problem> {
        let is_known = |key: &String| Section::ALL.iter().any(|section| section.key() == key);
        match self.0.keys().find(|key| !is_known(key)) {
            Some(key) if key == "settings" => Err(Problem::new(
                "a patch has no settings",
                "give them by their flags, such as --samples 16",
            )),
            Some(key) => Err(Problem::new(
                format!("a patch has no `{}`", printable(key)),
                Section::cure(key),
            )),
            None => Ok(()),
        }
    }
}

fn too_long() -> Problem {
    Problem::new(
        format!("the changes have more than {MAX_PATCH_BYTES} bytes"),
        "change the scene file itself",
    )
}

/// The JSON of a scene file; what is null there is left out.
pub fn json_of(file: &impl serde::Serialize) -> serde_json::Result<Value> {
    let mut json = serde_json::to_value(file)?;
    merge::without_nulls(&mut json);
    Ok(json)
}
