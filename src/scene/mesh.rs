//! A triangle mesh on its way into the scene, in its own space.

use crate::math::{DVec2, DVec3};

use super::VertexData;

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

impl Mesh {
    /// Puts another mesh into this one. If only one of them has normals or surface coordinates, the other gets those
    /// that change nothing.
    pub fn append(&mut self, mut other: Self) {
        let (mine, others) = (&mut self.corners, &mut other.corners);
        if mine.normal_indices.is_empty() != others.normal_indices.is_empty() {
            mine.complete_normals(self.triangles.len());
            others.complete_normals(other.triangles.len());
        }
        if mine.uv_indices.is_empty() != others.uv_indices.is_empty() {
            mine.complete_uvs(self.triangles.len());
            others.complete_uvs(other.triangles.len());
        }
        let shifted = |list: &[[u32; 3]], by: usize| -> Vec<[u32; 3]> {
            list.iter().map(|t| t.map(|i| i + by as u32)).collect()
        };
        self.triangles
            .extend(shifted(&other.triangles, self.points.len()));
        self.points.extend(other.points);
        self.lines.extend(other.lines);
        mine.normal_indices
            .extend(shifted(&others.normal_indices, mine.normals.len()));
        mine.normals.append(&mut others.normals);
        mine.uv_indices
            .extend(shifted(&others.uv_indices, mine.uvs.len()));
        mine.uvs.append(&mut others.uvs);
    }
}

impl VertexData {
    /// No normal for each of so many triangles that have none.
    fn complete_normals(&mut self, triangles: usize) {
        if self.normal_indices.is_empty() {
            self.normals = vec![DVec3::ZERO];
            self.normal_indices = vec![[0; 3]; triangles];
        }
    }

    /// The weights of the second and third corner as surface coordinates: what a bare triangle has.
    fn complete_uvs(&mut self, triangles: usize) {
        if self.uv_indices.is_empty() {
            self.uvs = vec![DVec2::ZERO, DVec2::X, DVec2::Y];
            self.uv_indices = vec![[0, 1, 2]; triangles];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flat_mesh_stays_flat_beside_a_smooth_one() {
        let flat = Mesh {
            points: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        };
        let mut both = flat.clone();
        both.corners.normals = vec![DVec3::Z];
        both.corners.normal_indices = vec![[0; 3]];
        both.append(flat);
        assert_eq!(both.triangles, [[0, 1, 2], [3, 4, 5]]);
        let third = [1.0 / 3.0; 3];
        assert_eq!(both.corners.normal(0, third), Some(DVec3::Z));
        assert_eq!(both.corners.normal(1, third), None);
    }
}
