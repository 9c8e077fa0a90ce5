//! The disc.

use std::f64::consts::TAU;

use super::{Aabb, Intersection, SurfacePoint};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Frame, Interval, Ray};

/// All points of a plane within `radius` of `center`. Outwards is where the normal points.
///
/// u runs once around, v from the centre (0) to the rim (1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// The centre.
    pub center: DVec3,
    /// u and v lie in the disc, w is its unit normal.
    pub frame: Frame,
    /// The radius, above 0.
    pub radius: f64,
}

impl Disc {
    /// The disc at right angles to the unit vector `normal`.
    pub fn new(center: DVec3, normal: DVec3, radius: f64) -> Self {
        let frame = Frame::around(normal);
        Self {
            center,
            frame,
            radius,
        }
    }

    /// The crossing t = n.(c - o) / (n.direction) with its plane, if that is within the radius. What is rounded acts as
    /// if the disc had been moved along its normal by a few u of the numbers in the numerator.
    #[inline(never)]
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        let (n, to_center) = (self.frame.w, self.center - ray.origin);
        let t = n.dot(to_center) / n.dot(ray.direction);
        let from_center = t * ray.direction - to_center;
        // A ray along the plane makes t infinite or NaN, and fails here.
        if from_center.length_squared() <= self.radius * self.radius {
            Intersection::classify(t, [0.0; 3], interval)
        } else {
            Intersection::Miss
        }
    }

    /// The point at `t`, pulled back into the plane. The bound covers what the next test of the same disc may round.
    pub fn surface(&self, ray: &Ray, t: f64) -> SurfacePoint {
        let Frame { u, v, w } = self.frame;
        let local = ray.at(t) - self.center;
        let [x, y] = [local.dot(u), local.dot(v)];
        let point = self.center + x * u + y * v;
        let max_coordinate = self.center.abs().max_element() + self.radius;
        SurfacePoint {
            point,
            error: DVec3::splat(gamma(64) * max_coordinate),
            normal: w,
            uv: DVec2::new(
                libm::atan2(-y, -x) / TAU + 0.5,
                libm::hypot(x, y) / self.radius,
            ),
        }
    }

    /// The box around the disc, a little wider than computed: along an axis, r sin of the angle between it and the
    /// normal.
    pub fn bounds(&self) -> Aabb {
        let n = self.frame.w;
        let extent = (DVec3::ONE - n * n).max(DVec3::ZERO).map(f64::sqrt) * self.radius;
        // 1 - n^2 loses digits where n is nearly 1: it may be wrong by 4 u, its root by 2 sqrt(u).
        let lost = DVec3::splat(4e-8 * self.radius);
        let pad = gamma(16) * (self.center.abs() + DVec3::splat(self.radius));
        let on_axis = n.abs().max_element() == 1.0;
        Aabb {
            min: self.center - extent,
            max: self.center + extent,
        }
        .padded(if on_axis { pad } else { pad + lost })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_is_met_within_its_radius_from_both_sides() {
        let disc = Disc::new(DVec3::new(0.0, 1.0, 0.0), DVec3::Y, 0.5);
        let test = |x: f64, from: f64| {
            let origin = DVec3::new(x, from, 0.0);
            let down = DVec3::new(0.0, 1.0 - from, 0.0).normalize();
            disc.intersect(&Ray::new(origin, down), Interval::FORWARD)
        };
        for x in [0.0, 0.5, -0.5] {
            for from in [3.0, -1.0] {
                assert!(matches!(test(x, from), Intersection::Hit { t: 2.0, .. }));
            }
        }
        assert_eq!(test(0.5f64.next_up(), 3.0), Intersection::Miss);
        let along = Ray::new(DVec3::new(-2.0, 1.0, 0.0), DVec3::X);
        assert_eq!(
            disc.intersect(&along, Interval::FORWARD),
            Intersection::Miss
        );
    }

    #[test]
    fn the_box_holds_the_rim() {
        for normal in [
            DVec3::Z,
            DVec3::new(1e-5, 1.0, 0.0),
            DVec3::new(1.0, 2.0, 3.0),
        ] {
            let disc = Disc::new(DVec3::new(1.0, 2.0, 3.0), normal.normalize(), 2.0);
            let bounds = disc.bounds();
            for i in 0..1000 {
                let (sin, cos) = libm::sincos(TAU * f64::from(i) / 1000.0);
                let rim = disc.center + 2.0 * (cos * disc.frame.u + sin * disc.frame.v);
                assert!(rim.cmpge(bounds.min).all() && rim.cmple(bounds.max).all());
            }
        }
    }
}
