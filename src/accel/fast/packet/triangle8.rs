//! Double-precision test of eight rays, each against a triangle of its own: the operations of
//! [`crate::geometry::Triangle`] in the same order.
//!
//! Closures are only given to functions that are always inlined: others would be compiled without the instructions of
//! the level.

use super::rays::{Lanes, RayPacket};
use crate::accel::fast::simd::Level;
use crate::accel::fast::triangle_lanes::{self, Sheared};
use crate::geometry::triangle::CANCELLED;
use crate::geometry::{Hit, Triangle};

/// Rays that are tested at once.
pub const LANES: usize = 8;

type Eight = [f64; LANES];

/// The triangles of eight rays, as far as there are any: corner by corner x, y, z.
pub struct Corners([[Eight; 3]; 3]);

/// What is found.
pub struct Hits8 {
    /// Rays that hit, and rays that need the test's rare branches or another view than the rest.
    pub hits: u32,
    pub rare: u32,
    pub t: Eight,
    weights: [Eight; 3],
}

impl Corners {
    /// No triangle.
    pub const NONE: Self = Self([[[0.0; LANES]; 3]; 3]);

    /// One triangle for all rays.
    #[inline(always)]
    pub fn all(triangle: &Triangle) -> Self {
        let [a, b, c] = triangle.corners.map(|p| p.to_array());
        let row = |p: [f64; 3]| [[p[0]; LANES], [p[1]; LANES], [p[2]; LANES]];
        Self([row(a), row(b), row(c)])
    }

    /// Puts a ray's triangle into a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, triangle: &Triangle) {
        for (rows, corner) in self.0.iter_mut().zip(&triangle.corners) {
            rows[0][lane] = corner.x;
            rows[1][lane] = corner.y;
            rows[2][lane] = corner.z;
        }
    }

    /// Tests each ray of a half of the packet against its triangle.
    #[inline(always)]
    pub fn test<L: Level>(&self, level: L, rays: &RayPacket, half: usize) -> Hits8 {
        // The view that all rays share whose direction is longest along the same axis.
        let [x, y, z] = rays.axes;
        let [x, y] = if rays.negative[z] == 1 {
            [y, x]
        } else {
            [x, y]
        };
        let (origin, direction) = (&rays.world.origin, &rays.world.direction);
        let o = [
            eight(&origin[x], half),
            eight(&origin[y], half),
            eight(&origin[z], half),
        ];
        let d = [
            eight(&direction[x], half),
            eight(&direction[y], half),
            eight(&direction[z], half),
        ];
        let along = row(|i| d[2][i].abs());
        let shared = level.less8(&row(|i| d[0][i].abs()), &along)
            & level.less8(&row(|i| d[1][i].abs()), &along);

        let slope = [row(|i| d[0][i] / d[2][i]), row(|i| d[1][i] / d[2][i])];
        let stretch = row(|i| 1.0 / d[2][i]);
        let [a, b, c] = &self.0;
        let (a, b, c) = (
            [&a[x], &a[y], &a[z]],
            [&b[x], &b[y], &b[z]],
            [&c[x], &c[y], &c[z]],
        );
        let (p, q, r) = (seen(a, o, &slope), seen(b, o, &slope), seen(c, o, &slope));
        let (u, v, w) = (
            triangle_lanes::edge(&q, &r),
            triangle_lanes::edge(&r, &p),
            triangle_lanes::edge(&p, &q),
        );
        let candidates = level.positive8(&triangle_lanes::inside(&u, &v, &w));

        let area = row(|i| u[i] + v[i] + w[i]);
        let depth_a = row(|i| stretch[i] * (a[2][i] - o[2][i]));
        let depth_b = row(|i| stretch[i] * (b[2][i] - o[2][i]));
        let depth_c = row(|i| stretch[i] * (c[2][i] - o[2][i]));
        let t = row(|i| (u[i] * depth_a[i] + v[i] * depth_b[i] + w[i] * depth_c[i]) / area[i]);
        let (qr, rp, pq) = (products(&q, &r), products(&r, &p), products(&p, &q));
        let kept = row(|i| area[i].abs() - CANCELLED * (qr[i] + rp[i] + pq[i]));
        let nothing = [0.0; LANES];
        let plain = level.positive8(&kept)
            & level.less8(&nothing, &row(|i| u[i].abs()))
            & level.less8(&nothing, &row(|i| v[i].abs()))
            & level.less8(&nothing, &row(|i| w[i].abs()));
        let inside = level.less8(eight(&rays.world.min, half), &t)
            & level.less8(&t, eight(&rays.world.max, half));
        Hits8 {
            hits: candidates & plain & inside & shared,
            rare: candidates & !plain | !shared,
            t,
            weights: [
                row(|i| u[i] / area[i]),
                row(|i| v[i] / area[i]),
                row(|i| w[i] / area[i]),
            ],
        }
    }
}

impl Hits8 {
    /// The hit of a lane, which is one of `hits`.
    #[inline(always)]
    pub fn hit(&self, lane: usize, primitive: u32) -> Hit {
        let [u, v, w] = &self.weights;
        Hit {
            t: self.t[lane],
            primitive,
            part: 0,
            place: [u[lane], v[lane], w[lane]],
        }
    }
}

/// Half of a packet's row.
#[inline(always)]
fn eight(row: &Lanes<f64>, half: usize) -> &Eight {
    &row.as_chunks().0[half]
}

/// A corner as each ray sees it.
#[inline(always)]
fn seen(corner: [&Eight; 3], origin: [&Eight; 3], slope: &[Eight; 2]) -> Sheared<f64, LANES> {
    triangle_lanes::seen(|k, i| corner[k][i], |k, i| origin[k][i], |k, i| slope[k][i])
}

/// How large the products in an edge function are.
#[inline(always)]
fn products(p: &Sheared<f64, LANES>, q: &Sheared<f64, LANES>) -> Eight {
    row(|i| (q[0][i] * p[1][i]).abs() + (q[1][i] * p[0][i]).abs())
}

/// A row of what is the same operation in each lane.
#[inline(always)]
fn row(f: impl Fn(usize) -> f64) -> Eight {
    let mut row = [0.0; LANES];
    for (i, out) in row.iter_mut().enumerate() {
        *out = f(i);
    }
    row
}
