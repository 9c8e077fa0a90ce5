//! Double-precision triangle tests, several at once: the operations of [`crate::geometry::Triangle`] in the same
//! order, so that the results have the same bits.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

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
    let mut out = [0.0; N];
    for i in 0..N {
        out[i] = q[0][i] * p[1][i] - q[1][i] * p[0][i];
    }
    out
}

/// Not negative if the ray may pass all three edges on the same side; an edge function of 0 leaves that open.
#[inline(always)]
pub fn inside<const N: usize>(u: &[f64; N], v: &[f64; N], w: &[f64; N]) -> [f64; N] {
    let min = |a: f64, b: f64| if a < b { a } else { b };
    let max = |a: f64, b: f64| if a > b { a } else { b };
    let mut out = [0.0; N];
    for i in 0..N {
        let least = min(min(u[i], v[i]), w[i]);
        let most = max(max(u[i], v[i]), w[i]);
        out[i] = max(least, -most);
    }
    out
}

/// One ray for all lanes, which are the triangles of a block.
#[derive(Clone, Copy)]
pub struct Sight {
    axes: [usize; 3],
    origin: [f64; 3],
    slope: [f64; 2],
}

impl Sight {
    /// The ray whose view `shear` is.
    #[inline(always)]
    pub fn new(shear: &Shear) -> Self {
        let [x, y, z] = shear.axes;
        let o = shear.origin;
        Self {
            axes: shear.axes,
            origin: [o[x], o[y], o[z]],
            slope: [shear.s.x, shear.s.y],
        }
    }

    /// Not negative where the triangle may be hit. The corners come as in a block: of each coordinate each corner.
    #[inline(always)]
    pub fn candidates<const N: usize>(&self, corners: &[[[f64; N]; 3]; 3]) -> [f64; N] {
        let [x, y, z] = self.axes;
        let (x, y, z) = (&corners[x], &corners[y], &corners[z]);
        let see = |c: usize| {
            let rows = [&x[c], &y[c], &z[c]];
            seen::<N>(
                |k, i| rows[k][i],
                |k, _| self.origin[k],
                |k, _| self.slope[k],
            )
        };
        let [a, b, c] = [see(0), see(1), see(2)];
        inside(&edge(&b, &c), &edge(&c, &a), &edge(&a, &b))
    }
}
