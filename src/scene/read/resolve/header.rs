//! Name and transform of an object, with those of the groups that it stands in.

use super::checks;
use super::transform::to_world;
use crate::math::Transform;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::Common;

/// Group that objects stand in.
#[derive(Clone, Debug, Default)]
pub struct Group {
    /// What the names of its objects begin with.
    pub prefix: String,
    /// The transform of all of them into the world.
    pub to_world: Option<Transform>,
    /// How many groups it stands in, itself counted.
    pub depth: usize,
}

/// Object whose name and transform are known.
pub struct Header<'a> {
    /// Its name with those of its groups.
    pub name: String,
    /// Its transform into the world.
    pub to_world: Option<Transform>,
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
            path,
        })
    }
}
