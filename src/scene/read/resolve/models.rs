//! Models from OBJ files: their parts become objects, their materials those of the scene.

use super::objects::Header;
use super::{Builder, checks};
use crate::scene::read::error::{Place, SceneError};
use crate::scene::read::file::ObjFile;
use crate::scene::read::obj;
use crate::shading::Material;

impl Builder {
    /// Puts in what an OBJ file holds: with a material from the scene file one object, else one for each part.
    pub fn obj(&mut self, file: &ObjFile, header: &Header) -> Result<(), SceneError> {
        let material = match &file.material {
            Some(name) => Some(self.material(name, &header.place)?),
            None => None,
        };
        let place = header.place.key("file");
        let text = self.files.read(&file.file).map_err(|p| place.wrap(p))?;
        let text = text.ok_or_else(|| {
            place.error(
                format!("there is no file `{}`", file.file),
                "check the spelling; the path starts in the folder of the scene file",
            )
        })?;
        let own_materials = material.is_none();
        let (files, warnings) = (&mut self.files, &mut self.warnings);
        let read = obj::parse(&text, &file.file, files, warnings, own_materials)?;

        if let Some(material) = material {
            let mut parts = read.parts.into_iter();
            return parts.try_for_each(|part| self.mesh(header, material, part.mesh));
        }
        let mut numbers = Vec::with_capacity(read.materials.len());
        for found in read.materials {
            numbers.push(self.own_material(found, &header.name, &header.place)?);
        }
        let triangles = read.parts.iter().map(|part| part.mesh.triangles.len());
        let (parts, triangles) = (read.parts.len(), triangles.sum());
        self.expect(parts, triangles, &header.place)?;
        let several = parts > 1;
        for (i, part) in read.parts.into_iter().enumerate() {
            let material = match part.material.and_then(|m| numbers.get(m)) {
                Some(material) => *material,
                None => self.grey(&header.place)?,
            };
            let name = if several {
                self.part_name(&header.name, &part.name, i)
            } else {
                header.name.clone()
            };
            let header = Header {
                name,
                map: header.map,
                place: header.place.clone(),
            };
            self.mesh(&header, material, part.mesh)?;
        }
        Ok(())
    }

    /// A name that no other object has: the part's own, or its number.
    fn part_name(&self, object: &str, part: &str, number: usize) -> String {
        let part = if part.is_empty() { "part" } else { part };
        let name = format!("{object}/{part}");
        if self.names.contains_key(&name) {
            format!("{name}#{number}")
        } else {
            name
        }
    }

    /// A material of an MTL file. If the scene has one of that name already, the object's name goes before it.
    fn own_material(
        &mut self,
        mut material: Material,
        object: &str,
        place: &Place,
    ) -> Result<u32, SceneError> {
        let known = |name: &str| self.known_materials.contains_key(name);
        if known(&material.name) {
            material.name = format!("{object}/{}", material.name);
        }
        let number = self.scene.materials.len();
        if known(&material.name) {
            material.name = format!("{}#{number}", material.name);
        }
        checks::name(&material.name, place)?;
        Ok(self.add_material(material))
    }

    /// The material of what has none.
    fn grey(&mut self, place: &Place) -> Result<u32, SceneError> {
        let name = "grey (no material given)";
        if let Some(&number) = self.known_materials.get(name) {
            return Ok(number);
        }
        let grey = obj::default_material(name);
        self.own_material(grey, "", place)
    }
}
