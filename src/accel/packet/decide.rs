//! The double-precision test of eight rays, each against a triangle of its own: the operations of
//! [`crate::geometry::Triangle`] in the same order.

use crate::accel::lanes;
use crate::accel::simd::Level;
use crate::geometry::triangle::CANCELLED;
use crate::geometry::{Hit, Shear, Triangle};
use crate::math::{Interval, Ray};

/// Rays that are tested at once.
pub const LANES: usize = 8;

type Row = [f64; LANES];

/// Eight rays and their triangles, as far as there are any.
pub struct Pairs {
    /// The corners' coordinates in the order of the view: corner by corner x, y, z.
    corners: [[Row; 3]; 3],
    /// The rays' origins and directions in that order.
    origin: [Row; 3],
    direction: [Row; 3],
    interval: [Row; 2],
}

/// What is found.
pub struct Found {
    /// Rays that hit, and rays whose test needs one of its rare branches.
    pub hits: u32,
    pub rare: u32,
    pub t: Row,
    weights: [Row; 3],
}

impl Pairs {
    /// No ray.
    pub const NONE: Self = Self {
        corners: [[[0.0; LANES]; 3]; 3],
        origin: [[0.0; LANES]; 3],
        direction: [[0.0; LANES], [0.0; LANES], [1.0; LANES]],
        interval: [[0.0; LANES]; 2],
    };

    /// Puts a ray and its triangle into a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, (ray, interval): &(Ray, Interval), triangle: &Triangle) {
        let axes = Shear::axes(ray.direction);
        let corners = triangle.corners.map(|c| c.to_array());
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        for (k, axis) in axes.into_iter().enumerate() {
            for (row, corner) in self.corners.iter_mut().zip(&corners) {
                row[k][lane] = corner[axis];
            }
            self.origin[k][lane] = o[axis];
            self.direction[k][lane] = d[axis];
        }
        self.interval[0][lane] = interval.min;
        self.interval[1][lane] = interval.max;
    }

    /// Tests each ray against its triangle.
    #[inline(always)]
    pub fn decide<L: Level>(&self, level: L) -> Found {
        let Self {
            origin,
            direction: d,
            ..
        } = self;
        let slope = [row(|i| d[0][i] / d[2][i]), row(|i| d[1][i] / d[2][i])];
        let stretch = row(|i| 1.0 / d[2][i]);
        let [a, b, c] = [0, 1, 2].map(|corner| {
            lanes::seen::<f64, LANES>(
                |k, i| self.corners[corner][k][i],
                |k, i| origin[k][i],
                |k, i| slope[k][i],
            )
        });
        let [u, v, w] = [
            lanes::edge(&b, &c),
            lanes::edge(&c, &a),
            lanes::edge(&a, &b),
        ];
        let candidates = level.positive8(&lanes::inside(&u, &v, &w));

        let area = row(|i| u[i] + v[i] + w[i]);
        let [p, q, r] = [0, 1, 2].map(|corner| {
            let z = &self.corners[corner][2];
            row(|i| stretch[i] * (z[i] - origin[2][i]))
        });
        let t = row(|i| (u[i] * p[i] + v[i] * q[i] + w[i] * r[i]) / area[i]);
        let products = |p: &lanes::Seen<f64, LANES>, q: &lanes::Seen<f64, LANES>| {
            row(|i| (q[0][i] * p[1][i]).abs() + (q[1][i] * p[0][i]).abs())
        };
        let [x, y, z] = [products(&b, &c), products(&c, &a), products(&a, &b)];
        let kept = row(|i| area[i].abs() - CANCELLED * (x[i] + y[i] + z[i]));
        let nothing = [0.0; LANES];
        let crossed = [&u, &v, &w].map(|f| level.less8(&nothing, &row(|i| f[i].abs())));
        let plain = level.positive8(&kept) & crossed[0] & crossed[1] & crossed[2];
        let inside = level.less8(&self.interval[0], &t) & level.less8(&t, &self.interval[1]);
        Found {
            hits: candidates & plain & inside,
            rare: candidates & !plain,
            t,
            weights: [u, v, w].map(|f| row(|i| f[i] / area[i])),
        }
    }
}

impl Found {
    /// The hit of a lane, which is one of `hits`.
    #[inline(always)]
    pub fn hit(&self, lane: usize, primitive: u32) -> Hit {
        Hit {
            t: self.t[lane],
            primitive,
            barycentric: self.weights.map(|row| row[lane]),
        }
    }
}

/// A row of what is the same operation in each lane.
#[inline(always)]
fn row(f: impl Fn(usize) -> f64) -> Row {
    let mut row = [0.0; LANES];
    for (i, out) in row.iter_mut().enumerate() {
        *out = f(i);
    }
    row
}
