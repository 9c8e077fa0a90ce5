//! Meshes from OBJ files, with the materials of their MTL files.

mod faces;
mod mtl;
mod parts;
mod polygon;
mod surface;
mod vertices;
mod words;

use std::collections::{HashMap, HashSet};

use faces::{Faces, Mark};

use super::error::{Problem, SceneError};
use super::files::Files;
use super::limits::MAX_PRIMITIVES;
use super::mesh::Mesh;
use crate::shading::Material;

/// What an OBJ file holds.
#[derive(Debug)]
pub struct Obj {
    /// Its parts: each has a name and at most one material.
    pub parts: Vec<Part>,
    /// The materials that its MTL files describe.
    pub materials: Vec<Material>,
    /// What was strange.
    pub warnings: Vec<String>,
}

/// A part of an OBJ file.
#[derive(Debug)]
pub struct Part {
    /// The name after `o` or `g`; empty if there is none.
    pub name: String,
    /// Index into the file's materials.
    pub material: Option<usize>,
    /// Its surface.
    pub mesh: Mesh,
}

/// The material of what names none: a matt grey.
pub fn default_material(name: &str) -> Material {
    mtl::matt_grey(name)
}

/// Reads an OBJ file from its text. `name` is its path from the scene's folder; the MTL files that it names are read
/// through `files`, unless `own_materials` is false: then they are not needed.
pub fn parse(
    text: &str,
    name: &str,
    files: &mut Files,
    own_materials: bool,
) -> Result<Obj, SceneError> {
    let file = &files.label(name);
    let surface = surface::read(text).map_err(|(line, problem)| problem.in_line(file, line))?;
    let triangles = surface.faces.triangles.len();
    if triangles == 0 {
        return Err(Problem::new(
            "there is no face in it",
            "an OBJ file needs lines `v x y z` for points and `f a b c` for faces",
        )
        .in_file(file));
    }
    if triangles > MAX_PRIMITIVES {
        return Err(Problem::new(
            format!("it has more than {MAX_PRIMITIVES} triangles"),
            "use a model with fewer triangles",
        )
        .in_file(file));
    }
    let mut warnings = Vec::new();
    let (count, line) = surface.faces.edges;
    if count > 0 {
        warnings.push(format!(
            "{file}:{line}: {count} faces have fewer than three corners, this is the first: they are left out"
        ));
    }
    if !own_materials {
        return Ok(Obj {
            parts: vec![parts::whole(surface)],
            materials: Vec::new(),
            warnings,
        });
    }
    let materials = read_materials(&surface.faces, name, files, &mut warnings)?;
    // The first of a name counts.
    let mut numbers = HashMap::new();
    for (number, material) in materials.iter().enumerate() {
        numbers.entry(material.name.as_str()).or_insert(number);
    }
    let parts = parts::parts(surface, |name| numbers.get(name).copied());
    Ok(Obj {
        parts,
        materials,
        warnings,
    })
}

/// The materials of all MTL files that an OBJ file names. One that is missing, or a material that none describes, is
/// only a warning: the shape can be seen without.
fn read_materials(
    faces: &Faces,
    name: &str,
    files: &mut Files,
    warnings: &mut Vec<String>,
) -> Result<Vec<Material>, SceneError> {
    let mut materials: Vec<Material> = Vec::new();
    let file = &files.label(name);
    let mut libraries = 0;
    for (_, line, mark) in &faces.marks {
        let Mark::Library(library) = mark else {
            continue;
        };
        libraries += 1;
        // Its path starts where the OBJ file is.
        let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
        let path = match folder {
            "" => library.clone(),
            _ if library.starts_with('/') => library.clone(),
            _ => format!("{folder}/{library}"),
        };
        let text = files
            .read(&path)
            .map_err(|problem| problem.in_line(file, *line))?;
        let Some(text) = text else {
            warnings.push(format!(
                "{file}:{line}: there is no file `{library}`: what it describes is grey"
            ));
            continue;
        };
        let found = mtl::parse(&text)
            .map_err(|(line, problem)| problem.in_line(&files.label(&path), line))?;
        materials.extend(found);
    }
    if libraries == 0 {
        return Ok(materials);
    }
    let mut known: HashSet<&str> = materials.iter().map(|m| m.name.as_str()).collect();
    for (_, line, mark) in &faces.marks {
        if let Mark::Material(name) = mark
            && known.insert(name)
        {
            warnings.push(format!(
                "{file}:{line}: no MTL file describes the material `{name}`: it is grey"
            ));
        }
    }
    Ok(materials)
}

#[cfg(test)]
mod tests;
