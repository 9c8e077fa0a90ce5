//! Meshes: from lists in a scene file, and into the world.

use super::Builder;
use super::checks::{direction, point};
use super::objects::Header;
use crate::geometry::{Shape, Triangle};
use crate::math::{DVec2, DVec3};
use crate::scene::VertexData;
use crate::scene::error::{Place, SceneError};
use crate::scene::file::{MeshFile, Vector};
use crate::scene::limits::MAX_COORDINATE;
use crate::scene::mesh::Mesh;

impl Builder {
    /// Puts in a mesh. Triangles without area are left out: nothing can hit them, and they have no normal.
    pub fn mesh(&mut self, header: &Header, material: u32, mesh: Mesh) -> Result<(), SceneError> {
        self.begin(&header.name, material, &header.place)?;
        let Mesh {
            mut points,
            triangles,
            lines,
            mut corners,
        } = mesh;
        let mut mirrored = false;
        if let Some(map) = &header.map {
            for p in &mut points {
                *p = map.point(*p);
            }
            let turned = |n: &DVec3| {
                if *n == DVec3::ZERO {
                    *n
                } else {
                    map.normal(*n)
                }
            };
            for n in &mut corners.normals {
                *n = turned(n);
            }
            mirrored = map.flips_handedness();
        }
        // In a mirror, what ran counter-clockwise runs clockwise.
        let order = |t: [u32; 3]| if mirrored { [t[0], t[2], t[1]] } else { t };
        let mut kept = VertexData {
            normals: corners.normals,
            uvs: corners.uvs,
            ..VertexData::default()
        };
        let (mut flat, mut first) = (0, 0);
        for (i, t) in triangles.iter().enumerate() {
            let triangle = Triangle {
                corners: order(*t).map(|i| points[i as usize]),
            };
            if triangle.normal().is_none() {
                first = if flat == 0 { i } else { first };
                flat += 1;
                continue;
            }
            self.put(Shape::Triangle(triangle), &header.place)?;
            kept.normal_indices
                .extend(corners.normal_indices.get(i).copied().map(order));
            kept.uv_indices
                .extend(corners.uv_indices.get(i).copied().map(order));
        }
        if flat > 0 {
            let which = match lines.get(first) {
                Some(line) => format!("the first is on line {line}"),
                None => format!("the first is number {first}"),
            };
            self.warn(&format!(
                "object `{}`: {flat} of {} triangles have no area ({which}): they are left out",
                header.name,
                triangles.len()
            ));
        }
        let plain = kept.normal_indices.is_empty() && kept.uv_indices.is_empty();
        if let Some(object) = self.scene.objects.last_mut() {
            object.vertices = (!plain).then_some(kept);
        }
        Ok(())
    }
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
