//! Objects that use parts of the scene file: a part is resolved once for each use, in the frame of the use.

use super::header::{Group, Header};
use super::resolver::Resolver;
use crate::scene::ObjectFrame;
use crate::scene::limits::MAX_PLACED;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{TransformStep, UseFile};

impl Resolver {
    /// Adds the objects of a part where a use places it. `material` is that of the use.
    pub fn add_use<'f>(
        &mut self,
        file: &'f UseFile,
        material: Option<u32>,
        header: &Header,
        group: &Group<'f>,
    ) -> Result<(), SceneError> {
        let (part, objects) = group.parts.get(file, &header.path)?;
        if group.inside.contains(&part) {
            let chain: Vec<&str> = group.inside.iter().copied().chain([part]).collect();
            let what = format!("the part `{part}` uses itself: {}", chain.join(" uses "));
            let cure = "take the use out of the part";
            return Err(header.path.key("part").error(what, cure));
        }
        let mut inner = self.inner(header, &file.transform, group);
        inner.material = material;
        inner.inside.push(part);
        self.add_objects(objects, &inner, &group.parts.path.key(part))
    }

    /// The group that stands in a group, with its frame.
    pub fn inner<'f>(
        &mut self,
        header: &Header,
        steps: &[TransformStep],
        group: &Group<'f>,
    ) -> Group<'f> {
        let placed: Vec<String> = steps.iter().map(TransformStep::to_string).collect();
        self.scene.frames.push(ObjectFrame {
            name: header.name.clone(),
            placed: placed.join(", then "),
            to_world: header.to_world,
            outer: group.frame,
        });
        Group {
            prefix: format!("{}/", header.name),
            to_world: header.to_world,
            depth: group.depth + 1,
            frame: Some(self.scene.frames.len() as u32 - 1),
            material: group.material,
            parts: group.parts,
            inside: group.inside.clone(),
        }
    }

    /// Counts one more object or group of a part.
    pub fn count_placed(&mut self, group: &Group, path: &FieldPath) -> Result<(), SceneError> {
        self.placed += usize::from(!group.inside.is_empty());
        if self.placed <= MAX_PLACED {
            return Ok(());
        }
        Err(path.error(
            format!("the uses of parts place more than {MAX_PLACED} objects and groups"),
            "use parts less often, or parts of fewer objects",
        ))
    }
}
