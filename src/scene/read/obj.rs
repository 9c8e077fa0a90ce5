//! Meshes from OBJ files, with the materials of their MTL files.

mod faces;
mod mtl;
mod parts;
mod polygon;
mod surface;
mod tokens;
mod vertices;

use std::collections::{HashMap, HashSet};

use faces::{Faces, Mark};

use super::error::{Problem, SceneError};
use super::files::Files;
use super::mesh::Mesh;
use crate::scene::warning::{WarningCode, Warnings};
use crate::shading::Material;

/// What an OBJ file holds.
#[derive(Debug)]
pub struct Obj {
    /// Its parts: each has a name and at most one material.
    pub parts: Vec<ObjPart>,
    /// The materials that they use, as its MTL files describe them.
    pub materials: Vec<Material>,
}

/// A part of an OBJ file.
#[derive(Debug)]
pub struct ObjPart {
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
    warnings: &mut Warnings,
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
    let (count, line) = surface.faces.edges;
    if count > 0 {
        let what = format!(
            "{count} faces have fewer than three corners, this is the first: they are left out"
        );
        let problem = Problem::new(
            what,
            "give each face at least three corners, or write lines as `l`",
        );
        warnings.add(WarningCode::FewCorners, problem.in_line(file, line));
    }
    if !own_materials {
        return Ok(Obj {
            parts: vec![parts::whole(surface)],
            materials: Vec::new(),
        });
    }
    let materials = read_materials(&surface.faces, name, files, warnings)?;
    let numbers: HashMap<&str, usize> = (materials.iter().enumerate())
        .map(|(number, material)| (material.name.as_str(), number))
        .collect();
    let parts = parts::parts(surface, |name| numbers.get(name).copied());
    Ok(Obj { parts, materials })
}

/// The materials that an OBJ file's faces use, from the MTL files that it names; each of these is read once. One that is
/// missing, or a material that none describes, is only a warning: the shape can be seen without.
fn read_materials(
    faces: &Faces,
    name: &str,
    files: &mut Files,
    warnings: &mut Warnings,
) -> Result<Vec<Material>, SceneError> {
    let mut materials: Vec<Material> = Vec::new();
    let file = &files.label(name);
    let used = faces.marks.iter().filter_map(|(_, line, mark)| match mark {
        Mark::Material(name) => Some((name.as_str(), *line)),
        _ => None,
    });
    let mut missing: HashSet<&str> = used.clone().map(|(name, _)| name).collect();
    let mut libraries = HashSet::new();
    for (_, line, mark) in &faces.marks {
        let Mark::Library(library) = mark else {
            continue;
        };
        if !libraries.insert(library.as_str()) {
            continue;
        }
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
            let what = format!("there is no file `{library}`: what it describes is grey");
            let problem = Problem::new(what, "put the file of materials beside the model");
            warnings.add(WarningCode::MissingLibrary, problem.in_line(file, *line));
            continue;
        };
        let found = mtl::parse(&text, |name| missing.remove(name))
            .map_err(|(line, problem)| problem.in_line(&files.label(&path), line))?;
        materials.extend(found);
    }
    if libraries.is_empty() {
        return Ok(materials);
    }
    for (name, line) in used {
        if missing.remove(name) {
            let what = format!("no MTL file describes the material `{name}`: it is grey");
            let problem = Problem::new(
                what,
                "describe it: `newmtl` and its name, then `Kd 0.8 0.2 0.1`",
            );
            warnings.add(WarningCode::MissingMaterial, problem.in_line(file, line));
        }
    }
    Ok(materials)
}

#[cfg(test)]
mod tests;
