//! The endless plane.

use super::{Intersection, SurfacePoint};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Frame, Interval, Ray};

/// All points p with n.p = d. Outwards is where the unit normal n points.
///
/// u and v are metres along two axes of the plane, counted from the point it was given by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    point: DVec3,
    frame: Frame,
    d: f64,
}

impl Plane {
    /// The plane through `point` at right angles to the unit vector `normal`.
    pub fn new(point: DVec3, normal: DVec3) -> Self {
        Self {
            point,
            frame: Frame::around(normal),
            d: normal.dot(point),
        }
    }

    /// The point that it was given by.
    pub fn origin(&self) -> DVec3 {
        self.point
    }

    /// The unit normal.
    pub fn normal(&self) -> DVec3 {
        self.frame.w
    }

    /// The crossing t = (d - n.o) / (n.direction); a ray along the plane misses it, even inside it.
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        let n = self.normal();
        let t = (self.d - n.dot(ray.origin)) / n.dot(ray.direction);
        if t.is_finite() {
            Intersection::classify(t, [0.0; 3], interval)
        } else {
            Intersection::Miss
        }
    }

    /// The point at `t`, pulled back into the plane.
    pub fn surface(&self, ray: &Ray, t: f64) -> SurfacePoint {
        let n = self.normal();
        let p = ray.at(t);
        let point = p - (n.dot(p) - self.d) * n;
        // n.p - d is a sum of four products, each within gamma_4; it moves the point along n.
        let residual = gamma(6) * (n.abs().dot(point.abs()) + self.d.abs());
        let on_axis = n.abs().max_element() == 1.0;
        let local = point - self.point;
        SurfacePoint {
            point,
            // A plane along the axes is met without error: one coordinate is d itself.
            error: if on_axis {
                DVec3::ZERO
            } else {
                residual * n.abs() + gamma(2) * point.abs()
            },
            normal: n,
            uv: DVec2::new(local.dot(self.frame.u), local.dot(self.frame.v)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_is_met_once_and_only_in_front() {
        let floor = Plane::new(DVec3::ZERO, DVec3::Y);
        let from = DVec3::new(0.0, 2.0, 0.0);
        let test = |d: DVec3| floor.intersect(&Ray::new(from, d), Interval::FORWARD);
        assert!(matches!(
            test(DVec3::NEG_Y),
            Intersection::Hit { t: 2.0, .. }
        ));
        assert_eq!(test(DVec3::Y), Intersection::Behind(-2.0));
        assert_eq!(test(DVec3::X), Intersection::Miss);
        let inside = Ray::new(DVec3::ZERO, DVec3::X);
        assert_eq!(
            floor.intersect(&inside, Interval::FORWARD),
            Intersection::Miss
        );
    }

    #[test]
    fn points_of_a_level_floor_are_exactly_on_it() {
        let floor = Plane::new(DVec3::new(0.0, 0.1, 0.0), DVec3::Y);
        let ray = Ray::new(
            DVec3::new(0.3, 7.7, 0.0),
            DVec3::new(0.3, -0.7, 0.1).normalize(),
        );
        let Intersection::Hit { t, .. } = floor.intersect(&ray, Interval::FORWARD) else {
            panic!("the ray goes down");
        };
        assert_eq!(floor.surface(&ray, t).point.y, 0.1);
    }
}
