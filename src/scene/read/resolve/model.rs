//! Models of OBJ files: their parts become objects, their materials are added to those of the scene.

use std::rc::Rc;

use super::checks;
use super::header::Header;
use super::resolver::Resolver;
use crate::scene::check;
use crate::scene::limits::MAX_NAME_BYTES;
use crate::scene::read::error::SceneError;
use crate::scene::read::mesh::Mesh;
use crate::scene::read::obj::{self, Obj};
use crate::scene::warning::WarningCode;
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
        let mut read = self.read_model(file, material.is_none(), header)?;
        let mut own = Vec::with_capacity(read.materials.len());
        for found in &read.materials {
            own.push(self.own_material(found.clone(), header)?);
        }
        let mut materials = Vec::with_capacity(read.parts.len());
        for part in &read.parts {
            let of_part = part.material.and_then(|m| own.get(m)).copied();
            materials.push(match material.or(of_part) {
                Some(material) => material,
                None => self.grey(header)?,
            });
        }
        let parts = read.parts.iter().zip(&materials);
        let in_world = parts
            .map(|(part, material)| (part.mesh.triangles.len(), *material))
            .filter(|(count, material)| !self.keeps(header, *material, *count));
        let triangles = in_world.map(|(count, _)| count).sum();
        self.reserve(read.parts.len(), triangles, &header.path)?;
        let several = read.parts.len() > 1;
        // Number 0 is the whole model, where all of it has one material.
        let first = usize::from(material.is_none());
        let mut placed = None;
        for (i, material) in materials.into_iter().enumerate() {
            let name = if several {
                self.part_name(header, &read.parts[i].name, i)
            } else {
                header.name.clone()
            };
            let header = Header {
                name,
                path: header.path.clone(),
                ..*header
            };
            if self.use_again(&header, material, first + i)? {
                continue;
            }
            let mut mesh = part_mesh(&mut read, i);
            if self.keeps(&header, material, mesh.triangles.len()) {
                let local = mesh.sharing(&read.shared);
                match self.keep(&header, material, (first + i, local))? {
                    Some(few) => mesh = few,
                    None => continue,
                }
            }
            let placed = placed.get_or_insert_with(|| shared_in_world(&mut read, &header));
            self.add_placed(&header, material, mesh.sharing(placed))?;
        }
        Ok(())
    }

    /// What an OBJ file holds. That of a part is read once, however often the part is used.
    fn read_model(
        &mut self,
        file: &str,
        own_materials: bool,
        header: &Header,
    ) -> Result<Rc<Obj>, SceneError> {
        let key = (header.path.text().to_owned(), own_materials);
        if let Some(read) = self.kept.models.get(&key) {
            return Ok(Rc::clone(read));
        }
        let path = header.path.key("file");
        let text = self.files.read_model(file).map_err(|p| path.wrap(p))?;
        let text = text.ok_or_else(|| {
            path.error(
                format!("there is no file `{file}`"),
                "check the spelling; the path starts in the folder of the scene file",
            )
        })?;
        let (files, warnings) = (&mut self.files, &mut self.warnings);
        let read = obj::parse(text, file, files, warnings, own_materials)?;
        let read = Rc::new(read);
        if header.in_part {
            self.kept.models.insert(key, Rc::clone(&read));
        }
        Ok(read)
    }

    /// Name for a part of a model that no other object has: its own, or one with its index.
    fn part_name(&mut self, object: &Header, part: &str, index: usize) -> String {
        let part = if part.is_empty() { "part" } else { part };
        let name = format!("{}/{}", object.name, self.plain(part, object));
        let numbered = (index..).map(|index| format!("{name}#{index}"));
        let mut all = std::iter::once(name.clone()).chain(numbered);
        all.find(|name| !self.objects.contains_key(name))
            .unwrap_or(name)
    }

    /// A name of a model as it can be shown after that of its object: not endless, and without control characters.
    fn plain(&mut self, name: &str, object: &Header) -> String {
        let most = MAX_NAME_BYTES.saturating_sub(object.name.len() + 12).max(8);
        let mut plain = String::new();
        for letter in name
            .chars()
            .map(|c| if c.is_control() { '\u{fffd}' } else { c })
        {
            if plain.len() + letter.len_utf8() > most {
                break;
            }
            plain.push(letter);
        }
        if plain != name {
            let what =
                "a name in the model is too long or has control characters: it is shown changed";
            let cure = format!(
                "write short names, such as `{}`",
                plain.chars().take(12).collect::<String>()
            );
            self.warnings
                .add(WarningCode::ChangedName, object.path.error(what, cure));
        }
        plain
    }

    /// A material of an MTL file. If the scene has one of that name already, the object's name goes before it.
    fn own_material(&mut self, mut material: Material, object: &Header) -> Result<u32, SceneError> {
        material.name = self.plain(&material.name, object);
        if self.materials.contains_key(&material.name) {
            material.name = format!("{}/{}", object.name, material.name);
        }
        let name = material.name.clone();
        let mut index = self.scene.materials.len();
        while self.materials.contains_key(&material.name) {
            material.name = format!("{name}#{index}");
            index += 1;
        }
        checks::name(&material.name, &object.path)?;
        check::material(&material, &object.path, &mut self.warnings);
        Ok(self.add_material(material))
    }

    /// Index of the grey material for parts without one.
    fn grey(&mut self, object: &Header) -> Result<u32, SceneError> {
        let name = "grey (no material given)";
        if let Some(&index) = self.materials.get(name) {
            return Ok(index);
        }
        self.own_material(obj::default_material(name), object)
    }
}

/// The mesh of a part of a model; a copy, if the model is needed again.
fn part_mesh(read: &mut Rc<Obj>, part: usize) -> Mesh {
    match Rc::get_mut(read) {
        Some(own) => std::mem::take(&mut own.parts[part].mesh),
        None => read.parts[part].mesh.clone(),
    }
}

/// What all parts of a model share, in the world.
fn shared_in_world(read: &mut Rc<Obj>, header: &Header) -> Mesh {
    let mut shared = match Rc::get_mut(read) {
        Some(own) => std::mem::take(&mut own.shared),
        None => read.shared.clone(),
    };
    if let Some(map) = &header.to_world {
        shared.place(map);
    }
    shared
}
