//! The box with faces along the axes: three pairs of parallel planes ("slabs").

use super::{Aabb, Intersection, SurfacePoint};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Interval, Ray};

/// A solid box. Outwards is away from its middle; u and v run from 0 to 1 over each face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// Its extent.
    pub bounds: Aabb,
}

/// Where a ray passes the planes of one axis: enters at `near`, leaves at `far`.
#[derive(Clone, Copy)]
struct Slab {
    near: f64,
    far: f64,
}

impl Cuboid {
    /// The first crossing inside the interval.
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        match self.span(ray) {
            Some([enter, exit]) => Intersection::first_of(enter, exit, interval),
            None => Intersection::Miss,
        }
    }

    /// The two crossings of the ray's line: it is in the box while it is in all three slabs, so it enters with the last
    /// slab and leaves with the first. `None` if it misses. Source: Kay and Kajiya 1986.
    #[inline(always)]
    pub fn span(&self, ray: &Ray) -> Option<[f64; 2]> {
        let slabs = [0, 1, 2].map(|axis| self.slab(ray, axis));
        let enter = slabs[0].near.max(slabs[1].near).max(slabs[2].near);
        let exit = slabs[0].far.min(slabs[1].far).min(slabs[2].far);
        (enter <= exit).then_some([enter, exit])
    }

    /// The slab of one axis. A ray along it is inside for ever or never; the division would give 0/0 on its face.
    #[inline(always)]
    fn slab(&self, ray: &Ray, axis: usize) -> Slab {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        let (min, max) = (self.bounds.min[axis], self.bounds.max[axis]);
        if d == 0.0 {
            let inside = min <= o && o <= max;
            let (near, far) = if inside {
                (f64::NEG_INFINITY, f64::INFINITY)
            } else {
                (f64::INFINITY, f64::NEG_INFINITY)
            };
            return Slab { near, far };
        }
        let (t0, t1) = ((min - o) / d, (max - o) / d);
        Slab {
            near: t0.min(t1),
            far: t0.max(t1),
        }
    }

    /// The point at `t`: on the face whose plane is crossed there, exactly.
    pub fn surface(&self, ray: &Ray, t: f64) -> SurfacePoint {
        let crossed = |axis: &usize| {
            let slab = self.slab(ray, *axis);
            slab.near == t || slab.far == t
        };
        let axis = [0, 1, 2].into_iter().find(crossed).unwrap_or(0);
        let Aabb { min, max } = self.bounds;
        // It is the face nearer to the point.
        let at = ray.at(t);
        let outer = (at[axis] - min[axis]).abs() > (at[axis] - max[axis]).abs();
        let mut point = at.clamp(min, max);
        let mut normal = DVec3::ZERO;
        point[axis] = if outer { max[axis] } else { min[axis] };
        normal[axis] = if outer { 1.0 } else { -1.0 };
        // Rounding moves the point along the face, never off it.
        let mut error = gamma(3) * (ray.origin.abs() + (t * ray.direction).abs());
        error[axis] = 0.0;
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let place = |k: usize| (point[k] - min[k]) / (max[k] - min[k]);
        SurfacePoint {
            point,
            error,
            normal,
            uv: DVec2::new(place(i), place(j)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Cuboid = Cuboid {
        bounds: Aabb {
            min: DVec3::ZERO,
            max: DVec3::ONE,
        },
    };

    #[test]
    fn each_face_is_met_from_both_sides_with_its_outward_normal() {
        for axis in 0..3 {
            for (start, sign) in [(3.0, 1.0), (-2.0, -1.0)] {
                let mut origin = DVec3::splat(0.25);
                let mut d = DVec3::ZERO;
                origin[axis] = start;
                d[axis] = -sign;
                let ray = Ray::new(origin, d);
                let Intersection::Hit { t, .. } = UNIT.intersect(&ray, Interval::FORWARD) else {
                    panic!("axis {axis} from {start}");
                };
                assert_eq!(t, 2.0);
                assert_eq!(UNIT.surface(&ray, t).normal[axis], sign);
                // From the surface inwards the ray leaves by the face opposite.
                let inside = Ray::new(UNIT.surface(&ray, t).point, d);
                let Intersection::Hit { t, .. } = UNIT.intersect(&inside, Interval::FORWARD) else {
                    panic!("inside");
                };
                assert_eq!(t, 1.0);
                assert_eq!(UNIT.surface(&inside, t).normal[axis], -sign);
            }
        }
    }

    #[test]
    fn a_ray_in_a_face_gives_no_nan() {
        let ray = Ray::new(DVec3::new(0.0, 0.5, -1.0), DVec3::Z);
        assert!(matches!(
            UNIT.intersect(&ray, Interval::FORWARD),
            Intersection::Hit { t: 1.0, .. }
        ));
    }
}
