//! Meshes from OBJ files, with the materials of their MTL files.
//!
//! The crate `tobj` reads the numbers of both. Before it, `check` and `mtl` mend what it would refuse, mistake or panic at,
//! and note what is left out or guessed; only a broken point, an index of no point, and a file without faces are refused.

mod check;
mod library;
mod mended;
mod mtl;
mod parts;

use std::collections::HashMap;
use std::path::Path;

use check::FaceRun;
use mended::read_mended;

use super::error::{Problem, SceneError};
use super::files::Files;
use super::mesh::Mesh;
use super::text::Decoded;
use crate::scene::warning::Warnings;
use crate::shading::Material;

/// What an OBJ file holds.
#[derive(Debug)]
pub struct Obj {
    /// Points, normals and texture coordinates of all parts.
    pub shared: Mesh,
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
    /// Its triangles.
    pub mesh: Mesh,
}

/// The material of what names none: a matt grey.
pub fn default_material(name: &str) -> Material {
    mtl::matt_grey(name)
}

/// Reads an OBJ file from its text. `name` is its path from the scene's folder; the MTL files that it names are read
/// through `files`, unless `own_materials` is false: then they are not needed.
pub fn parse(
    text: Decoded,
    name: &str,
    files: &mut Files,
    warnings: &mut Warnings,
    own_materials: bool,
) -> Result<Obj, SceneError> {
    let file = &files.label(name);
    let no_library = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (checked, loaded) = read_mended(&text.text, |mended| {
        tobj::load_obj_buf(mended, &tobj::LoadOptions::default(), no_library)
    });
    let mut checked = checked.map_err(|(line, problem)| problem.in_line(file, line))?;
    checked.notes.encoding(&text);
    drop(text);
    if checked.faces.is_empty() {
        let cure = "an OBJ file needs lines `v x y z` for points and `f a b c` for faces";
        return Err(Problem::new("there is no face in it", cure).in_file(file));
    }
    let (models, _) = loaded.map_err(|error| {
        let what = format!("a line up to this one cannot be read: {error}");
        let line = checked.faces.last().map_or(1, |line| *line as usize);
        Problem::new(what, "export the model again").in_line(file, line)
    })?;
    if !own_materials {
        checked.runs.truncate(1);
    }
    let (shared, meshes) = parts::parts(models, &mut checked);
    let mut materials = Vec::new();
    if own_materials {
        materials = library::read(&mut checked, name, files, warnings);
    }
    checked.notes.warn(file, warnings);
    let numbers: HashMap<&str, usize> = (materials.iter().enumerate())
        .map(|(number, material)| (material.name.as_str(), number))
        .collect();
    let part = |(run, mesh): (FaceRun, Mesh)| ObjPart {
        material: numbers.get(run.material.0.as_str()).copied(),
        name: match run.name.as_str() {
            "default" | "off" => String::new(),
            _ => run.name,
        },
        mesh,
    };
    let parts = checked.runs.into_iter().zip(meshes).map(part).collect();
    Ok(Obj {
        shared,
        parts,
        materials,
    })
}

#[cfg(test)]
mod tests;
