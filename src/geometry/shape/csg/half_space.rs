//! The half-space: all that lies behind a plane.

use crate::geometry::{Aabb, Intersection, Plane, Span, SurfacePoint};
use crate::math::{DVec3, Interval, Ray};

/// All points on the side of a plane from which its normal points away. It has no end, so it only cuts other solids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    /// Its face; the normal points outwards.
    pub plane: Plane,
}

impl HalfSpace {
    /// The box around all space.
    pub(super) const EVERYWHERE: Aabb = Aabb {
        min: DVec3::NEG_INFINITY,
        max: DVec3::INFINITY,
    };

    /// The half-space behind the plane through `point` at right angles to the unit vector `normal`.
    pub fn new(point: DVec3, normal: DVec3) -> Self {
        Self {
            plane: Plane::new(point, normal),
        }
    }

    /// The part of the ray's line inside: a half-line, all of a line that runs along the plane behind it, or nothing.
    pub fn span(&self, ray: &Ray) -> Option<Span> {
        let everything = Interval::LINE;
        let n = self.plane.normal();
        match self.plane.intersect(ray, everything) {
            Intersection::Hit { t, .. } if n.dot(ray.direction) < 0.0 => {
                Some(Span::between(t, f64::INFINITY))
            }
            Intersection::Hit { t, .. } => Some(Span::between(f64::NEG_INFINITY, t)),
            // The line never crosses: all of it is on the side that it starts on. NaN is on neither.
            _ => (n.dot(ray.origin - self.plane.origin()) <= 0.0)
                .then(|| Span::between(f64::NEG_INFINITY, f64::INFINITY)),
        }
    }

    /// The point at `t`, pulled back into the plane.
    pub fn surface(&self, ray: &Ray, t: f64) -> SurfacePoint {
        self.plane.surface(ray, t)
    }

    /// The box around it: a plane at right angles to an axis ends it on one side, any other plane on none.
    pub fn bounds(&self) -> Aabb {
        let (n, origin) = (self.plane.normal(), self.plane.origin());
        let mut bounds = Self::EVERYWHERE;
        for axis in 0..3 {
            if n[axis] == 1.0 {
                bounds.max[axis] = origin[axis];
            } else if n[axis] == -1.0 {
                bounds.min[axis] = origin[axis];
            }
        }
        bounds
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_inside_behind_the_plane() {
        let ground = HalfSpace::new(DVec3::Y, DVec3::Y);
        let span = |o: DVec3, d: DVec3| {
            let span = ground.span(&Ray::new(o, d))?;
            Some([span.enter.t, span.leave.t])
        };
        let up = DVec3::Y * 2.0;
        assert_eq!(span(-up, up), Some([f64::NEG_INFINITY, 1.5]));
        assert_eq!(span(up, -up), Some([0.5, f64::INFINITY]));
        let all = Some([f64::NEG_INFINITY, f64::INFINITY]);
        assert_eq!(span(DVec3::ZERO, DVec3::X), all);
        assert_eq!(span(DVec3::Y, DVec3::X), all);
        assert_eq!(span(up, DVec3::X), None);
        assert_eq!(span(DVec3::NAN, DVec3::X), None);
        assert_eq!(span(up, DVec3::NAN), None);
    }

    #[test]
    fn only_planes_along_the_axes_bound() {
        let wall = HalfSpace::new(DVec3::splat(2.0), DVec3::NEG_X);
        assert_eq!(wall.bounds().min.x, 2.0);
        assert_eq!(wall.bounds().max, DVec3::INFINITY);
        let roof = HalfSpace::new(DVec3::ZERO, DVec3::ONE.normalize());
        assert_eq!(roof.bounds(), HalfSpace::EVERYWHERE);
    }
}
