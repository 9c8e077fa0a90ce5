//! Name and transform of an object, with those of the groups that it stands in.

use super::checks;
use super::part_list::PartList;
use super::transform::to_world;
use crate::math::Transform;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::Common;
use crate::shading::ShadingModel;

/// Group that objects stand in, or use of a part.
#[derive(Clone)]
pub struct Group<'f> {
    /// What the names of its objects begin with.
    pub prefix: String,
    /// The transform of all of them into the world.
    pub to_world: Option<Transform>,
    /// How many groups it stands in, itself counted.
    pub depth: usize,
    /// Index of its frame; `None` for the world.
    pub frame: Option<u32>,
    /// The material that takes the place of those of its objects.
    pub material: Option<u32>,
    /// The parts of the file.
    pub parts: &'f PartList<'f>,
    /// The names of the parts that it stands in.
    pub inside: Vec<&'f str>,
}

impl<'f> Group<'f> {
    /// What stands in no group.
    pub fn world(parts: &'f PartList<'f>) -> Self {
        Self {
            prefix: String::new(),
            to_world: None,
            depth: 0,
            frame: None,
            material: None,
            parts,
            inside: Vec::new(),
        }
    }
}

/// Object whose name and transform are known.
pub struct Header<'a> {
    /// Its name with those of its groups.
    pub name: String,
    /// Its transform into the world.
    pub to_world: Option<Transform>,
    /// Index of the frame of its group.
    pub frame: Option<u32>,
    /// The material that takes the place of its own.
    pub material: Option<u32>,
    /// How it is shaded, if it says so.
    pub shading: Option<ShadingModel>,
    /// True if it stands in a part.
    pub in_part: bool,
    /// Its path in the file.
    pub path: FieldPath<'a>,
}

impl<'a> Header<'a> {
    /// Header of an object in a group.
    pub fn new(object: &Common, group: &Group, path: FieldPath<'a>) -> Result<Self, SceneError> {
        checks::name(object.name, &path.key("name"))?;
        Ok(Self {
            name: format!("{}{}", group.prefix, object.name),
            to_world: to_world(object.transform, group.to_world.as_ref(), &path)?,
            frame: group.frame,
            material: group.material,
            shading: object.shading,
            in_part: !group.inside.is_empty(),
            path,
        })
    }
}
