//! From the models of `tobj` to parts of a file: triangles with one name and one material.

use std::borrow::Cow;

use super::check::Checked;
use crate::math::{DVec2, DVec3};
use crate::scene::read::cut::triangulate;
use crate::scene::read::mesh::Mesh;
use crate::scene::warning::WarningCode;

/// Texture coordinates of a triangle that has none, and its normals: they change nothing.
const NO_UVS: [u32; 3] = [0, 1, 2];
const NO_NORMALS: [u32; 3] = [0; 3];

/// Points, texture coordinates and normals of all models.
struct Lists {
    points: Vec<DVec3>,
    uvs: Vec<DVec2>,
    normals: Vec<DVec3>,
}

/// What all parts share, and the triangles of each run of faces.
pub fn parts(models: Vec<tobj::Model>, checked: &mut Checked) -> (Mesh, Vec<Mesh>) {
    let all = |own: fn(&tobj::Mesh) -> &[f64]| -> usize {
        models.iter().map(|model| own(&model.mesh).len()).sum()
    };
    let mut lists = Lists {
        points: Vec::with_capacity(all(|mesh| &mesh.positions) / 3),
        uvs: Vec::with_capacity(3 + all(|mesh| &mesh.texcoords) / 2),
        normals: Vec::with_capacity(1 + all(|mesh| &mesh.normals) / 3),
    };
    lists.uvs.extend([DVec2::ZERO, DVec2::X, DVec2::Y]);
    lists.normals.push(DVec3::ZERO);
    let mut parts: Vec<Mesh> = Vec::with_capacity(checked.runs.len());
    let mut runs = checked.runs.iter().peekable();
    let mut lines = checked.faces.iter().enumerate();
    for mut model in models {
        lists.append(&mut model.mesh);
        let tobj::Mesh {
            indices,
            texcoord_indices,
            normal_indices,
            face_arities,
            ..
        } = model.mesh;
        let (mut at, mut arities) = (0, face_arities.iter());
        while at < indices.len() {
            let corners = at..at + arities.next().map_or(3, |arity| *arity as usize);
            at = corners.end;
            let Some((face, line)) = lines.next() else {
                break;
            };
            if let Some(run) = runs.next_if(|run| run.first == face) {
                let mut part = Mesh::default();
                let room = |indices: &[u32]| usize::from(!indices.is_empty()) * run.triangles;
                part.triangles.reserve_exact(run.triangles);
                part.lines.reserve_exact(run.triangles);
                part.corners
                    .uv_indices
                    .reserve_exact(room(&texcoord_indices));
                part.corners
                    .normal_indices
                    .reserve_exact(room(&normal_indices));
                parts.push(part);
            }
            let own = [&indices, &texcoord_indices, &normal_indices];
            let own = own.map(|list| list.get(corners.clone()).unwrap_or_default());
            let guess = parts
                .last_mut()
                .and_then(|part| lists.face(own, *line, part));
            if let Some(guess) = guess {
                checked
                    .notes
                    .add(WarningCode::GuessedFace, guess, *line as usize);
            }
        }
    }
    parts.iter_mut().for_each(forget_none);
    let points = lists.points.into();
    let mut shared = Mesh {
        points,
        ..Mesh::default()
    };
    (shared.corners.uvs, shared.corners.normals) = (lists.uvs.into(), lists.normals.into());
    (shared, parts)
}

/// Empties lists of a part that say nothing.
fn forget_none(part: &mut Mesh) {
    let corners = &mut part.corners;
    if corners.uv_indices.iter().all(|t| *t == NO_UVS) {
        corners.uv_indices = Vec::new();
    }
    if corners.normal_indices.iter().all(|t| *t == NO_NORMALS) {
        corners.normal_indices = Vec::new();
    }
}

impl Lists {
    /// Appends those of a mesh, whose indices then count in these lists.
    fn append(&mut self, mesh: &mut tobj::Mesh) {
        let shift =
            |indices: &mut Vec<u32>, by: usize| indices.iter_mut().for_each(|i| *i += by as u32);
        shift(&mut mesh.indices, self.points.len());
        shift(&mut mesh.texcoord_indices, self.uvs.len());
        shift(&mut mesh.normal_indices, self.normals.len());
        let triple = |numbers: &[f64]| DVec3::from_slice(numbers);
        self.points
            .extend(mesh.positions.chunks_exact(3).map(triple));
        self.uvs
            .extend(mesh.texcoords.chunks_exact(2).map(DVec2::from_slice));
        let normals = mesh.normals.chunks_exact(3).map(triple);
        self.normals.extend(normals.map(DVec3::normalize_or_zero));
    }

    /// Adds the triangles of a face; tells why they are a guess, if they are one.
    fn face(
        &self,
        [points, uvs, normals]: [&[u32]; 3],
        line: u32,
        part: &mut Mesh,
    ) -> Option<&'static str> {
        // All corners of a face have a normal, or none has; texture coordinates as well.
        let has_uvs = uvs.iter().all(|i| !self.uvs[*i as usize].is_nan());
        let has_normals = normals
            .iter()
            .all(|i| self.normals[*i as usize] != DVec3::ZERO);
        let (mut cut, mut guess) = (Cow::from(&[[0, 1, 2]]), None);
        if points.len() > 3 {
            let outline: Vec<DVec3> = points.iter().map(|i| self.points[*i as usize]).collect();
            let triangles;
            (triangles, guess) = triangulate(&outline);
            cut = triangles.into();
        }
        for t in cut.iter() {
            let own = |list: &[u32]| t.map(|k| list[k]);
            part.triangles.push(own(points));
            part.lines.push(line);
            if !uvs.is_empty() {
                part.corners
                    .uv_indices
                    .push(if has_uvs { own(uvs) } else { NO_UVS });
            }
            if !normals.is_empty() {
                part.corners.normal_indices.push(if has_normals {
                    own(normals)
                } else {
                    NO_NORMALS
                });
            }
        }
        guess
    }
}
