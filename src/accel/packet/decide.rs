//! The double-precision test of eight rays, each against a triangle of its own: the operations of
//! [`crate::geometry::Triangle`] in the same order.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use crate::accel::lanes::{self, Seen};
use crate::accel::simd::Level;
use crate::geometry::triangle::CANCELLED;
use crate::geometry::{Hit, Shear, Triangle};
use crate::math::{Interval, Ray};

/// Rays that are tested at once.
pub const LANES: usize = 8;

/// A ray and the triangle that it may hit.
pub type Pair<'a> = (&'a (Ray, Interval), &'a Triangle);

type Row = [f64; LANES];

/// What is found.
pub struct Found {
    /// Rays that hit, and rays whose test needs one of its rare branches.
    pub hits: u32,
    pub rare: u32,
    t: Row,
    weights: [Row; 3],
}

/// Eight rays and their triangles, in the order of each ray's view.
struct Rows {
    /// Corner by corner x, y, z.
    corners: [[Row; 3]; 3],
    origin: [Row; 3],
    direction: [Row; 3],
    min: Row,
    max: Row,
}

/// Tests each ray against its triangle.
#[inline(always)]
pub fn decide<L: Level>(level: L, pairs: &[Pair; LANES]) -> Found {
    let Rows {
        corners,
        origin,
        direction: d,
        min,
        max,
    } = &Rows::new(pairs);
    let (mut slope, mut stretch) = ([[0.0; LANES]; 2], [0.0; LANES]);
    for i in 0..LANES {
        slope[0][i] = d[0][i] / d[2][i];
        slope[1][i] = d[1][i] / d[2][i];
        stretch[i] = 1.0 / d[2][i];
    }
    let a = seen(&corners[0], origin, &slope);
    let b = seen(&corners[1], origin, &slope);
    let c = seen(&corners[2], origin, &slope);
    let (u, v, w) = (
        lanes::edge(&b, &c),
        lanes::edge(&c, &a),
        lanes::edge(&a, &b),
    );
    let candidates = level.positive8(&lanes::inside(&u, &v, &w));

    let (mut t, mut kept, mut weights) = ([0.0; LANES], [0.0; LANES], [[0.0; LANES]; 3]);
    for i in 0..LANES {
        let area = u[i] + v[i] + w[i];
        let depth = |corner: usize| stretch[i] * (corners[corner][2][i] - origin[2][i]);
        t[i] = (u[i] * depth(0) + v[i] * depth(1) + w[i] * depth(2)) / area;
        let sum = products(&b, &c, i) + products(&c, &a, i) + products(&a, &b, i);
        kept[i] = area.abs() - CANCELLED * sum;
        weights[0][i] = u[i] / area;
        weights[1][i] = v[i] / area;
        weights[2][i] = w[i] / area;
    }
    let plain =
        level.positive8(&kept) & crossed(level, &u) & crossed(level, &v) & crossed(level, &w);
    let inside = level.less8(min, &t) & level.less8(&t, max);
    Found {
        hits: candidates & plain & inside,
        rare: candidates & !plain,
        t,
        weights,
    }
}

impl Rows {
    #[inline(always)]
    fn new(pairs: &[Pair; LANES]) -> Self {
        let mut out = Self {
            corners: [[[0.0; LANES]; 3]; 3],
            origin: [[0.0; LANES]; 3],
            direction: [[0.0; LANES]; 3],
            min: [0.0; LANES],
            max: [0.0; LANES],
        };
        for i in 0..LANES {
            let ((ray, interval), triangle) = pairs[i];
            let axes = Shear::axes(ray.direction);
            for k in 0..3 {
                for corner in 0..3 {
                    out.corners[corner][k][i] = triangle.corners[corner].to_array()[axes[k]];
                }
                out.origin[k][i] = ray.origin.to_array()[axes[k]];
                out.direction[k][i] = ray.direction.to_array()[axes[k]];
            }
            (out.min[i], out.max[i]) = (interval.min, interval.max);
        }
        out
    }
}

/// A corner of each triangle in the view of its ray.
#[inline(always)]
fn seen(corner: &[Row; 3], origin: &[Row; 3], slope: &[Row; 2]) -> Seen<f64, LANES> {
    lanes::seen(|k, i| corner[k][i], |k, i| origin[k][i], |k, i| slope[k][i])
}

/// How large the products in an edge function are.
#[inline(always)]
fn products(p: &Seen<f64, LANES>, q: &Seen<f64, LANES>, i: usize) -> f64 {
    (q[0][i] * p[1][i]).abs() + (q[1][i] * p[0][i]).abs()
}

/// Where an edge function is not zero.
#[inline(always)]
fn crossed<L: Level>(level: L, f: &Row) -> u32 {
    let mut size = [0.0; LANES];
    for i in 0..LANES {
        size[i] = f[i].abs();
    }
    level.less8(&[0.0; LANES], &size)
}

impl Found {
    /// The hit of a lane, which is one of `hits`.
    #[inline(always)]
    pub fn hit(&self, lane: usize, primitive: u32) -> Hit {
        let [u, v, w] = &self.weights;
        Hit {
            t: self.t[lane],
            primitive,
            barycentric: [u[lane], v[lane], w[lane]],
        }
    }
}
