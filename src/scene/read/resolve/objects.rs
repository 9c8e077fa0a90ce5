//! Objects of a scene file, and groups of them: their names, materials and shapes in the world.

use super::header::{Group, Header};
use super::resolver::Resolver;
use super::shapes::in_world;
use super::surface::{LocalSurface, surface};
use crate::scene::check;
use crate::scene::limits::MAX_GROUP_DEPTH;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::ObjectFile;

impl Resolver {
    /// Adds the objects of a group, or all of the file.
    pub fn add_objects(
        &mut self,
        objects: &[ObjectFile],
        group: &Group,
        path: &FieldPath,
    ) -> Result<(), SceneError> {
        if group.depth > MAX_GROUP_DEPTH {
            return Err(path.error(
                format!("groups are nested more than {MAX_GROUP_DEPTH} deep"),
                "put the objects of an inner group into an outer one",
            ));
        }
        for (i, object) in objects.iter().enumerate() {
            self.add_object(object, group, &path.index(i))?;
        }
        Ok(())
    }

    fn add_object(
        &mut self,
        object: &ObjectFile,
        group: &Group,
        path: &FieldPath,
    ) -> Result<(), SceneError> {
        let common = object.common();
        let path = path.key(common.kind);
        check::rotations(common.transform, &path, &mut self.warnings);
        let own = surface(object, &path)?;
        let header = Header::new(&common, group, path)?;
        let material = match common.material {
            Some(name) => Some(self.material(name, &header.path)?),
            None => None,
        };
        match (object, own, material) {
            (ObjectFile::Group(file), ..) => {
                let inner = Group {
                    prefix: format!("{}/", header.name),
                    to_world: header.to_world,
                    depth: group.depth + 1,
                };
                self.add_objects(&file.objects, &inner, &header.path.key("objects"))
            }
            (ObjectFile::Obj(file), _, material) => self.add_model(&file.file, material, &header),
            (_, Some(LocalSurface::Mesh(mesh)), Some(material)) => {
                self.add_mesh(&header, material, mesh)
            }
            (_, Some(LocalSurface::Shape(shape)), Some(material)) => {
                let shape = in_world(shape, header.to_world.as_ref());
                self.begin(&header.name, material, &header.path)?;
                self.add_shape(shape, &header.path)
            }
            // Only models and groups are without a surface or a material of their own.
            _ => Ok(()),
        }
    }
}
