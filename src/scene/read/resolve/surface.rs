//! LocalSurface of an object in its own space, by the object's kind.

use std::sync::Arc;

use super::checks::{direction, directions, point, points, positive};
use crate::geometry::{Aabb, Cuboid, Disc, Plane, Shape, Sphere};
use crate::math::{DVec2, DVec3};
use crate::scene::VertexData;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{MeshFile, ObjectFile, TriangleFile, Triple};
use crate::scene::read::mesh::Mesh;

/// LocalSurface of an object in its own space.
pub enum LocalSurface {
    /// One shape.
    Shape(Shape),
    /// Triangles.
    Mesh(Mesh),
}

/// LocalSurface of an object; `None` for a group and for a model, whose surface is in another file.
pub fn surface(object: &ObjectFile, path: &FieldPath) -> Result<Option<LocalSurface>, SceneError> {
    Ok(Some(match object {
        ObjectFile::Sphere(s) => {
            let center = point(s.center, &path.key("center"))?;
            let radius = positive(s.radius, &path.key("radius"))?;
            LocalSurface::Shape(Shape::Sphere(Sphere { center, radius }))
        }
        ObjectFile::Disc(d) => {
            let center = point(d.center, &path.key("center"))?;
            let normal = direction(d.normal, &path.key("normal"))?;
            let radius = positive(d.radius, &path.key("radius"))?;
            let disc = Disc::new(center, normal, radius);
            LocalSurface::Shape(Shape::Disc(Box::new(disc)))
        }
        ObjectFile::Plane(p) => {
            let point = point(p.point, &path.key("point"))?;
            let normal = direction(p.normal, &path.key("normal"))?;
            LocalSurface::Shape(Shape::Plane(Box::new(Plane::new(point, normal))))
        }
        ObjectFile::Box(b) => {
            let bounds = bounds(b.min, b.max, path)?;
            LocalSurface::Shape(Shape::Cuboid(Cuboid { bounds }))
        }
        ObjectFile::Triangle(t) => LocalSurface::Mesh(triangle(t, path)?),
        ObjectFile::Quad(q) => {
            let corner = point(q.corner, &path.key("corner"))?;
            let u = point(q.u, &path.key("u"))?;
            let v = point(q.v, &path.key("v"))?;
            LocalSurface::Mesh(parallelogram(corner, u, v))
        }
        ObjectFile::Mesh(m) => LocalSurface::Mesh(mesh(m, path)?),
        ObjectFile::Obj(_) | ObjectFile::Group(_) => return Ok(None),
    }))
}

fn triangle(file: &TriangleFile, path: &FieldPath) -> Result<Mesh, SceneError> {
    let points = points(&file.corners, &path.key("corners"))?;
    let mut corners = VertexData::default();
    if let Some(normals) = &file.normals {
        corners.normals = directions(normals, &path.key("normals"))?.into();
        corners.normal_indices = vec![[0, 1, 2]];
    }
    Ok(Mesh {
        points: points.into(),
        triangles: vec![[0, 1, 2]],
        corners,
        ..Mesh::default()
    })
}

fn bounds(min: Triple, max: Triple, path: &FieldPath) -> Result<Aabb, SceneError> {
    let min = point(min, &path.key("min"))?;
    let max = point(max, &path.key("max"))?;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if min[axis] >= max[axis] {
            return Err(path.error(
                format!(
                    "along {name} the box goes from min {} to max {}",
                    min[axis], max[axis]
                ),
                "make every number of `min` smaller than that of `max`; for a flat thing use a quad",
            ));
        }
    }
    Ok(Aabb { min, max })
}

/// The parallelogram at `corner` with the edges u and v, as two triangles.
fn parallelogram(corner: DVec3, u: DVec3, v: DVec3) -> Mesh {
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    Mesh {
        points: vec![corner, corner + u, corner + u + v, corner + v].into(),
        corners: VertexData {
            uv_indices: triangles.clone(),
            uvs: vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].into(),
            ..VertexData::default()
        },
        triangles,
        ..Mesh::default()
    }
}

/// Mesh whose vertices and triangles stand in the scene file.
fn mesh(file: &MeshFile, path: &FieldPath) -> Result<Mesh, SceneError> {
    let count = file.vertices.len();
    for (i, triangle) in file.triangles.iter().enumerate() {
        for (j, index) in triangle.iter().enumerate() {
            if *index as usize >= count {
                return Err(path.key("triangles").index(i).index(j).error(
                    format!("there is no vertex {index}"),
                    format!("there are {count} vertices, counted from 0"),
                ));
            }
        }
    }
    let check_count = |found: usize, key: &str| {
        if found == count {
            return Ok(());
        }
        Err(path.key(key).error(
            format!("there are {found} {key} for {count} vertices"),
            "give one for each vertex, or none at all",
        ))
    };
    let mut corners = VertexData::default();
    if let Some(normals) = &file.normals {
        check_count(normals.len(), "normals")?;
        corners.normals = directions(normals, &path.key("normals"))?.into();
        corners.normal_indices.clone_from(&file.triangles);
    }
    if let Some(uvs) = &file.uvs {
        check_count(uvs.len(), "uvs")?;
        for (i, [u, v]) in uvs.iter().enumerate() {
            point([*u, *v, 0.0], &path.key("uvs").index(i))?;
        }
        corners.uvs = Arc::new(uvs.iter().copied().map(DVec2::from).collect());
        corners.uv_indices.clone_from(&file.triangles);
    }
    Ok(Mesh {
        points: points(&file.vertices, &path.key("vertices"))?.into(),
        triangles: file.triangles.clone(),
        lines: Vec::new(),
        corners,
    })
}
