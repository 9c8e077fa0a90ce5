//! Triangle in a tree's space, in single precision: for trees whose leaves only have the ids of their primitives.

use super::hits::{PacketHits, set_bits};
use super::rays::RayPacket;
use crate::accel::fast::local_ray::{UnitBox, round_up};
use crate::accel::fast::simd::Level;
use crate::accel::fast::triangle_filter::edge_error;
use crate::geometry::Shape;

/// Corners of a triangle in single precision; nothing of another shape, which is tested in double precision.
#[derive(Clone, Copy, Debug)]
pub struct TriangleF32 {
    /// Of each coordinate each corner.
    corners: [[f32; 3]; 3],
    /// It is not larger along an axis. Infinite for what is no triangle.
    size: f32,
}

impl TriangleF32 {
    /// The triangle of a shape.
    pub fn of(unit_box: &UnitBox, shape: &Shape) -> Self {
        let Shape::Triangle(triangle) = shape else {
            return Self {
                corners: [[0.0; 3]; 3],
                size: f32::INFINITY,
            };
        };
        let size = triangle.bounds().size().max_element() * unit_box.scale;
        let [a, b, c] = triangle.corners.map(|p| unit_box.point(p));
        Self {
            corners: std::array::from_fn(|k| [a[k], b[k], c[k]]),
            size: round_up(size),
        }
    }

    /// Tests the primitive that this is the triangle of against the rays of the mask `met`.
    #[inline(always)]
    pub fn test<const ANY: bool, L: Level>(
        &self,
        level: L,
        rays: &mut RayPacket,
        hits: &mut PacketHits,
        primitive: u32,
        met: u32,
    ) {
        if self.size == f32::INFINITY {
            for i in set_bits(met) {
                hits.test::<ANY>(rays, i, primitive);
            }
            return;
        }
        let [x, y, z] = rays.axes;
        let corners = [self.corners[x], self.corners[y], self.corners[z]];
        let error = edge_error(self.size, rays.pad);
        hits.test_triangle::<ANY, L>(level, rays, corners, error, primitive, met);
    }
}
