//! A triangle in a tree's space, in single precision: for trees whose leaves only name their primitives.

use super::hits::{Hits, each};
use super::rays::Rays;
use crate::accel::filter::doubt;
use crate::accel::local::{Frame, round_up};
use crate::accel::simd::Level;
use crate::geometry::Shape;

/// The corners of a triangle; nothing of another shape, which is tested as it is.
#[derive(Clone, Copy, Debug)]
pub struct Outline {
    /// Of each coordinate each corner.
    corners: [[f32; 3]; 3],
    /// It is not larger along an axis. Infinite for what is no triangle.
    size: f32,
}

impl Outline {
    /// The outline of a shape.
    pub fn of(frame: &Frame, shape: &Shape) -> Self {
        let Shape::Triangle(triangle) = shape else {
            return Self {
                corners: [[0.0; 3]; 3],
                size: f32::INFINITY,
            };
        };
        let size = triangle.bounds().size().max_element() * frame.scale;
        let [a, b, c] = triangle.corners.map(|p| frame.point(p));
        Self {
            corners: std::array::from_fn(|k| [a[k], b[k], c[k]]),
            size: round_up(size),
        }
    }

    /// Tests the primitive that this is the outline of against the rays of the mask `met`.
    #[inline(always)]
    pub fn meet<const ANY: bool, L: Level>(
        &self,
        level: L,
        (rays, hits): (&mut Rays, &mut Hits),
        primitive: u32,
        met: u32,
    ) {
        if self.size == f32::INFINITY {
            for i in each(met) {
                hits.test::<ANY>(rays, i, primitive);
            }
            return;
        }
        let [x, y, z] = rays.axes;
        let corners = [self.corners[x], self.corners[y], self.corners[z]];
        let doubt = doubt(self.size, rays.pad);
        hits.meet_triangle::<ANY, L>(level, rays, corners, doubt, primitive, met);
    }
}
