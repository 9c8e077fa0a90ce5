//! A triangle mesh on its way into the scene, in its own space.

use crate::math::DVec3;

use crate::scene::VertexData;

/// Points, triangles between them, and what the corners of those carry.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Points.
    pub points: Vec<DVec3>,
    /// Triples of indices into `points`.
    pub triangles: Vec<[u32; 3]>,
    /// Per triangle: where it stands in its file, for warnings. Empty: it is the triangle of the same number.
    pub lines: Vec<u32>,
    /// Normals and surface coordinates of the corners. A normal of zero stands for none.
    pub corners: VertexData,
}
