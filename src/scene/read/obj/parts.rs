//! From the faces of an OBJ file to its parts: runs of triangles with one name and one material.

use super::ObjPart;
use super::faces::{Faces, Mark, NONE};
use super::surface::ObjSurface;
use crate::math::{DVec2, DVec3};
use crate::scene::VertexData;
use crate::scene::read::mesh::Mesh;

/// A run of triangles.
struct PartRange {
    name: String,
    material: Option<usize>,
    first: usize,
    end: usize,
}

/// All of it as one part.
pub fn whole(surface: ObjSurface) -> ObjPart {
    let (points, uvs, normals) = (surface.points, surface.uvs, surface.normals);
    ObjPart {
        name: String::new(),
        material: None,
        mesh: mesh(points, uvs, normals, surface.faces),
    }
}

/// The parts, in their order. `material` is the number of the material with a name, if there is one.
pub fn parts(mut surface: ObjSurface, material: impl Fn(&str) -> Option<usize>) -> Vec<ObjPart> {
    let marks = std::mem::take(&mut surface.faces.marks);
    let mut runs = runs(marks, surface.faces.triangles.len(), material);
    if runs.len() == 1 {
        let run = runs.remove(0);
        return vec![ObjPart {
            name: run.name,
            material: run.material,
            mesh: whole(surface).mesh,
        }];
    }
    // Each part gets its own points: those that it uses, in the order in which it does.
    let mut points = Numbering::new(&surface.points);
    let mut uvs = Numbering::new(&surface.uvs);
    let mut normals = Numbering::new(&surface.normals);
    let faces = &surface.faces;
    let part = |run: PartRange| {
        let of = |list: &[[u32; 3]]| match list {
            [] => Vec::new(),
            list => list[run.first..run.end].to_vec(),
        };
        let mut own = Faces {
            triangles: of(&faces.triangles),
            uvs: of(&faces.uvs),
            normals: of(&faces.normals),
            lines: faces.lines[run.first..run.end].to_vec(),
            ..Faces::default()
        };
        let points = points.renumber(&mut own.triangles);
        let uvs = uvs.renumber(&mut own.uvs);
        let normals = normals.renumber(&mut own.normals);
        ObjPart {
            name: run.name,
            material: run.material,
            mesh: mesh(points, uvs, normals, own),
        }
    };
    runs.into_iter().map(part).collect()
}

/// A name begins a new run, and so does another material.
fn runs(
    marks: Vec<(usize, usize, Mark)>,
    end: usize,
    number: impl Fn(&str) -> Option<usize>,
) -> Vec<PartRange> {
    let (mut runs, mut first) = (Vec::new(), 0);
    let (mut name, mut material) = (String::new(), None);
    for (at, _, mark) in marks {
        let is_name = matches!(mark, Mark::Name(_));
        let (next_name, next_material) = match mark {
            Mark::Name(next) if matches!(&*next, "default" | "off") => (String::new(), material),
            Mark::Name(next) => (next, material),
            Mark::Material(next) => (name.clone(), number(&next)),
            Mark::Library(_) => continue,
        };
        let ends = is_name || next_material != material;
        if ends && at > first {
            runs.push(PartRange {
                name,
                material,
                first,
                end: at,
            });
            first = at;
        }
        (name, material) = (next_name, next_material);
    }
    if end > first {
        runs.push(PartRange {
            name,
            material,
            first,
            end,
        });
    }
    runs
}

/// A mesh, in which corners that have nothing get what changes nothing.
fn mesh(points: Vec<DVec3>, mut uvs: Vec<DVec2>, mut normals: Vec<DVec3>, faces: Faces) -> Mesh {
    let (no_uv, no_normal) = (uvs.len() as u32, normals.len() as u32);
    uvs.extend([DVec2::ZERO, DVec2::X, DVec2::Y]);
    normals.push(DVec3::ZERO);
    let mut corners = VertexData::default();
    if let Some(indices) = completed(faces.uvs, [no_uv, no_uv + 1, no_uv + 2]) {
        (corners.uvs, corners.uv_indices) = (uvs, indices);
    }
    if let Some(indices) = completed(faces.normals, [no_normal; 3]) {
        (corners.normals, corners.normal_indices) = (normals, indices);
    }
    Mesh {
        points,
        triangles: faces.triangles,
        lines: faces.lines,
        corners,
    }
}

/// The list with `instead` in place of [`NONE`]; `None` if nothing else is in it.
fn completed(mut list: Vec<[u32; 3]>, instead: [u32; 3]) -> Option<Vec<[u32; 3]>> {
    if list.iter().all(|t| *t == NONE) {
        return None;
    }
    for triangle in list.iter_mut().filter(|t| **t == NONE) {
        *triangle = instead;
    }
    Some(list)
}

/// Numbers for what a part uses of a list.
struct Numbering<'a, T> {
    all: &'a [T],
    /// The number of each in the part at hand, or `u32::MAX`.
    numbers: Vec<u32>,
}

impl<'a, T: Copy> Numbering<'a, T> {
    fn new(all: &'a [T]) -> Self {
        let numbers = vec![u32::MAX; all.len()];
        Self { all, numbers }
    }

    /// What the triangles of a part use, in the order in which they do; they are numbered anew.
    fn renumber(&mut self, triangles: &mut [[u32; 3]]) -> Vec<T> {
        let mut used = Vec::new();
        for index in triangles.iter_mut().filter(|t| **t != NONE).flatten() {
            let number = &mut self.numbers[*index as usize];
            if *number == u32::MAX {
                *number = used.len() as u32;
                used.push(*index);
            }
            *index = *number;
        }
        for index in &used {
            self.numbers[*index as usize] = u32::MAX;
        }
        used.iter().map(|index| self.all[*index as usize]).collect()
    }
}
