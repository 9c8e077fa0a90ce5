//! The side of an edge on which a ray passes, decided exactly.
//!
//! Triangles and polygons ask the same question of the same numbers, so they meet without gap and without overlap.

use crate::math::DVec3;

/// On which side of the edge p -> q the ray (the origin of the view) passes: the edge function q x p = qx py - qy px,
/// and whether it is positive, decided exactly.
///
/// The neighbour across the edge asks for q -> p and gets the negative of the function and the opposite side, so
/// that the ray is inside exactly one of the two.
#[inline(always)]
pub fn edge(p: DVec3, q: DVec3) -> (f64, bool) {
    let (m, n) = (q.x * p.y, q.y * p.x);
    let value = m - n;
    // Rounding keeps order: if the rounded products differ, their difference has the right sign.
    if value != 0.0 {
        return (value, value > 0.0);
    }
    // Equal after rounding: compare what was rounded away. (`mul_add` rounds once, so these remainders are exact.)
    let rest = q.x.mul_add(p.y, -m) - q.y.mul_add(p.x, -n);
    if rest != 0.0 {
        return (rest, rest > 0.0);
    }
    // The ray meets the edge exactly. Move it, in thought, by an endlessly small step aside: the side then depends
    // on the edge's direction alone.
    (0.0, (q.x, q.y) > (p.x, p.y))
}
