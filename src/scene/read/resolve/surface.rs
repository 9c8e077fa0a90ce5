//! LocalSurface of an object in its own space, by the object's kind.

use std::sync::Arc;

use super::checks::{direction, directions, point, points, positive};
use super::polygons::{Loops, check_faces, polygon};
use super::solids;
use crate::geometry::{Disc, Plane, Shape};
use crate::math::{DVec2, DVec3};
use crate::scene::VertexData;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{MeshFile, ObjectFile, TriangleFile};
use crate::scene::read::mesh::Mesh;

/// LocalSurface of an object in its own space.
pub enum LocalSurface {
    /// One shape.
    Shape(Shape),
    /// Triangles, and faces of any number of corners.
    Mesh(Mesh, Vec<Vec<u32>>),
    /// A polygon: its loops, and what its corners carry.
    Polygon(Loops, VertexData),
}

/// LocalSurface of an object; `None` for a csg and a group, which have parts, for patches, which are cut in the world, and for a model, whose surface is in another file.
pub fn surface(object: &ObjectFile, path: &FieldPath) -> Result<Option<LocalSurface>, SceneError> {
    Ok(Some(match object {
        ObjectFile::Sphere(s) => LocalSurface::Shape(solids::sphere(s, path)?),
        ObjectFile::Box(b) => LocalSurface::Shape(solids::cuboid(b, path)?),
        ObjectFile::Cylinder(c) => LocalSurface::Shape(solids::cylinder(c, path)?),
        ObjectFile::Cone(c) => LocalSurface::Shape(solids::cone(c, path)?),
        ObjectFile::Paraboloid(p) => LocalSurface::Shape(solids::paraboloid(p, path)?),
        ObjectFile::Hyperboloid(h) => LocalSurface::Shape(solids::hyperboloid(h, path)?),
        ObjectFile::Ellipsoid(e) => LocalSurface::Shape(solids::ellipsoid(e, path)?),
        ObjectFile::Quadric(q) => LocalSurface::Shape(solids::quadric(q, path)?),
        ObjectFile::Torus(t) => LocalSurface::Shape(solids::torus(t, path)?),
        ObjectFile::Quartic(q) => LocalSurface::Shape(solids::quartic(q, path)?),
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
        ObjectFile::Triangle(t) => LocalSurface::Mesh(triangle(t, path)?, Vec::new()),
        ObjectFile::Quad(q) => {
            let corner = point(q.corner, &path.key("corner"))?;
            let u = point(q.u, &path.key("u"))?;
            let v = point(q.v, &path.key("v"))?;
            LocalSurface::Mesh(parallelogram(corner, u, v), Vec::new())
        }
        ObjectFile::Mesh(m) => LocalSurface::Mesh(mesh(m, path)?, m.polygons.clone()),
        ObjectFile::Polygon(p) => {
            let (loops, data) = polygon(p, path)?;
            LocalSurface::Polygon(loops, data)
        }
        ObjectFile::Csg(_)
        | ObjectFile::Bezier(_)
        | ObjectFile::Nurbs(_)
        | ObjectFile::Obj(_)
        | ObjectFile::Group(_)
        | ObjectFile::Use(_) => return Ok(None),
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
    check_faces(file, path)?;
    if file.triangles.is_empty() && file.polygons.is_empty() {
        return Err(path.error(
            "the mesh has neither triangles nor polygons",
            "list them, such as \"triangles\": [[0, 1, 2]]",
        ));
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
