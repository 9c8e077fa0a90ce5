//! Polygons of a scene file: flat ones stay what they are, others are cut into triangles.

use std::sync::Arc;

use super::checks::{directions, point, points};
use super::header::Header;
use super::resolver::Resolver;
use crate::geometry::{Polygon, Shape};
use crate::math::{DVec2, DVec3};
use crate::scene::VertexData;
use crate::scene::limits::MAX_CORNERS;
use crate::scene::read::cut::triangulate;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{MeshFile, PolygonFile};
use crate::scene::read::mesh::Mesh;
use crate::scene::warning::WarningCode;
use crate::shading::ShadingModel;

/// Loops of corners, the rim first.
pub type Loops = Vec<Vec<DVec3>>;

/// The loops of a polygon, and the normals and surface coordinates of its corners if it has any.
pub fn polygon(file: &PolygonFile, path: &FieldPath) -> Result<(Loops, VertexData), SceneError> {
    let mut loops = vec![corners(&file.points, &path.key("points"))?];
    for (i, hole) in file.holes.iter().enumerate() {
        loops.push(corners(hole, &path.key("holes").index(i))?);
    }
    let count = loops.iter().map(Vec::len).sum::<usize>();
    if count > MAX_CORNERS {
        return Err(path.error(
            format!("the polygon has {count} corners: at most {MAX_CORNERS} are possible"),
            "cut it into smaller polygons, or use a mesh of triangles",
        ));
    }
    let rim = file.points.len();
    let mut data = VertexData::default();
    let has_more = |key: &str, found: usize| {
        let problem = if !file.holes.is_empty() {
            "a polygon with holes cannot have them".to_owned()
        } else if found != rim {
            format!("there are {found} {key} for {rim} points")
        } else {
            return Ok(());
        };
        let cure = "give one for each point of a polygon without holes, or none at all";
        Err(path.key(key).error(problem, cure))
    };
    if let Some(normals) = &file.normals {
        has_more("normals", normals.len())?;
        data.normals = directions(normals, &path.key("normals"))?.into();
    }
    if let Some(uvs) = &file.uvs {
        has_more("uvs", uvs.len())?;
        for (i, [u, v]) in uvs.iter().enumerate() {
            point([*u, *v, 0.0], &path.key("uvs").index(i))?;
        }
        data.uvs = Arc::new(uvs.iter().copied().map(DVec2::from).collect());
    }
    Ok((loops, data))
}

fn corners(list: &[[f64; 3]], path: &FieldPath) -> Result<Vec<DVec3>, SceneError> {
    if list.len() < 3 {
        return Err(path.error(
            format!("a loop of {} corners encloses nothing", list.len()),
            "write three corners or more",
        ));
    }
    points(list, path)
}

/// Checks the faces of a mesh in a scene file, each a list of numbers of its vertices.
pub fn check_faces(file: &MeshFile, path: &FieldPath) -> Result<(), SceneError> {
    let count = file.vertices.len();
    for (i, face) in file.polygons.iter().enumerate() {
        let path = path.key("polygons").index(i);
        if !(3..=MAX_CORNERS).contains(&face.len()) {
            return Err(path.error(
                format!("a face of {} corners is not possible", face.len()),
                format!("write from 3 to {MAX_CORNERS} corners"),
            ));
        }
        if let Some(j) = face.iter().position(|v| *v as usize >= count) {
            return Err(path.index(j).error(
                format!("there is no vertex {}", face[j]),
                format!("there are {count} vertices, counted from 0"),
            ));
        }
    }
    Ok(())
}

impl Resolver {
    /// Adds a polygon. With normals or surface coordinates at its corners it becomes triangles, which carry those.
    pub fn add_polygon(
        &mut self,
        header: &Header,
        material: u32,
        (loops, mut data): (Loops, VertexData),
    ) -> Result<(), SceneError> {
        let placed: Loops = loops.iter().map(|rim| placed(rim, header)).collect();
        let path = &header.path;
        let flat = self.flat_polygon(&placed, path, &header.name)?;
        // Colours are blended between the corners of triangles.
        let is_blended = header.shading == Some(ShadingModel::Gouraud);
        if is_blended && loops.len() > 1 {
            return Err(path.key("shading").error(
                "the colours of a polygon with holes cannot be blended between its corners",
                "use a mesh of triangles, or another shading",
            ));
        }
        let is_plain = data.normals.is_empty() && data.uvs.is_empty() && !is_blended;
        match (flat, loops.len()) {
            (Some(polygon), _) if is_plain => {
                self.begin(header, material)?;
                self.add_shape(Shape::Polygon(Box::new(polygon)), path)
            }
            (None, 2..) => Err(path.error(
                "the polygon has holes, and its corners do not lie in one plane",
                "move the corners into a plane, or use a mesh of triangles",
            )),
            _ => {
                let rim = loops.into_iter().next().unwrap_or_default();
                let cut = as_u32(&triangulate(&rim).0);
                if !data.normals.is_empty() {
                    data.normal_indices.clone_from(&cut);
                }
                if !data.uvs.is_empty() {
                    data.uv_indices.clone_from(&cut);
                }
                let mesh = Mesh {
                    points: rim.into(),
                    triangles: cut,
                    corners: data,
                    ..Mesh::default()
                };
                self.add_mesh(header, material, mesh)
            }
        }
    }

