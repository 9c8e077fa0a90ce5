//! Meshes: from lists in a scene file, and into the world.

use rayon::prelude::*;

use super::Builder;
use super::checks::{direction, point};
use super::objects::Header;
use crate::geometry::Triangle;
use crate::math::{DVec2, DVec3};
use crate::scene::VertexData;
use crate::scene::limits::MAX_COORDINATE;
use crate::scene::read::error::{Place, SceneError};
use crate::scene::read::file::{MeshFile, Vector};
use crate::scene::read::mesh::Mesh;

impl Builder {
    /// Puts in a mesh. Triangles without area are left out: nothing can hit them, and they have no normal.
    pub fn mesh(&mut self, header: &Header, material: u32, mesh: Mesh) -> Result<(), SceneError> {
        self.begin(&header.name, material, &header.place)?;
        let Mesh {
            mut points,
            mut triangles,
            lines,
            mut corners,
        } = mesh;
        if let Some(map) = &header.map {
            points.par_iter_mut().for_each(|p| *p = map.point(*p));
            for n in corners.normals.iter_mut().filter(|n| **n != DVec3::ZERO) {
                *n = map.normal(*n);
            }
            // In a mirror, what ran counter-clockwise runs clockwise.
            if map.flips_handedness() {
                let lists = [&mut triangles, &mut corners.normal_indices];
                for list in lists.into_iter().chain([&mut corners.uv_indices]) {
                    for triangle in list.iter_mut() {
                        triangle.swap(1, 2);
                    }
                }
            }
        }
        let place = |t: &[u32; 3]| Triangle {
            corners: t.map(|i| points[i as usize]),
        };
        let count = triangles.len();
        let flat: Vec<u32> = (0..count as u32)
            .into_par_iter()
            .filter(|i| place(&triangles[*i as usize]).normal().is_none())
            .collect();
        if let Some(first) = flat.first() {
            let which = match lines.get(*first as usize) {
                Some(line) => format!("the first is on line {line}"),
                None => format!("the first is number {first}"),
            };
            self.warnings.add(|| {
                format!(
                    "object `{}`: {} of {count} triangles have no area ({which}): they are left out",
                    header.name,
                    flat.len(),
                )
            });
            leave_out(&flat, &mut triangles);
            leave_out(&flat, &mut corners.normal_indices);
            leave_out(&flat, &mut corners.uv_indices);
        }
        drop(lines);
        self.put_all(&triangles, place, &header.place)?;
        let plain = corners.normal_indices.is_empty() && corners.uv_indices.is_empty();
        if let Some(object) = self.scene.objects.last_mut() {
            object.vertices = (!plain).then_some(corners);
        }
        Ok(())
    }
}

/// Takes the elements with these numbers, which ascend, out of a list.
fn leave_out<T>(numbers: &[u32], list: &mut Vec<T>) {
    let (mut left, mut number) = (numbers.iter().peekable(), 0);
    list.retain(|_| {
        let out = left.next_if_eq(&&number).is_some();
        number += 1;
        !out
    });
}

/// Finite points, not too far away.
pub fn points(list: &[Vector], place: &Place) -> Result<Vec<DVec3>, SceneError> {
    let inside = |v: &Vector| v.iter().all(|c| c.abs() <= MAX_COORDINATE);
    if let Some(i) = list.iter().position(|v| !inside(v)) {
        point(list[i], &place.index(i))?;
    }
    Ok(list.iter().copied().map(DVec3::from).collect())
}

/// Directions of any length but 0, made unit.
pub fn directions(list: &[Vector], place: &Place) -> Result<Vec<DVec3>, SceneError> {
    let unit = |(i, v): (usize, &Vector)| direction(*v, &place.index(i));
    list.iter().enumerate().map(unit).collect()
}

/// The two triangles of a parallelogram.
pub fn quad(corner: DVec3, u: DVec3, v: DVec3) -> Mesh {
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    Mesh {
        points: vec![corner, corner + u, corner + u + v, corner + v],
        corners: VertexData {
            uv_indices: triangles.clone(),
            uvs: vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y],
            ..VertexData::default()
        },
        triangles,
        ..Mesh::default()
    }
}

/// The mesh that stands in the scene file.
pub fn inline(file: &MeshFile, place: &Place) -> Result<Mesh, SceneError> {
    let count = file.vertices.len();
    for (i, triangle) in file.triangles.iter().enumerate() {
        for (j, index) in triangle.iter().enumerate() {
            if *index as usize >= count {
                return Err(place.key("triangles").index(i).index(j).error(
                    format!("there is no vertex {index}"),
                    format!("there are {count} vertices, counted from 0"),
                ));
            }
        }
    }
    let same = |found: usize, key: &str| {
        if found == count {
            return Ok(());
        }
        Err(place.key(key).error(
            format!("there are {found} {key} for {count} vertices"),
            "give one for each vertex, or none at all",
        ))
    };
    let mut corners = VertexData::default();
    if let Some(normals) = &file.normals {
        same(normals.len(), "normals")?;
        corners.normals = directions(normals, &place.key("normals"))?;
        corners.normal_indices.clone_from(&file.triangles);
    }
    if let Some(uvs) = &file.uvs {
        same(uvs.len(), "uvs")?;
        for (i, [u, v]) in uvs.iter().enumerate() {
            point([*u, *v, 0.0], &place.key("uvs").index(i))?;
        }
        corners.uvs = uvs.iter().copied().map(DVec2::from).collect();
        corners.uv_indices.clone_from(&file.triangles);
    }
    Ok(Mesh {
        points: points(&file.vertices, &place.key("vertices"))?,
        triangles: file.triangles.clone(),
        lines: Vec::new(),
        corners,
    })
}
