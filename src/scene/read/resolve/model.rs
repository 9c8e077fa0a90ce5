//! Models of OBJ files: their parts become objects, their materials are added to those of the scene.

use super::checks;
use super::header::Header;
use super::resolver::Resolver;
use crate::scene::check;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::obj;
use crate::shading::Material;

impl Resolver {
    /// Adds what an OBJ file holds: one object of `material`, if the scene file names one, else an object for each part
    /// of the model, in the materials of its MTL files.
    pub fn add_model(
        &mut self,
        file: &str,
        material: Option<u32>,
        header: &Header,
    ) -> Result<(), SceneError> {
        let path = header.path.key("file");
        let text = self.files.read(file).map_err(|p| path.wrap(p))?;
        let text = text.ok_or_else(|| {
            path.error(
                format!("there is no file `{file}`"),
                "check the spelling; the path starts in the folder of the scene file",
            )
        })?;
        let own_materials = material.is_none();
        let (files, warnings) = (&mut self.files, &mut self.warnings);
        let read = obj::parse(&text, file, files, warnings, own_materials)?;

        if let Some(material) = material {
            let mut parts = read.parts.into_iter();
            return parts.try_for_each(|part| self.add_mesh(header, material, part.mesh));
        }
        let mut materials = Vec::with_capacity(read.materials.len());
        for found in read.materials {
            materials.push(self.own_material(found, &header.name, &header.path)?);
        }
        let triangles = read.parts.iter().map(|part| part.mesh.triangles.len());
        let (parts, triangles) = (read.parts.len(), triangles.sum());
        self.reserve(parts, triangles, &header.path)?;
        let several = parts > 1;
        for (i, part) in read.parts.into_iter().enumerate() {
            let material = match part.material.and_then(|m| materials.get(m)) {
                Some(material) => *material,
                None => self.grey(&header.path)?,
            };
            let name = if several {
                self.part_name(&header.name, &part.name, i)
            } else {
                header.name.clone()
            };
            let header = Header {
                name,
                to_world: header.to_world,
                path: header.path.clone(),
            };
            self.add_mesh(&header, material, part.mesh)?;
        }
        Ok(())
    }

    /// Name for a part of a model that no other object has: its own, or one with its index.
    fn part_name(&self, object: &str, part: &str, index: usize) -> String {
        let part = if part.is_empty() { "part" } else { part };
        let name = format!("{object}/{part}");
        if self.objects.contains_key(&name) {
            format!("{name}#{index}")
        } else {
            name
        }
    }

    /// A material of an MTL file. If the scene has one of that name already, the object's name goes before it.
    fn own_material(
        &mut self,
        mut material: Material,
        object: &str,
        path: &FieldPath,
    ) -> Result<u32, SceneError> {
        let known = |name: &str| self.materials.contains_key(name);
        if known(&material.name) {
            material.name = format!("{object}/{}", material.name);
        }
        let index = self.scene.materials.len();
        if known(&material.name) {
            material.name = format!("{}#{index}", material.name);
        }
        checks::name(&material.name, path)?;
        check::material(&material, path, &mut self.warnings);
        Ok(self.add_material(material))
    }

    /// Index of the grey material for parts without one.
    fn grey(&mut self, path: &FieldPath) -> Result<u32, SceneError> {
        let name = "grey (no material given)";
        if let Some(&index) = self.materials.get(name) {
            return Ok(index);
        }
        let grey = obj::default_material(name);
        self.own_material(grey, "", path)
    }
}
