//! Triangle mesh in its own space, as read from a file.

use std::sync::Arc;

use rayon::prelude::*;

use crate::geometry::Triangle;
use crate::math::{DVec2, DVec3, Transform};
use crate::scene::{VertexData, carried_normal};

/// Points, triangles between them, and what the corners of those carry.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Points. The parts of a model share theirs.
    pub points: Arc<Vec<DVec3>>,
    /// Triples of indices into `points`.
    pub triangles: Vec<[u32; 3]>,
    /// Per triangle: its line in the file, for warnings. Empty if the index of the triangle says it.
    pub lines: Vec<u32>,
    /// Normals and surface coordinates of the corners. A normal of zero stands for none.
    pub corners: VertexData,
}

impl Mesh {
    /// Its triangles.
    pub fn corners_of_all(&self) -> impl Iterator<Item = Triangle> {
        let corners = |t: &[u32; 3]| t.map(|i| self.points[i as usize]);
        self.triangles.iter().map(move |t| Triangle {
            corners: corners(t),
        })
    }

    /// Moves its points and normals.
    pub fn place(&mut self, map: &Transform) {
        let points = Arc::make_mut(&mut self.points);
        points.par_iter_mut().for_each(|p| *p = map.point(*p));
        let mirror = map.axis_mirror();
        for n in Arc::make_mut(&mut self.corners.normals) {
            *n = carried_normal(*n, map, mirror);
        }
    }

    /// Turns its triangles around: in a mirror, what ran counter-clockwise runs clockwise.
    pub fn turn(&mut self) {
        // Without texture coordinates of its own a triangle's u and v are the shares of its second and third corner.
        if self.corners.uv_indices.is_empty() {
            self.corners.uvs = vec![DVec2::ZERO, DVec2::X, DVec2::Y].into();
            self.corners.uv_indices = vec![[0, 1, 2]; self.triangles.len()];
        }
        let lists = [
            &mut self.triangles,
            &mut self.corners.normal_indices,
            &mut self.corners.uv_indices,
        ];
        for triangle in lists.into_iter().flatten() {
            triangle.swap(1, 2);
        }
    }

    /// The mesh with points, normals and texture coordinates of another, whose triangles it has.
    pub fn sharing(mut self, other: &Self) -> Self {
        self.points = Arc::clone(&other.points);
        self.corners.normals = Arc::clone(&other.corners.normals);
        self.corners.uvs = Arc::clone(&other.corners.uvs);
        self
    }
}
