//! Grids of control points: halving and evaluation by de Casteljau's construction, for points of any kind.
//!
//! Source: de Casteljau 1959; Farin, "Curves and Surfaces for CAGD", 5th edition, chapters 4 and 16.

use std::ops::{Add, Mul, Sub};

/// The highest degree along u and along v.
pub const MAX_DEGREE: usize = 5;

/// The most control points along u, and along v.
pub const SIDE: usize = MAX_DEGREE + 1;

/// What can be mixed: numbers and vectors.
pub trait Blend:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self>
{
}
impl<T: Copy + Default + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>> Blend for T {}

/// The control points of a surface: `size[1]` rows along v of `size[0]` points along u, one row after the other.
#[derive(Clone, Copy, Debug)]
pub struct ControlGrid<T> {
    /// The number of points along u and along v.
    pub size: [usize; 2],
    points: [T; SIDE * SIDE],
}

/// The control points of a curve, of which `count` are in use.
#[derive(Clone, Copy, Debug)]
pub struct Row<T> {
    /// How many there are.
    pub count: usize,
    points: [T; SIDE],
}

/// A surface at one (u, v): the value and its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Jet<T> {
    /// The value.
    pub value: T,
    /// The derivative along u.
    pub du: T,
    /// The derivative along v.
    pub dv: T,
    /// The mixed derivative.
    pub duv: T,
}

impl<T: Blend> Row<T> {
    /// A curve with these points.
    pub fn new(count: usize, point: impl Fn(usize) -> T) -> Self {
        let mut points = [T::default(); SIDE];
        for (i, p) in points.iter_mut().take(count).enumerate() {
            *p = point(i);
        }
        Self { count, points }
    }

    /// The points.
    #[inline]
    pub fn points(&self) -> &[T] {
        &self.points[..self.count]
    }

    /// Both halves of the curve. They share the middle point to the bit, and the reversed curve gives the same halves
    /// reversed, since (a + b) / 2 does not ask which comes first.
    #[inline]
    pub fn halves(&self) -> [Self; 2] {
        // A length that is known when compiling makes the loops straight code.
        match self.count {
            2 => self.halves_of::<2>(),
            3 => self.halves_of::<3>(),
            4 => self.halves_of::<4>(),
            5 => self.halves_of::<5>(),
            _ => self.halves_of::<6>(),
        }
    }

    #[inline]
    fn halves_of<const N: usize>(&self) -> [Self; 2] {
        let (mut left, mut right) = (*self, *self);
        let mut mixed = self.points;
        for last in (0..N).rev() {
            left.points[N - 1 - last] = mixed[0];
            right.points[last] = mixed[last];
            for i in 0..last {
                mixed[i] = (mixed[i] + mixed[i + 1]) * 0.5;
            }
        }
        [left, right]
    }
}

/// The value and the derivative at `t` of the curve with these control points, 2 to [`SIDE`].
#[inline]
pub fn value_and_slope<T: Blend>(points: &[T], t: f64) -> [T; 2] {
    // A length that is known when compiling makes the loops straight code.
    match points.len() {
        2 => casteljau::<T, 2>(points, t),
        3 => casteljau::<T, 3>(points, t),
        4 => casteljau::<T, 4>(points, t),
        5 => casteljau::<T, 5>(points, t),
        _ => casteljau::<T, 6>(points, t),
    }
}

/// The construction: neighbours are mixed until two points are left, which span the tangent.
///
/// A mix is a + t (b - a): of equal points it is the same point exactly, so that a collapsed curve has derivative 0.
#[inline]
fn casteljau<T: Blend, const N: usize>(points: &[T], t: f64) -> [T; 2] {
    let mut p = [T::default(); N];
    p.copy_from_slice(points);
    for last in (2..N).rev() {
        for i in 0..last {
            p[i] = p[i] + (p[i + 1] - p[i]) * t;
        }
    }
    let along = p[1] - p[0];
    [p[0] + along * t, along * (N - 1) as f64]
}

