//! A ray with its origin moved along itself to where it comes closest to a shape's middle.

use crate::geometry::Cut;
use crate::math::{DVec3, Ray};

/// The ray's line with a near origin: o' + t' d, where t = t_c + t'.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moved {
    /// o, where the ray starts.
    start: DVec3,
    /// o', the point of closest approach, but for rounding of t_c.
    pub origin: DVec3,
    /// d, as it was.
    pub direction: DVec3,
    /// t_c, the ray parameter of o'.
    pub t_c: f64,
}

impl Moved {
    /// What [`Moved::to_closest`] takes, so as to measure each axis in multiples of a shape's size along it: W = 1/size^2.
    pub fn weights(size: DVec3) -> DVec3 {
        (size * size).recip()
    }

    /// The ray moved to its closest approach to `center`: t_c = (center - o).W d / d.W d. Measured in multiples of the size, so
    /// that a ray that crosses a needle is moved into the needle.
    ///
    /// It does not matter that t_c is rounded, only that o' lies on the line. o + t_c d is rounded once for each coordinate (a
    /// fused multiply and add), so o' is off by at most u |o'|, however far o is.
    pub fn to_closest(ray: &Ray, center: DVec3, weights: DVec3) -> Self {
        let d = ray.direction;
        let weighted = weights * d;
        let t_c = (center - ray.origin).dot(weighted) / d.dot(weighted);
        Self {
            start: ray.origin,
            origin: on_ray(ray, t_c),
            direction: d,
            t_c,
        }
    }

    /// The ray as it is.
    pub fn not_at_all(ray: &Ray) -> Self {
        Self {
            start: ray.origin,
            origin: ray.origin,
            direction: ray.direction,
            t_c: 0.0,
        }
    }

    /// t' where the line crosses a plane at right angles to an axis: from o' or from o, whichever is nearer to the plane. So a
    /// ray that starts in a plane crosses it there, however flat it runs.
    pub fn at_plane(&self, axis: usize, plane: f64) -> f64 {
        let (from_start, from_origin) = (plane - self.start[axis], plane - self.origin[axis]);
        if from_start.abs() < from_origin.abs() {
            from_start / self.direction[axis] - self.t_c
        } else {
            from_origin / self.direction[axis]
        }
    }

    /// A cut of the moved line as seen from the ray's own origin. That with a plane is computed anew from there: t is then
    /// exactly 0 for a ray that starts in the plane, and needs no sum.
    pub fn unmoved(&self, cut: Cut, plane: Option<(usize, f64)>) -> Cut {
        let t = match plane {
            Some((axis, plane)) => (plane - self.start[axis]) / self.direction[axis],
            None => self.t_c + cut.t,
        };
        Cut { t, ..cut }
    }
}

/// The point at `t`, each coordinate rounded once.
pub(super) fn on_ray(ray: &Ray, t: f64) -> DVec3 {
    let Ray {
        origin: o,
        direction: d,
    } = ray;
    DVec3::new(
        t.mul_add(d.x, o.x),
        t.mul_add(d.y, o.y),
        t.mul_add(d.z, o.z),
    )
}
