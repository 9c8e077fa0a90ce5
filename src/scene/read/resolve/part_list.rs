//! Parts of a scene file by their names, and which of them were used.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use super::checks;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{ObjectFile, UseFile};
use crate::scene::warning::{WarningCode, Warnings};

/// Parts of a scene file.
pub struct PartList<'f> {
    objects: &'f BTreeMap<String, Vec<ObjectFile>>,
    /// Their path in the file.
    pub path: FieldPath<'f>,
    used: RefCell<BTreeSet<&'f str>>,
}

impl<'f> PartList<'f> {
    /// The parts of a file; `path` is theirs.
    pub fn new(
        objects: &'f BTreeMap<String, Vec<ObjectFile>>,
        path: FieldPath<'f>,
    ) -> Result<Self, SceneError> {
        for name in objects.keys() {
            checks::name(name, &path.key(name))?;
        }
        Ok(Self {
            objects,
            path,
            used: RefCell::default(),
        })
    }

    /// The part that a use names, and its name as the file has it.
    pub fn get(
        &self,
        file: &UseFile,
        path: &FieldPath,
    ) -> Result<(&'f str, &'f [ObjectFile]), SceneError> {
        if let Some((name, objects)) = self.objects.get_key_value(&file.part) {
            self.used.borrow_mut().insert(name);
            return Ok((name, objects));
        }
        let names = || self.objects.keys().map(String::as_str);
        let listed = names().take(12).collect::<Vec<_>>().join(", ");
        let cure = match did_you_mean(&file.part, names()) {
            Some(near) => format!("did you mean `{near}`? There are: {listed}"),
            None if listed.is_empty() => {
                format!("describe it: \"parts\": {{\"{}\": [...]}}", file.part)
            }
            None => format!("describe it under \"parts\", or use one of: {listed}"),
        };
        let path = path.key("part");
        Err(path.error(format!("there is no part `{}`", file.part), cure))
    }

    /// Warns of parts that nothing uses: what is in them is not looked at.
    pub fn warn_of_unused(&self, warnings: &mut Warnings) {
        let used = self.used.borrow();
        for name in self.objects.keys().filter(|n| !used.contains(n.as_str())) {
            let what = format!("nothing uses the part `{name}`, so that it is not seen or checked");
            let cure = format!("use it: {{\"use\": {{\"name\": \"...\", \"part\": \"{name}\"}}}}");
            let path = self.path.key(name);
            warnings.add(WarningCode::UnusedPart, path.error(what, cure));
        }
    }
}
