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
    pub fn add_objects<'f>(
        &mut self,
        objects: &'f [ObjectFile],
        group: &Group<'f>,
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

    fn add_object<'f>(
        &mut self,
        object: &'f ObjectFile,
        group: &Group<'f>,
        path: &FieldPath,
    ) -> Result<(), SceneError> {
        let common = object.common();
        let path = path.key(common.kind);
        self.count_placed(group, &path)?;
        check::rotations(common.transform, &path, &mut self.warnings);
        // A mesh that is kept was checked where it was first used.
        let is_known = matches!(object, ObjectFile::Mesh(_)) && self.kept.has_mesh(&path);
        let own = if is_known {
            None
        } else {
            surface(object, &path)?
        };
        let header = Header::new(&common, group, path)?;
        let own_material = match common.material {
            Some(name) => Some(self.material(name, &header.path)?),
            None => None,
        };
        let material = group.material.or(own_material);
        let own = match material.filter(|_| is_known) {
            Some(material) if self.use_again(&header, material, 0)? => return Ok(()),
            Some(_) => surface(object, &header.path)?,
            None => own,
        };
        match (object, own, material) {
            (ObjectFile::Group(file), ..) => {
                let inner = self.inner(&header, &file.transform, group);
                self.add_objects(&file.objects, &inner, &header.path.key("objects"))
            }
            (ObjectFile::Use(file), ..) => self.add_use(file, material, &header, group),
            (ObjectFile::Bezier(file), _, Some(material)) => {
                self.add_bezier(file, material, &header)
            }
            (ObjectFile::Nurbs(file), _, Some(material)) => self.add_nurbs(file, material, &header),
            (ObjectFile::Csg(file), _, Some(material)) => self.add_csg(file, material, &header),
            (ObjectFile::Obj(file), _, material) => self.add_model(&file.file, material, &header),
            (_, Some(LocalSurface::Mesh(mesh, faces)), Some(material)) => {
                self.add_faces(&header, material, mesh, &faces)
            }
            (_, Some(LocalSurface::Polygon(loops, data)), Some(material)) => {
                self.add_polygon(&header, material, (loops, data))
            }
            (_, Some(LocalSurface::Shape(shape)), Some(material)) => {
                let shape = in_world(shape, header.to_world.as_ref());
                self.begin(&header, material)?;
                self.add_shape(shape, &header.path)
            }
            // Only models, groups and uses are without a surface or a material of their own.
            _ => Ok(()),
        }
    }
}
