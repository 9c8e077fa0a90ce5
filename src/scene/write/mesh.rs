//! Mesh in a scene file: triangles in world space, with what their corners carry.

use std::collections::BTreeMap;

use super::fields::{Fields, rows};
use crate::geometry::{Shape, Triangle};
use crate::math::{DVec2, DVec3};
use crate::scene::Object;

/// A corner of a triangle.
#[derive(Clone, Copy)]
struct MeshCorner {
    point: DVec3,
    normal: Option<DVec3>,
    uv: Option<DVec2>,
}

/// An object of triangles; `None` if there are other shapes.
pub fn mesh(object: &Object, shapes: &[Shape], fields: Fields) -> Option<String> {
    let mut triangles = Vec::with_capacity(shapes.len());
    let smooth = is_smooth(object);
    if shapes
        .iter()
        .any(|s| matches!(s.plain(), Shape::Polygon(_)))
    {
        return with_faces(shapes, fields);
    }
    for (number, shape) in shapes.iter().enumerate() {
        let Shape::Triangle(triangle) = shape.plain() else {
            return None;
        };
        triangles.push(corners(object, smooth, number, triangle));
    }
    if let [corners] = &triangles[..]
        && corners.iter().all(|c| c.uv.is_none())
    {
        let fields = fields.rows("corners", &corners.map(|c| c.point.to_array()));
        let normals = corners.map(|c| c.normal.map(|n| n.to_array()));
        return Some(match normals {
            [Some(a), Some(b), Some(c)] => fields.rows("normals", &[a, b, c]).kind("triangle"),
            _ => fields.kind("triangle"),
        });
    }
    let (vertices, indices) = indexed(&triangles);
    let points: Vec<[f64; 3]> = vertices.iter().map(|v| v.point.to_array()).collect();
    let normals = vertices.iter().filter_map(|v| v.normal);
    let normals: Vec<[f64; 3]> = normals.map(|n| n.to_array()).collect();
    let uvs = vertices.iter().filter_map(|v| v.uv);
    let uvs: Vec<[f64; 2]> = uvs.map(|uv| uv.to_array()).collect();
    let indices = indices.iter().map(|t| t.map(f64::from));
    let mut fields = fields
        .rows("vertices", &points)
        .raw("triangles", &rows(&indices.collect::<Vec<_>>()));
    if !normals.is_empty() {
        fields = fields.rows("normals", &normals);
    }
    if !uvs.is_empty() {
        fields = fields.rows("uvs", &uvs);
    }
    if object.mirrored {
        fields = fields.raw("transform", "[{\"scale\": [-1, 1, 1]}]");
    }
    Some(fields.kind("mesh"))
}

/// A mesh with faces of any number of corners: none of its corners carries more than a point.
fn with_faces(shapes: &[Shape], fields: Fields) -> Option<String> {
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let (mut triangles, mut polygons) = (Vec::new(), Vec::new());
    for shape in shapes {
        let first = vertices.len();
        let faces = match shape.plain() {
            Shape::Triangle(triangle) => {
                vertices.extend(triangle.corners.map(|c| c.to_array()));
                &mut triangles
            }
            Shape::Polygon(polygon) => {
                vertices.extend(polygon.loops().flatten().map(DVec3::to_array));
                &mut polygons
            }
            _ => return None,
        };
        let numbers: Vec<String> = (first..vertices.len()).map(|i| i.to_string()).collect();
        faces.push(format!("[{}]", numbers.join(", ")));
    }
    let fields = fields
        .rows("vertices", &vertices)
        .raw("triangles", &format!("[{}]", triangles.join(", ")))
        .raw("polygons", &format!("[{}]", polygons.join(", ")));
    Some(fields.kind("mesh"))
}

/// Whether any corner of an object has a normal.
fn is_smooth(object: &Object) -> bool {
    let Some(data) = &object.vertices else {
        return false;
    };
    let mut corners = data.normal_indices.iter().flatten();
    corners.any(|n| data.normals[*n as usize] != DVec3::ZERO)
}

/// The corners of a triangle as the file has them. Where a transform mirrors the mesh, the file has its mirror image: what the
/// reader makes of that has its corners in another order.
fn corners(object: &Object, smooth: bool, number: usize, triangle: &Triangle) -> [MeshCorner; 3] {
    let data = object.vertices.as_ref();
    let normals = data.and_then(|data| {
        let indices = data.normal_indices.get(number)?;
        Some(indices.map(|i| data.normals[i as usize]))
    });
    let uvs = data.and_then(|data| {
        let indices = data.uv_indices.get(number)?;
        Some(indices.map(|i| data.uvs[i as usize]))
    });
    // A flat triangle of a smooth mesh: normals on its back are never used, and none cannot be written.
    let back = -triangle.normal().unwrap_or(DVec3::Y);
    let normals = smooth.then(|| {
        let normals = normals.unwrap_or_default();
        let is_flat = normals.contains(&DVec3::ZERO);
        if is_flat { [back; 3] } else { normals }
    });
    let mut corners = [0, 1, 2].map(|i| MeshCorner {
        point: triangle.corners[i],
        normal: normals.map(|n| n[i]),
        uv: uvs.map(|uv| uv[i]),
    });
    if object.mirrored {
        let mirror = DVec3::new(-1.0, 1.0, 1.0);
        for corner in &mut corners {
            corner.point *= mirror;
            corner.normal = corner.normal.map(|normal| normal * mirror);
        }
        corners.swap(1, 2);
    }
    corners
}

/// The corners that differ, and for each triangle the numbers of its own.
fn indexed(triangles: &[[MeshCorner; 3]]) -> (Vec<MeshCorner>, Vec<[u32; 3]>) {
    let mut numbers: BTreeMap<[u64; 8], u32> = BTreeMap::new();
    let mut vertices = Vec::new();
    let indices = triangles.iter().map(|corners| {
        corners.map(|corner| {
            *numbers.entry(bits(&corner)).or_insert_with(|| {
                vertices.push(corner);
                vertices.len() as u32 - 1
            })
        })
    });
    let indices = indices.collect();
    (vertices, indices)
}

fn bits(corner: &MeshCorner) -> [u64; 8] {
    let [x, y, z] = corner.point.to_array();
    let [a, b, c] = corner.normal.unwrap_or_default().to_array();
    let [u, v] = corner.uv.unwrap_or_default().to_array();
    [x, y, z, a, b, c, u, v].map(f64::to_bits)
}
