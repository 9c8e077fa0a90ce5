//! Triangle mesh in its own space, as read from a file.

use crate::math::DVec3;

use crate::scene::VertexData;

/// Points, triangles between them, and what the corners of those carry.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Points.
    pub points: Vec<DVec3>,
    /// Triples of indices into `points`.
    pub triangles: Vec<[u32; 3]>,
    /// Per triangle: its line in the file, for warnings. Empty if the index of the triangle says it.
    pub lines: Vec<u32>,
    /// Normals and surface coordinates of the corners. A normal of zero stands for none.
    pub corners: VertexData,
}
