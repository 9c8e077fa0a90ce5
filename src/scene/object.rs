//! Objects of a scene, and the normals and texture coordinates of meshes.

use std::sync::Arc;

use crate::math::{DVec2, DVec3, Transform};
use crate::shading::ShadingModel;

/// Object: a named part of the scene with one material and one or many primitives.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its name, unique in the scene; groups are named before it: `group/part`.
    pub name: String,
    /// Index of its material.
    pub material: u32,
    /// How it is shaded, if it says so and is made of triangles and polygons.
    pub shading: Option<ShadingModel>,
    /// The id of its first primitive.
    pub first_primitive: u32,
    /// True if it is a mesh that a transform mirrors: its triangles have their second and third corner swapped, so that they still
    /// run counter-clockwise.
    pub mirrored: bool,
    /// Normals and texture coordinates at its corners, if it is a mesh that has any.
    pub vertices: Option<Arc<VertexData>>,
    /// True if its one shape is a use of a mesh that is kept once: then the part of a hit is the triangle, and `vertices` are in
    /// the space of that mesh, shared by all its uses.
    pub instance: bool,
    /// The leaves of a solid that is cut from others.
    pub leaves: Vec<Leaf>,
    /// Index of the frame of the group that it stands in.
    pub frame: Option<u32>,
}

/// Leaf of a solid that is cut from others: what a user reads of it.
#[derive(Clone, Debug)]
pub struct Leaf {
    /// Its name, after that of the whole: `whole/part`.
    pub name: String,
    /// Index of its material.
    pub material: u32,
}

/// Normals and texture coordinates at the corners of a mesh's triangles.
#[derive(Clone, Debug, Default)]
pub struct VertexData {
    /// Per triangle of the object: the three indices into `normals`. Empty for a flat mesh.
    pub normal_indices: Vec<[u32; 3]>,
    /// Unit normals in world space, or that of a mesh that is kept once. The parts of a model share theirs.
    pub normals: Arc<Vec<DVec3>>,
    /// Per triangle of the object: the three indices into `uvs`. Empty if it has none.
    pub uv_indices: Vec<[u32; 3]>,
    /// Texture coordinates, shared likewise.
    pub uvs: Arc<Vec<DVec2>>,
    /// True if the normals are those of a curved surface that the triangles stand for. Such a mesh does not
    /// call for the effect `smooth`, and to leave that out does not make it flat.
    pub of_surface: bool,
}

impl Object {
    /// What a triangle's corners have, in the order in which the file has these.
    pub fn in_order_of_file<T>(&self, [a, b, c]: [T; 3]) -> [T; 3] {
        if self.mirrored { [a, c, b] } else { [a, b, c] }
    }

    /// True if it is a mesh whose normals are blended between its corners.
    pub fn is_smooth(&self) -> bool {
        let vertices = self.vertices.as_ref();
        vertices.is_some_and(|data| !data.normal_indices.is_empty() && !data.of_surface)
    }
}

/// A corner's normal in the world; one of zero stands for none. `mirror` is the map's [`Transform::axis_mirror`], which keeps the length
/// of a normal, to the bit.
pub fn carried_normal(n: DVec3, map: &Transform, mirror: Option<DVec3>) -> DVec3 {
    match mirror {
        _ if n == DVec3::ZERO => n,
        Some(signs) => n * signs,
        None => map.normal(n),
    }
}

impl VertexData {
    /// To be shared; `None` if the corners carry nothing.
    pub fn unless_plain(self) -> Option<Arc<Self>> {
        let plain = self.normal_indices.is_empty() && self.uv_indices.is_empty();
        (!plain).then(|| Arc::new(self))
    }

    /// Shading normal at barycentric coordinates, interpolated between the corners (Phong 1975): unit, or `None` if the mesh
    /// is flat or they cancel out.
    pub fn normal(&self, triangle: usize, barycentric: [f64; 3]) -> Option<DVec3> {
        self.blended_normal(triangle, barycentric)?.try_normalize()
    }

    /// The sum of the corners' normals, each times its weight: not unit. `None` if the mesh is flat.
    pub fn blended_normal(&self, triangle: usize, [u, v, w]: [f64; 3]) -> Option<DVec3> {
        let [a, b, c] = *self.normal_indices.get(triangle)?;
        let n = |i: u32| self.normals[i as usize];
        Some(u * n(a) + v * n(b) + w * n(c))
    }

    /// Texture coordinates at barycentric coordinates, interpolated between the corners.
    pub fn uv(&self, triangle: usize, [u, v, w]: [f64; 3]) -> Option<DVec2> {
        let [a, b, c] = *self.uv_indices.get(triangle)?;
        let p = |i: u32| self.uvs[i as usize];
        Some(u * p(a) + v * p(b) + w * p(c))
    }
}
