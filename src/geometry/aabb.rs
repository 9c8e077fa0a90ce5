//! Axis-aligned bounding boxes.

use crate::math::rounding::gamma;
use crate::math::{DVec3, Interval, Ray, Transform};

/// The points with `min <= p <= max` on each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the smallest coordinates.
    pub min: DVec3,
    /// The corner with the largest.
    pub max: DVec3,
}

impl Aabb {
    /// The box around nothing: joining it with another box gives that box.
    pub const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };

    /// The smallest box around some points.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Self {
            min: b.min.min(p),
            max: b.max.max(p),
        })
    }

    /// The smallest box around both.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// The box grown by `by` on every side.
    pub fn padded(self, by: DVec3) -> Self {
        Self {
            min: self.min - by,
            max: self.max + by,
        }
    }

    /// True if nothing is inside.
    pub fn is_empty(self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// The middle.
    pub fn center(self) -> DVec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// The lengths of the edges.
    pub fn size(self) -> DVec3 {
        self.max - self.min
    }

    /// The area of the six faces; 0 for an empty box.
    pub fn surface_area(self) -> f64 {
        let s = self.size().max(DVec3::ZERO);
        2.0 * (s.x * s.y + s.y * s.z + s.z * s.x)
    }

    /// The sides as loops of [`Aabb::corners`], counter-clockwise as seen from outside: low x, high x, low y, and so on.
    pub const SIDES: [[usize; 4]; 6] = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];

    /// The eight corners: number i has the upper bound where i has a one, x being bit 0.
    pub fn corners(self) -> [DVec3; 8] {
        std::array::from_fn(|i| {
            let pick = |axis: usize| {
                if i >> axis & 1 == 0 {
                    self.min[axis]
                } else {
                    self.max[axis]
                }
            };
            DVec3::new(pick(0), pick(1), pick(2))
        })
    }

    /// A box in the world around this box in object space, grown by what the transform rounds.
    pub fn transformed(self, transform: &Transform) -> Self {
        self.corners().into_iter().fold(Self::EMPTY, |b, corner| {
            let p = transform.point(corner);
            let e = transform.point_error(corner, DVec3::ZERO);
            b.union(Self {
                min: p - e,
                max: p + e,
            })
        })
    }

    /// True if the ray's line misses the ball around the box by far. (The middle is rounded by a unit of its coordinates: the box must
    /// be wider than what it holds by that, as `bounds` of all shapes are.)
    #[inline]
    pub fn is_passed_by_far(&self, ray: &Ray) -> bool {
        let f = ray.origin - self.center();
        let (a, b) = (ray.direction.length_squared(), f.dot(ray.direction));
        let radius_squared = 0.25 * self.size().length_squared();
        passes_ball_by_far([a, b, f.length_squared()], radius_squared)
    }

    /// The part of `interval` in which the ray is inside the box, or `None`.
    ///
    /// Conservative: the exits are moved outwards by 2 gamma_3, so that no ray that touches the box is turned away
    /// by rounding. Source: Ize 2013, "Robust BVH ray traversal".
    pub fn clip(&self, ray: &Ray, interval: Interval) -> Option<Interval> {
        let Interval { min, max } = interval;
        let (mut enter, mut exit) = (min, max);
        for axis in 0..3 {
            let (o, d) = (ray.origin[axis], ray.direction[axis]);
            if d == 0.0 {
                // Along the slab: inside it for ever, or never.
                if o < self.min[axis] || o > self.max[axis] {
                    return None;
                }
                continue;
            }
            let (near, far) = if d > 0.0 {
                (self.min[axis], self.max[axis])
            } else {
                (self.max[axis], self.min[axis])
            };
            let (t0, t1) = ((near - o) / d, (far - o) / d);
            // Each t is within gamma_3 of the true one, relatively; the box must not shrink by that.
            enter = enter.max(t0 - t0.abs() * 2.0 * gamma(3));
            exit = exit.min(t1 + t1.abs() * 2.0 * gamma(3));
        }
        (enter <= exit).then_some(Interval::new(enter, exit))
    }
}

/// Part of the square of the centre's distance by which a line misses for sure: rounding makes less than 64 x 2^-53 of it.
const FAR: f64 = 1e-12;

/// True if a line misses a ball by far: |f|^2 a - b^2 > r^2 a, by much more than is rounded, with a = d.d and b = f.d, f from the
/// centre to the origin. It takes no division.
#[inline(always)]
pub fn passes_ball_by_far([a, b, distance_squared]: [f64; 3], radius_squared: f64) -> bool {
    distance_squared * a - b * b > a * (radius_squared + FAR * distance_squared)
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Aabb = Aabb {
        min: DVec3::ZERO,
        max: DVec3::ONE,
    };

    #[test]
    fn a_ray_through_the_middle_is_inside_from_1_to_2() {
        let ray = Ray::new(DVec3::new(0.5, 0.5, -1.0), DVec3::Z);
        let inside = UNIT
            .clip(&ray, Interval::FORWARD)
            .expect("through the middle");
        assert!(inside.min <= 1.0 && inside.max >= 2.0);
        assert!(inside.min > 1.0 - 1e-15 && inside.max < 2.0 + 1e-14);
    }

    #[test]
    fn a_ray_in_a_face_touches_the_box() {
        let along = |x| Ray::new(DVec3::new(x, 0.5, -1.0), DVec3::Z);
        assert!(UNIT.clip(&along(1.0), Interval::FORWARD).is_some());
        assert!(
            UNIT.clip(&along(1.0f64.next_up()), Interval::FORWARD)
                .is_none()
        );
    }
}
