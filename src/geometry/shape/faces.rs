//! The triangles of a shape, in the world: its own, or those of a mesh that is kept once.

use super::Shape;
use crate::geometry::{SharedMesh, Triangle};
use crate::math::Transform;

impl Shape {
    /// The mesh that this is a use of, and the way from its space into the world, if that is not the same.
    pub fn mesh(&self) -> Option<(&SharedMesh, Option<&Transform>)> {
        match self.plain() {
            Self::Mesh(mesh) => Some((mesh, None)),
            Self::Transformed(moved) => match &moved.shape {
                Self::Mesh(mesh) => Some((mesh, Some(&moved.transform))),
                _ => None,
            },
            _ => None,
        }
    }

    /// True for a use of a mesh that is a mirror image of it: its triangles in the world have their second and third corner
    /// swapped, so that they still run counter-clockwise.
    pub fn is_mirror_image(&self) -> bool {
        let map = self.mesh().and_then(|(_, map)| map);
        map.is_some_and(Transform::flips_handedness)
    }

    /// A triangle of it in the world, counter-clockwise as seen from outside: itself, or that part of the mesh that it is a use of.
    pub fn triangle(&self, part: u32) -> Option<Triangle> {
        let Some((mesh, map)) = self.mesh() else {
            return match self.plain() {
                Self::Triangle(triangle) if part == 0 => Some(*triangle),
                _ => None,
            };
        };
        let triangle = *mesh.triangles().get(part as usize)?;
        let Some(map) = map else {
            return Some(triangle);
        };
        let [a, b, c] = triangle.corners.map(|corner| map.point(corner));
        let mirrored = map.flips_handedness();
        let corners = if mirrored { [a, c, b] } else { [a, b, c] };
        Some(Triangle { corners })
    }

    /// How many triangles it has.
    pub fn triangle_count(&self) -> u32 {
        match (self.mesh(), self.plain()) {
            (Some((mesh, _)), _) => mesh.triangles().len() as u32,
            (None, Self::Triangle(_)) => 1,
            _ => 0,
        }
    }

    /// All of them, by part.
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> {
        (0..self.triangle_count()).filter_map(|part| self.triangle(part))
    }
}
