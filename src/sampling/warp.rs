//! Warps: maps from the unit square that keep evenly spread points evenly spread, as functions of numbers alone.

use std::f64::consts::TAU;

use crate::math::DVec3;

/// Polar coordinates in the unit disc. The radius may be negative.
#[derive(Clone, Copy, Debug)]
pub struct Polar {
    /// The radius.
    pub r: f64,
    /// The sine of the angle.
    pub sin: f64,
    /// The cosine of the angle.
    pub cos: f64,
}

/// A point of the part of the unit sphere that is seen from outside, about the axis from its centre to the viewer.
#[derive(Clone, Copy, Debug)]
pub struct VisibleSphere {
    /// Cosine of the angle around the axis.
    pub cos_turn: f64,
    /// Sine of that angle.
    pub sin_turn: f64,
    /// Cosine of the angle between the axis and the point, at the centre.
    pub cos_alpha: f64,
    /// Sine of that angle.
    pub sin_alpha: f64,
    /// The solid angle of the whole sphere, from the viewer, in steradians.
    pub solid_angle: f64,
}

/// Barycentric weights of a point that is uniform in a triangle: the root spreads what would crowd at the first corner.
/// Source: Turk 1990, "Generating random points in triangles", Graphics Gems.
#[inline]
pub fn triangle([u, v]: [f64; 2]) -> [f64; 3] {
    let root = u.sqrt();
    [1.0 - root, root * (1.0 - v), root * v]
}

/// A point that is uniform in the unit disc: the square's rings of equal area become rings of equal area, and neighbours
/// stay neighbours. Source: Shirley and Chiu 1997, "A low distortion map between disk and square".
#[inline]
pub fn disc([u, v]: [f64; 2]) -> Polar {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    // The larger coordinate gives the ring, the smaller one the angle on it: an eighth turn for each triangle.
    let (r, turn) = if x == 0.0 && y == 0.0 {
        (0.0, 0.0)
    } else if x.abs() > y.abs() {
        (x, y / x / 8.0)
    } else {
        (y, 0.25 - x / y / 8.0)
    };
    let (sin, cos) = libm::sincos(TAU * turn);
    Polar { r, sin, cos }
}

/// A direction that is uniform on the unit sphere.
#[inline]
pub fn sphere([u, v]: [f64; 2]) -> DVec3 {
    let (sin, cos) = libm::sincos(TAU * v);
    let z = 1.0 - 2.0 * u;
    let r = (1.0 - z * z).max(0.0).sqrt();
    DVec3::new(r * cos, r * sin, z)
}

/// Where a ray that is uniform in the cone of a sphere meets it; the squared sine of the cone's half angle is `sin2_max`.
///
/// Source: Shirley, Wang and Zimmerman 1996, "Monte Carlo techniques for direct lighting calculations"; the cone near
/// its axis without cancellation: PBR, 4th edition, section 6.2.4.
#[inline]
pub fn visible_sphere([u, v]: [f64; 2], sin2_max: f64) -> VisibleSphere {
    let (sin_turn, cos_turn) = libm::sincos(TAU * v);
    // One minus the cosine of the half angle: sin^2 / (1 + cos) keeps its digits for small spheres.
    let cos_max = (1.0 - sin2_max).sqrt();
    let one_minus_cos_max = sin2_max / (1.0 + cos_max);
    // The direction's angle from the axis, uniform in solid angle.
    let one_minus_cos = u * one_minus_cos_max;
    let sin2 = (one_minus_cos * (2.0 - one_minus_cos)).min(sin2_max);
    let cos = 1.0 - one_minus_cos;
    // Where it meets the sphere, as an angle at the centre (law of sines).
    let cos_alpha = sin2 / (sin2_max.sqrt()) + cos * (1.0 - sin2 / sin2_max).max(0.0).sqrt();
    VisibleSphere {
        cos_turn,
        sin_turn,
        cos_alpha,
        sin_alpha: (1.0 - cos_alpha * cos_alpha).max(0.0).sqrt(),
        solid_angle: TAU * one_minus_cos_max,
    }
}
