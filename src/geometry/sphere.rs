//! The sphere, by a quadratic that does not cancel.

use std::f64::consts::{PI, TAU};

use super::aabb::passes_ball_by_far;
use super::{Aabb, Intersection, SurfacePoint};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Interval, Ray};

/// All points at distance `radius` from `center`. Outwards is away from the centre.
///
/// u runs once around the y axis, v from the lowest point (0) to the highest (1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub center: DVec3,
    /// The radius, above 0.
    pub radius: f64,
}

impl Sphere {
    /// The first crossing inside the interval.
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        match self.span(ray) {
            Some([t0, t1]) => Intersection::first_of(t0, t1, interval),
            None => Intersection::Miss,
        }
    }

    /// Its volume.
    pub fn volume(&self) -> f64 {
        4.0 / 3.0 * std::f64::consts::PI * self.radius.powi(3)
    }

    /// The two crossings of the ray's line, in order; `None` if it misses.
    ///
    /// With f = o - c, the crossings solve a t^2 - 2 b t + c = 0, where a = d.d, b = -f.d, c = f.f - r^2. The school
    /// formula subtracts nearly equal numbers twice: in b^2 - a c when the sphere is small and far, and in b - root
    /// when the origin is near the surface. Both are avoided here.
    /// Source: Haines, Guenther and Akenine-Moeller 2019, "Precision improvements for ray/sphere intersection".
    #[inline(always)]
    pub fn span(&self, ray: &Ray) -> Option<[f64; 2]> {
        let f = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let b = -f.dot(ray.direction);
        // Most lines miss by far, and need no division to know it.
        if passes_ball_by_far([a, b, f.length_squared()], self.radius * self.radius) {
            return None;
        }
        // l runs from the centre to the nearest point of the ray's line: |l| < r is what decides.
        let l = f + (b / a) * ray.direction;
        let discriminant = a * (self.radius * self.radius - l.length_squared());
        if discriminant < 0.0 {
            return None;
        }
        // q has no cancellation: b and the root are added with equal signs. Then the roots are c / q and q / a.
        let q = b + discriminant.sqrt().copysign(b);
        let distance = f.length();
        let c = (distance - self.radius) * (distance + self.radius);
        let (t0, t1) = (c / q, q / a);
        Some([t0.min(t1), t0.max(t1)])
    }

    /// The point at `t`, with its u and v.
    pub fn surface(&self, ray: &Ray, t: f64) -> SurfacePoint {
        let bare = self.bare_surface(ray, t);
        let normal = bare.normal;
        SurfacePoint {
            uv: DVec2::new(
                libm::atan2(-normal.z, normal.x) / TAU + 0.5,
                libm::acos((-normal.y).clamp(-1.0, 1.0)) / PI,
            ),
            ..bare
        }
    }

    /// The point at `t` without u and v, which cost more than all the rest: pulled back onto the sphere. It is then within
    /// gamma_5 of its distance from the centre (PBR 4th edition, section 6.8.4); the rest of the bound is what the next test of
    /// the same sphere may round.
    #[inline]
    pub fn bare_surface(&self, ray: &Ray, t: f64) -> SurfacePoint {
        let normal = (ray.at(t) - self.center).normalize_or(DVec3::Y);
        let local = normal * self.radius;
        let point = self.center + local;
        SurfacePoint {
            point,
            error: DVec3::splat(gamma(16) * self.radius) + gamma(4) * self.center.abs(),
            normal,
            uv: DVec2::ZERO,
        }
    }

    /// The box around the sphere, one float wider than computed.
    pub fn bounds(&self) -> Aabb {
        let r = DVec3::splat(self.radius);
        let pad = gamma(16) * (self.center.abs() + r);
        Aabb {
            min: self.center - r,
            max: self.center + r,
        }
        .padded(pad)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hit(sphere: Sphere, origin: DVec3, direction: DVec3) -> Intersection {
        sphere.intersect(&Ray::new(origin, direction), Interval::FORWARD)
    }

    const UNIT: Sphere = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };

    #[test]
    fn a_ray_to_the_centre_hits_at_distance_minus_radius() {
        let found = hit(UNIT, DVec3::new(0.0, 0.0, 3.0), DVec3::NEG_Z);
        assert!(matches!(found, Intersection::Hit { t: 2.0, .. }));
    }

    #[test]
    fn from_the_centre_t_is_the_radius_exactly() {
        let found = hit(UNIT, DVec3::ZERO, DVec3::Y);
        assert!(matches!(found, Intersection::Hit { t: 1.0, .. }));
    }

    #[test]
    fn on_the_surface_outwards_misses_and_inwards_finds_the_far_side() {
        assert!(matches!(
            hit(UNIT, DVec3::Y, DVec3::Y),
            Intersection::Behind(_)
        ));
        let inwards = hit(UNIT, DVec3::Y, DVec3::NEG_Y);
        assert!(matches!(inwards, Intersection::Hit { t: 2.0, .. }));
    }

    #[test]
    fn a_tiny_sphere_far_away_is_hit_where_it_is() {
        // The school formula gets almost half of such rays wrong: b^2 and a c agree in all digits.
        let tiny = Sphere {
            center: DVec3::new(0.0, 0.0, -1e5),
            radius: 1e-4,
        };
        for (x, expected) in [(0.999e-4, true), (1.001e-4, false)] {
            let found = hit(tiny, DVec3::new(x, 0.0, 0.0), DVec3::NEG_Z);
            assert_eq!(
                matches!(found, Intersection::Hit { .. }),
                expected,
                "x = {x}"
            );
        }
    }

    #[test]
    fn what_is_far_is_missed() {
        // Lines past a sphere at distances from its radius, down to the last bits, far away and near.
        let (mut far, mut near) = (0, 0);
        for away in [0.0, 1.0, 1e3, 1e6, 1e9] {
            for digits in 0..17 {
                for beside in [-1.0, 1.0] {
                    let f = DVec3::new(1.0 + beside * 10f64.powi(-digits), 0.0, away);
                    let direction = DVec3::NEG_Z * 0.7;
                    let (a, b) = (direction.length_squared(), -f.dot(direction));
                    let l = f + (b / a) * direction;
                    let is_far = passes_ball_by_far([a, b, f.length_squared()], 1.0);
                    assert!(!is_far || l.length_squared() > 1.0, "{f}");
                    far += u32::from(is_far);
                    near += u32::from(!is_far && l.length_squared() > 1.0);
                }
            }
        }
        // It decides often, and never alone.
        assert!(far > 20 && near > 20, "{far} {near}");
    }

    #[test]
    fn a_ray_of_no_direction_misses() {
        assert!(!matches!(
            hit(UNIT, DVec3::Z * 3.0, DVec3::ZERO),
            Intersection::Hit { .. }
        ));
    }
}
