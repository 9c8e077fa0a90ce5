//! Triangle tests, several at once: the operations of [`crate::geometry::Triangle`] in the same order, so that in double
//! precision the results have the same bits.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use std::ops::{Mul, Neg, Sub};

/// Single or double precision.
pub trait Number:
    Copy + Default + PartialOrd + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl Number for f32 {}
impl Number for f64 {}

/// What one lane knows of a corner, seen along its ray.
pub type Sheared<T, const N: usize> = [[T; N]; 2];

/// x' = x - s.x z and y' = y - s.y z of corners (x, y, z) relative to the origin.
#[inline(always)]
pub fn seen<T: Number, const N: usize>(
    corner: impl Fn(usize, usize) -> T,
    origin: impl Fn(usize, usize) -> T,
    slope: impl Fn(usize, usize) -> T,
) -> Sheared<T, N> {
    let mut out = [[T::default(); N]; 2];
    for i in 0..N {
        let z = corner(2, i) - origin(2, i);
        out[0][i] = (corner(0, i) - origin(0, i)) - slope(0, i) * z;
        out[1][i] = (corner(1, i) - origin(1, i)) - slope(1, i) * z;
    }
    out
}

/// The edge functions q x p of edges p -> q, as far as they do not vanish.
#[inline(always)]
pub fn edge<T: Number, const N: usize>(p: &Sheared<T, N>, q: &Sheared<T, N>) -> [T; N] {
    let mut out = [T::default(); N];
    for i in 0..N {
        out[i] = q[0][i] * p[1][i] - q[1][i] * p[0][i];
    }
    out
}

/// The least of three numbers if all are positive, the least of their negatives if all are negative.
#[inline(always)]
pub fn inside<T: Number, const N: usize>(u: &[T; N], v: &[T; N], w: &[T; N]) -> [T; N] {
    let min = |a: T, b: T| if a < b { a } else { b };
    let max = |a: T, b: T| if a > b { a } else { b };
    let mut out = [T::default(); N];
    for i in 0..N {
        let least = min(min(u[i], v[i]), w[i]);
        let most = max(max(u[i], v[i]), w[i]);
        out[i] = max(least, -most);
    }
    out
}
