//! Double-precision triangle tests, several at once: the operations of [`crate::geometry::Triangle`] in the same
//! order, so that the results have the same bits.

use crate::geometry::Shear;

/// What one lane knows of a corner, seen along its ray.
pub type Seen<const N: usize> = [[f64; N]; 2];

/// x' = x - s.x z and y' = y - s.y z of corners (x, y, z) relative to the origin.
#[inline(always)]
pub fn seen<const N: usize>(
    corner: impl Fn(usize, usize) -> f64,
    origin: impl Fn(usize, usize) -> f64,
    slope: impl Fn(usize, usize) -> f64,
) -> Seen<N> {
    let mut out = [[0.0; N]; 2];
    for i in 0..N {
        let z = corner(2, i) - origin(2, i);
        out[0][i] = (corner(0, i) - origin(0, i)) - slope(0, i) * z;
        out[1][i] = (corner(1, i) - origin(1, i)) - slope(1, i) * z;
    }
    out
}

/// The edge functions q x p of edges p -> q, as far as they do not vanish.
#[inline(always)]
pub fn edge<const N: usize>(p: &Seen<N>, q: &Seen<N>) -> [f64; N] {
    std::array::from_fn(|i| q[0][i] * p[1][i] - q[1][i] * p[0][i])
}

/// Not negative if the ray may pass all three edges on the same side; an edge function of 0 leaves that open.
#[inline(always)]
pub fn inside<const N: usize>(u: &[f64; N], v: &[f64; N], w: &[f64; N]) -> [f64; N] {
    let min = |a: f64, b: f64| if a < b { a } else { b };
    let max = |a: f64, b: f64| if a > b { a } else { b };
    std::array::from_fn(|i| {
        let (least, most) = (min(min(u[i], v[i]), w[i]), max(max(u[i], v[i]), w[i]));
        max(least, -most)
    })
}

/// The same ray for all lanes, the triangles of a block: not negative where the triangle may be hit.
#[inline(always)]
pub fn candidates<const N: usize>(corners: &[[[f64; N]; 3]; 3], shear: &Shear) -> [f64; N] {
    let axes = shear.axes;
    let (o, s) = (axes.map(|axis| shear.origin[axis]), [shear.s.x, shear.s.y]);
    let see = |corner: &[[f64; N]; 3]| {
        let rows = axes.map(|axis| &corner[axis]);
        seen::<N>(|k, i| rows[k][i], |k, _| o[k], |k, _| s[k])
    };
    let [a, b, c] = [see(&corners[0]), see(&corners[1]), see(&corners[2])];
    inside(&edge(&b, &c), &edge(&c, &a), &edge(&a, &b))
}
