//! Single-precision filter of triangles: which may be hit and which surely are, and why no hit is lost or invented.
//!
//! A triangle is seen along the ray as in [`crate::geometry::triangle`], in the tree's space: x' = x - s.x z and
//! y' = y - s.y z of corners relative to the origin, then an edge function e = qx py - qy px for each edge p -> q.
//! In units of u = 2^-24, r being the largest coordinate of the ray's origin and |s| <= 2, x' is off by: rounding the
//! corner and the origin, and their difference (2 + 2 r); the same for z, twice (4 + 4 r); the slope, a quotient of two
//! inverses (10 + 10 r); the product (2 + 2 r) and the difference (3 + 3 r); in all 21 (1 + r). The test in double
//! precision is exact for corners that are moved by the tolerance at most, which is 3 tolerances as they are seen. So what is
//! computed here and what is decided there differ by less than E, three times the pad of `local`, which is
//! 16 u (1 + r) and the tolerance.
//!
//! **May be hit.** If the double test says inside, its corners lie around the ray, each within M of it: the size of
//! the triangle as it is seen, at most three times its size along an axis, and a few E. An edge function of such corners
//! changes by less than 4 E M if they move by E, and is rounded by less than 4 u M^2. So all three are above -B, or
//! all below B, with B = 5 M (E + u M).
//!
//! **Is surely hit.** Rounding keeps order, so a computed function (a difference of two rounded products) that is
//! above 0 has the right sign for its corners. If all three are, these corners lie around the ray and within M of it;
//! if all three are above B, those of the double test do as well, and its functions are not zero. What it takes for
//! t is a mean of the corners' depths, and lies between them but for less than 4 pads.

use super::local_ray::U;
use super::triangle_lanes::{edge, inside, seen};

/// The least edge function if all are positive, or the least of their negatives: on how deep inside the ray passes.
/// Of each lane `corner(c, k, i)`, `origin(k, i)` and `slope(k, i)` tell coordinate k in the order of the view.
#[inline(always)]
pub fn depth_inside<const N: usize>(
    corner: impl Fn(usize, usize, usize) -> f32,
    origin: impl Fn(usize, usize) -> f32,
    slope: impl Fn(usize, usize) -> f32,
) -> [f32; N] {
    let a = seen(|k, i| corner(0, k, i), &origin, &slope);
    let b = seen(|k, i| corner(1, k, i), &origin, &slope);
    let c = seen(|k, i| corner(2, k, i), &origin, &slope);
    inside(&edge(&b, &c), &edge(&c, &a), &edge(&a, &b))
}

/// B: triangles of this size may be hit down to a depth of -B, and are surely hit from a depth of B on.
#[inline(always)]
pub fn edge_error(size: f32, pad: f32) -> f32 {
    let error = 3.0 * pad;
    let seen = 3.0 * size + 4.0 * error;
    5.0 * seen * (error + U as f32 * seen)
}

/// How far the depths of a triangle's corners may be off.
#[inline(always)]
pub fn depth_error(pad: f32) -> f32 {
    4.0 * pad
}
