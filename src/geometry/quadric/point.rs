//! Points of a quadric of revolution, pulled back onto it.
//!
//! The bound. How far may a point be off its wall? Where the wall is steep it keeps y and takes R(y): four roundings of terms
//! that are as large as the shape at most, and five more for the scale to R (the root, a quotient, two products, a sum).
//! Where the wall is flat it keeps its radius and takes y, with no more. So it is within gamma_9 (r + h), with r the largest
//! radius and h half the height. The next test moves the surface by what A, B and C are off: one rounding for each coordinate
//! of o', at most five for each of their terms, two in D, and two more for t (a quotient, a sum): gamma_10, once for each of
//! the two squares in F. gamma_32 (r + h) covers all of it. (Measured, with 8 million rays at sixteen shapes, flat angles and
//! needles among them: gamma_2 is enough, gamma_1 is not.)
//!
//! Caps: y is exact, and a ray that starts there crosses that plane at t = 0 exactly (`Moved::at_plane`). What is rounded
//! along the cap cannot lead off it.

use std::f64::consts::TAU;

use super::moved::on_ray;
use super::{BASE, Quadric, TOP};
use crate::geometry::SurfacePoint;
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Ray};

impl Quadric {
    /// The point at `t` of a part, pulled back onto it.
    pub fn surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        let at = on_ray(ray, t);
        match part {
            BASE => self.on_cap(at, -1.0),
            TOP => self.on_cap(at, 1.0),
            _ => self.on_wall(at),
        }
    }

    /// The gradient (2x, -d(R^2)/dy, 2z) of F at a point. It points outwards, and vanishes at the apex of a cone.
    pub fn gradient(&self, point: DVec3) -> DVec3 {
        let y = -self.profile.half_slope(point.y);
        2.0 * DVec3::new(point.x, y, point.z)
    }

    /// The length that roundings are multiples of.
    fn size(&self) -> f64 {
        self.max_radius + self.half_height
    }

    /// Where the wall is steep the point keeps its height and takes the radius there; where it is flat it keeps its radius
    /// and takes the height there, unless that lies beyond the rim.
    fn on_wall(&self, at: DVec3) -> SurfacePoint {
        let h = self.half_height;
        let radius = libm::hypot(at.x, at.z);
        let mut point = DVec3::new(at.x, at.y.max(-h).min(h), at.z);
        let flat = self.profile.is_flat(radius, point.y);
        if flat {
            point.y = self.profile.height(radius, point.y);
        }
        if !flat || point.y.abs() > h {
            point.y = point.y.max(-h).min(h);
            let target = self.profile.radius(point.y);
            [point.x, point.z] = scaled([at.x, at.z], radius, target);
        }
        SurfacePoint {
            point,
            error: DVec3::splat(gamma(32) * self.size()),
            normal: self.profile.outwards(point),
            uv: DVec2::new(around(point), (0.5 * (point.y / h + 1.0)).clamp(0.0, 1.0)),
        }
    }

    /// The cap below (-1) or above (1), no farther out than its rim.
    fn on_cap(&self, at: DVec3, side: f64) -> SurfacePoint {
        let y = side * self.half_height;
        let (radius, rim) = (libm::hypot(at.x, at.z), self.profile.radius(y));
        let mut point = DVec3::new(at.x, y, at.z);
        if radius > rim {
            [point.x, point.z] = scaled([at.x, at.z], radius, rim);
        }
        let along = gamma(16) * self.size();
        let v = if rim > 0.0 {
            (radius / rim).min(1.0)
        } else {
            0.0
        };
        SurfacePoint {
            point,
            error: DVec3::new(along, 0.0, along),
            normal: DVec3::new(0.0, side, 0.0),
            uv: DVec2::new(around(point), v),
        }
    }
}

/// A vector across the axis, of length `radius`, brought to length `target`.
fn scaled([x, z]: [f64; 2], radius: f64, target: f64) -> [f64; 2] {
    if radius > 0.0 {
        [x / radius * target, z / radius * target]
    } else {
        [target, 0.0]
    }
}

/// The part of a whole turn around the y axis, as on a sphere.
pub(super) fn around(p: DVec3) -> f64 {
    libm::atan2(-p.z, p.x) / TAU + 0.5
}
