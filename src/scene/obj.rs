//! Meshes from OBJ files, with the materials of their MTL files.

mod check;
mod mtl;
mod polygon;

use std::collections::HashMap;

use check::{Checked, Face};

use super::VertexData;
use super::error::{Problem, SceneError};
use super::files::Files;
use super::limits::MAX_PRIMITIVES;
use super::mesh::Mesh;
use crate::math::{DVec2, DVec3};
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
    let checked = check::check(text).map_err(|(line, problem)| problem.in_line(file, line))?;
    let mut warnings = Vec::new();
    let (count, line) = checked.edges;
    if count > 0 {
        warnings.push(format!(
            "{file}:{line}: {count} faces have fewer than three corners, this is the first: they are left out"
        ));
    }
    let materials = if own_materials {
        read_materials(&checked, name, files, &mut warnings)?
    } else {
        Vec::new()
    };
    let parts = read_parts(&checked, file, &materials)?;
    if parts.is_empty() {
        return Err(Problem::new(
            "there is no face in it",
            "an OBJ file needs lines `v x y z` for points and `f a b c` for faces",
        )
        .in_file(file));
    }
    Ok(Obj {
        parts,
        materials,
        warnings,
    })
}

/// The materials of all MTL files that an OBJ file names. One that is missing, or a material that none describes, is
/// only a warning: the shape can be seen without.
fn read_materials(
    checked: &Checked,
    name: &str,
    files: &mut Files,
    warnings: &mut Vec<String>,
) -> Result<Vec<Material>, SceneError> {
    let mut materials: Vec<Material> = Vec::new();
    let file = &files.label(name);
    for (line, library) in &checked.libraries {
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
    for (line, name) in &checked.uses {
        if !checked.libraries.is_empty() && !materials.iter().any(|m| m.name == *name) {
            warnings.push(format!(
                "{file}:{line}: no MTL file describes the material `{name}`: it is grey"
            ));
        }
    }
    Ok(materials)
}

fn read_parts(
    checked: &Checked,
    file: &str,
    materials: &[Material],
) -> Result<Vec<Part>, SceneError> {
    let options = tobj::LoadOptions {
        ignore_points: true,
        ignore_lines: true,
        ..tobj::LoadOptions::default()
    };
    // The materials were read already; all that matters here is their numbers. The first of a name counts.
    let numbers: HashMap<String, usize> = (0..materials.len())
        .rev()
        .map(|i| (materials[i].name.clone(), i))
        .collect();
    let stand_ins = || vec![tobj::Material::default(); materials.len()];
    let text = format!("mtllib all\n{}", checked.text);
    let loaded = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| {
        Ok((stand_ins(), numbers.clone()))
    });
    let (models, _) = loaded.map_err(|e| {
        Problem::new(
            format!("it cannot be read: {e}"),
            "save it again from the program that made it",
        )
        .in_file(file)
    })?;

    let mut faces = checked.faces.iter();
    let mut parts: Vec<Part> = Vec::new();
    let mut triangles = 0;
    for model in models {
        let mesh = triangles_of(&model.mesh, &mut faces);
        triangles += mesh.triangles.len();
        if triangles > MAX_PRIMITIVES {
            return Err(Problem::new(
                format!("it has more than {MAX_PRIMITIVES} triangles"),
                "use a model with fewer triangles",
            )
            .in_file(file));
        }
        if mesh.triangles.is_empty() {
            continue;
        }
        let named = !matches!(&*model.name, "unnamed_object" | "default" | "off");
        parts.push(Part {
            name: if named { model.name } else { String::new() },
            material: model.mesh.material_id,
            mesh,
        });
    }
    Ok(parts)
}

/// The faces of one model, cut into triangles. `faces` tells of each face of the file, in order.
fn triangles_of<'a>(mesh: &tobj::Mesh, faces: &mut impl Iterator<Item = &'a Face>) -> Mesh {
    let points: Vec<DVec3> = mesh
        .positions
        .chunks_exact(3)
        .map(DVec3::from_slice)
        .collect();
    let mut normals: Vec<DVec3> = mesh
        .normals
        .chunks_exact(3)
        .map(|n| DVec3::from_slice(n).normalize_or_zero())
        .collect();
    let mut uvs: Vec<DVec2> = mesh
        .texcoords
        .chunks_exact(2)
        .map(DVec2::from_slice)
        .collect();
    // What the reader invents for corners that have none is replaced by what changes nothing.
    let no_normal = normals.len() as u32;
    normals.push(DVec3::ZERO);
    let no_uv = uvs.len() as u32;
    uvs.extend([DVec2::ZERO, DVec2::X, DVec2::Y]);

    let mut result = Mesh::default();
    let mut corners = VertexData::default();
    let (mut any_normal, mut any_uv) = (false, false);
    let mut start = 0;
    let mut arities = mesh.face_arities.iter();
    while start < mesh.indices.len() {
        let arity = arities.next().map_or(3, |&n| n as usize);
        let end = (start + arity).min(mesh.indices.len());
        let Some(face) = faces.next() else { break };
        let at = |list: &[u32], i: usize| list.get(start + i).copied();
        let outline: Vec<DVec3> = mesh.indices[start..end]
            .iter()
            .filter_map(|&i| points.get(i as usize).copied())
            .collect();
        for cut in polygon::triangulate(&outline) {
            result.triangles.push(cut.map(|i| mesh.indices[start + i]));
            result.lines.push(face.line);
            let normal = cut.map(|i| at(&mesh.normal_indices, i).filter(|_| face.normals));
            any_normal |= normal[0].is_some();
            corners
                .normal_indices
                .push(normal.map(|n| n.unwrap_or(no_normal)));
            let uv = cut.map(|i| at(&mesh.texcoord_indices, i).filter(|_| face.uvs));
            any_uv |= uv[0].is_some();
            corners.uv_indices.push(match uv {
                [Some(a), Some(b), Some(c)] => [a, b, c],
                _ => [no_uv, no_uv + 1, no_uv + 2],
            });
        }
        start = end;
    }
    if any_normal {
        corners.normals = normals;
    } else {
        corners.normal_indices.clear();
    }
    if any_uv {
        corners.uvs = uvs;
    } else {
        corners.uv_indices.clear();
    }
    Mesh {
        points,
        corners,
        ..result
    }
}