    /// Adds a mesh with faces of any number of corners. Where its corners carry more than points they are cut into triangles.
    pub fn add_faces(
        &mut self,
        header: &Header,
        material: u32,
        mut mesh: Mesh,
        faces: &[Vec<u32>],
    ) -> Result<(), SceneError> {
        let is_plain = mesh.corners.normals.is_empty()
            && mesh.corners.uvs.is_empty()
            && header.shading != Some(ShadingModel::Gouraud);
        let mut flat = Vec::new();
        for (face, i) in faces.iter().zip(0..) {
            let corners: Vec<DVec3> = face.iter().map(|v| mesh.points[*v as usize]).collect();
            if is_plain && face.len() > 3 {
                let loops = vec![placed(&corners, header)];
                let path = header.path.key("polygons").index(i);
                let found = self.flat_polygon(&loops, &path, &header.name);
                if let Ok(Some(polygon)) = found {
                    flat.push(polygon);
                    continue;
                }
            }
            let cut = as_u32(&triangulate(&corners).0);
            let cut = cut.iter().map(|t| t.map(|k| face[k as usize]));
            let lists = &mut mesh.corners;
            for triangle in cut {
                mesh.triangles.push(triangle);
                if !lists.normals.is_empty() {
                    lists.normal_indices.push(triangle);
                }
                if !lists.uvs.is_empty() {
                    lists.uv_indices.push(triangle);
                }
            }
        }
        if flat.is_empty() && self.keeps(header, material, mesh.triangles.len()) {
            match self.keep(header, material, (0, mesh))? {
                Some(few) => mesh = few,
                None => return Ok(()),
            }
        }
        self.add_mesh(header, material, mesh)?;
        for polygon in flat {
            self.add_shape(Shape::Polygon(Box::new(polygon)), &header.path)?;
        }
        Ok(())
    }

    /// The polygon of loops in the world, if its corners lie in a plane; else a warning says how far they are off.
    fn flat_polygon(
        &mut self,
        loops: &Loops,
        path: &FieldPath,
        name: &str,
    ) -> Result<Option<Polygon>, SceneError> {
        let polygon = Polygon::new(loops).ok_or_else(|| {
            path.error(
                format!("object `{name}`: a polygon has no area"),
                "give it three corners that are not on one line",
            )
        })?;
        if polygon.is_planar() {
            if polygon.crosses_itself() {
                let what = format!(
                    "object `{name}`: a polygon crosses itself: inside is what an odd number of its edges is around"
                );
                let cure = "give the corners in the order in which they lie on the rim";
                self.warnings
                    .add(WarningCode::CrossesItself, path.error(what, cure));
            }
            return Ok(Some(polygon));
        }
        let what = format!(
            "object `{name}`: a polygon is not flat, a corner is {:e} m off its plane: it is cut into triangles",
            polygon.deviation()
        );
        let cure = "move its corners into one plane, or give triangles";
        self.warnings
            .add(WarningCode::NotFlat, path.error(what, cure));
        Ok(None)
    }
}

fn as_u32(triangles: &[[usize; 3]]) -> Vec<[u32; 3]> {
    triangles.iter().map(|t| t.map(|i| i as u32)).collect()
}

/// Corners in the world. A mirror turns the loop, so that its front stays in front.
fn placed(corners: &[DVec3], header: &Header) -> Vec<DVec3> {
    let Some(map) = &header.to_world else {
        return corners.to_vec();
    };
    let carried = corners.iter().map(|corner| map.point(*corner));
    if map.flips_handedness() {
        carried.rev().collect()
    } else {
        carried.collect()
    }
}
