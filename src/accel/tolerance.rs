//! Tolerance of a traversal: how far off its shape a computed hit may lie, and so how thick planes and volumes are taken.

use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;
use crate::math::rounding::{UNIT_ROUNDOFF, gamma};

/// Thickness of planes and volumes that loses no hit, in metres.
///
/// With all coordinates below `max_coordinate` = m and a ray from o, these errors add up, in units of u (m + |o|): the tests
/// of triangles (40), spheres (64) or boxes (6); telling a point's side when the tree was built (40); cutting, at
/// most 4 for each of 62 planes; the traversal's own distance and division (32). The sum is below 512; it is doubled
/// once more, since thick planes cost nothing. Shapes that are tested in their own space add the square of their
/// transform's condition number, 64 times: the inverse is only known that well.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    factor: f64,
    /// The largest coordinate of any shape.
    pub max_coordinate: f64,
}

impl Tolerance {
    /// Shapes whose transform is worse conditioned than this are not put into the tree.
    pub const MAX_CONDITION: f64 = 4096.0;
    /// Nor are shapes with coordinates beyond this, whose areas would overflow.
    pub const MAX_COORDINATE: f64 = 1e150;

    /// For coordinates up to `max_coordinate` and transforms of this condition number at most (0: none).
    pub fn new(max_coordinate: f64, condition: f64) -> Self {
        Self {
            factor: (1024.0 + 64.0 * condition * condition) * UNIT_ROUNDOFF,
            max_coordinate,
        }
    }

    /// The thickness for a ray whose origin has coordinates up to `farthest`.
    #[inline(always)]
    pub fn for_coordinate(&self, farthest: f64) -> f64 {
        self.factor * (self.max_coordinate + farthest)
    }

    /// The thickness on each side, in metres, for a ray from `origin`.
    pub fn for_origin(&self, origin: DVec3) -> f64 {
        self.for_coordinate(origin.abs().max_element())
    }
}

/// The largest number that a shape is made of, and how much its transform magnifies errors (0 without one).
pub fn conditioning(shape: &Shape) -> (f64, f64) {
    let bounds = shape.bounds().unwrap_or(Aabb::EMPTY);
    let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
    let Shape::Transformed(transformed) = shape.plain() else {
        return (largest, 0.0);
    };
    let local = transformed.shape.bounds().unwrap_or(Aabb::EMPTY);
    // The error of a transformed point is gamma_3 times the sum of the numbers it was made of.
    let rounded = |corner| transformed.transform.point_error(corner, DVec3::ZERO);
    let largest = local
        .corners()
        .into_iter()
        .map(|corner| rounded(corner).max_element() / gamma(3))
        .fold(largest, f64::max);
    (largest, transformed.transform.condition())
}
