//! How far from a shape a hit of it may seem to lie, and so how thick everything that parts space must be taken.

use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;
use crate::math::rounding::{UNIT_ROUNDOFF, gamma};

/// How thick a plane must be taken, so that no hit slips by unseen.
///
/// With all coordinates below `reach` and a ray from o, these errors add up, in units of u (reach + |o|): the tests
/// of triangles (40), spheres (64) or boxes (6); telling a point's side when the tree was built (40); cutting, at
/// most 4 for each of 62 planes; the traversal's own distance and division (32). The sum is below 512; it is doubled
/// once more, since thick planes cost nothing. Shapes that are tested in their own space add the square of their
/// transform's condition number, 64 times: the inverse is only known that well.
#[derive(Clone, Copy, Debug)]
pub struct Slack {
    factor: f64,
    reach: f64,
}

impl Slack {
    /// Shapes whose transform is worse conditioned than this are not put into the tree.
    pub const MAX_CONDITION: f64 = 4096.0;
    /// Nor are shapes with coordinates beyond this, whose areas would overflow.
    pub const MAX_REACH: f64 = 1e150;

    /// For coordinates up to `reach` and transforms of this condition number at most (0: none).
    pub fn new(reach: f64, condition: f64) -> Self {
        Self {
            factor: (1024.0 + 64.0 * condition * condition) * UNIT_ROUNDOFF,
            reach,
        }
    }

    /// The thickness for a ray whose origin has coordinates up to `farthest`.
    #[inline(always)]
    pub fn within(&self, farthest: f64) -> f64 {
        self.factor * (self.reach + farthest)
    }

    /// The thickness on each side, in metres, for a ray from `origin`.
    pub fn around(&self, origin: DVec3) -> f64 {
        self.within(origin.abs().max_element())
    }
}

/// The largest number that a shape is made of, and how much its transform magnifies errors (0 without one).
pub fn conditioning(shape: &Shape) -> (f64, f64) {
    let bounds = shape.bounds().unwrap_or(Aabb::EMPTY);
    let reach = bounds.min.abs().max(bounds.max.abs()).max_element();
    let Shape::Placed(placed) = shape.plain() else {
        return (reach, 0.0);
    };
    let local = placed.shape.bounds().unwrap_or(Aabb::EMPTY);
    // The error of a transformed point is gamma_3 times the sum of the numbers it was made of.
    let rounded = |corner| placed.transform.point_error(corner, DVec3::ZERO);
    let largest = local
        .corners()
        .into_iter()
        .map(|corner| rounded(corner).max_element() / gamma(3))
        .fold(reach, f64::max);
    (largest, placed.transform.condition())
}