impl<T: Blend> ControlGrid<T> {
    /// A grid of points that are given row after row. `size` is 2 to [`SIDE`] each.
    #[inline]
    pub fn of(size: [usize; 2], rows: impl Iterator<Item = T>) -> Self {
        let mut points = [T::default(); SIDE * SIDE];
        for (p, given) in points.iter_mut().zip(rows) {
            *p = given;
        }
        Self { size, points }
    }

    /// The point number i along u and j along v.
    #[inline]
    pub fn point(&self, i: usize, j: usize) -> T {
        self.points[j * self.size[0] + i]
    }

    /// All points, row after row.
    #[inline]
    pub fn points(&self) -> &[T] {
        &self.points[..self.size[0] * self.size[1]]
    }

    /// The grid with each point replaced.
    #[inline]
    pub fn map<S: Blend>(&self, f: impl Fn(T) -> S) -> ControlGrid<S> {
        ControlGrid::of(self.size, self.points().iter().map(|p| f(*p)))
    }

    /// The points along `axis` (0 is u) at place `across` of the other axis.
    #[inline]
    pub fn row(&self, axis: usize, across: usize) -> Row<T> {
        Row::new(self.size[axis], |k| match axis {
            0 => self.point(k, across),
            _ => self.point(across, k),
        })
    }

    /// Both halves along `axis`.
    pub fn halves(&self, axis: usize) -> [Self; 2] {
        let [mut low, mut high] = [*self, *self];
        for across in 0..self.size[1 - axis] {
            let [left, right] = self.row(axis, across).halves();
            for k in 0..self.size[axis] {
                let (i, j) = if axis == 0 { (k, across) } else { (across, k) };
                low.points[j * self.size[0] + i] = left.points[k];
                high.points[j * self.size[0] + i] = right.points[k];
            }
        }
        [low, high]
    }

    /// The four boundary curves, counter-clockwise in (u, v), each with true if it runs against its parameter there.
    #[inline]
    pub fn boundary(&self) -> [(Row<T>, bool); 4] {
        let [m, n] = self.size;
        [
            (self.row(0, 0), false),
            (self.row(1, m - 1), false),
            (self.row(0, n - 1), true),
            (self.row(1, 0), true),
        ]
    }

    /// The value and the derivatives at (u, v): first along every row, then across the rows.
    #[inline]
    pub fn at(&self, [u, v]: [f64; 2]) -> Jet<T> {
        let mut values = [T::default(); SIDE];
        let mut slopes = [T::default(); SIDE];
        let rows = self.points().chunks_exact(self.size[0]);
        for (j, row) in rows.enumerate() {
            [values[j], slopes[j]] = value_and_slope(row, u);
        }
        let rows = self.size[1];
        let ([value, dv], [du, duv]) = (
            value_and_slope(&values[..rows], v),
            value_and_slope(&slopes[..rows], v),
        );
        Jet { value, du, dv, duv }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_of_powers_has_its_value_and_its_derivatives() {
        // x^3 has the Bernstein coefficients 0, 0, 0, 1; y^2 has 0, 0, 1. At (1/2, 1/4): x^3 y^2 = 1/128.
        let grid = ControlGrid::of([4, 3], (0..12).map(|k| f64::from(u8::from(k == 11))));
        let jet = grid.at([0.5, 0.25]);
        assert_eq!(jet.value, 1.0 / 128.0);
        assert_eq!(jet.du, 3.0 / 64.0);
        assert_eq!(jet.dv, 1.0 / 16.0);
        assert_eq!(jet.duv, 3.0 / 8.0);
    }

    #[test]
    fn halves_join_and_do_not_know_the_direction() {
        let curve = Row::new(4, |i| [0.1, 0.7, -0.3, 1.9][i]);
        let back = Row::new(4, |i| [1.9, -0.3, 0.7, 0.1][i]);
        let ([a, b], [c, d]) = (curve.halves(), back.halves());
        assert_eq!(a.points[3], b.points[0]);
        for i in 0..4 {
            assert_eq!(a.points[i].to_bits(), d.points[3 - i].to_bits());
            assert_eq!(b.points[i].to_bits(), c.points[3 - i].to_bits());
        }
        assert!((a.points[3] - value_and_slope(curve.points(), 0.5)[0]).abs() < 1e-15);
    }
}
