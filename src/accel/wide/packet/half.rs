//! The double-precision half of eight rays: the triangle test over lanes, and the closest hits so far.

use crate::accel::Query;
use crate::accel::simd::Level;
use crate::accel::wide::local::Local;
use crate::accel::wide::{LEAF, lanes};
use crate::geometry::triangle::CANCELLED;
use crate::geometry::{Hit, Shear};
use crate::math::Interval;
use crate::probe::{NONE, Silent};

/// Rays in it.
pub const HALF: usize = 8;

type Row = [f64; HALF];

/// Eight rays and their closest hits.
#[derive(Clone)]
pub struct Half {
    /// The rays' origins and views, the axes in the order of the view.
    origin: [Row; 3],
    slope: [Row; 2],
    stretch: Row,
    interval: [Row; 2],
    /// t' = (t - start) rate.
    start: Row,
    rate: Row,
    /// The hits: t, which primitive (or [`NONE`]), its edge functions and their sum.
    t: Row,
    primitive: [u32; HALF],
    functions: [Row; 3],
    area: Row,
}

impl Half {
    /// Rays that hit nothing.
    pub const NONE: Self = Self {
        origin: [[0.0; HALF]; 3],
        slope: [[0.0; HALF]; 2],
        stretch: [0.0; HALF],
        interval: [[f64::INFINITY; HALF], [f64::NEG_INFINITY; HALF]],
        start: [0.0; HALF],
        rate: [1.0; HALF],
        t: [f64::INFINITY; HALF],
        primitive: [NONE; HALF],
        functions: [[0.0; HALF]; 3],
        area: [1.0; HALF],
    };

    /// Puts a ray into a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, shear: &Shear, interval: Interval, local: &Local) {
        for k in 0..3 {
            self.origin[k][lane] = shear.origin[shear.axes[k]];
        }
        self.slope[0][lane] = shear.s.x;
        self.slope[1][lane] = shear.s.y;
        self.stretch[lane] = shear.s.z;
        self.interval[0][lane] = interval.min;
        self.interval[1][lane] = interval.max;
        self.start[lane] = local.start;
        self.rate[lane] = local.rate;
    }

    /// The closest hit of a lane.
    #[inline]
    pub fn hit(&self, lane: usize) -> Option<Hit> {
        (self.primitive[lane] != NONE).then(|| Hit {
            t: self.t[lane],
            primitive: self.primitive[lane],
            barycentric: std::array::from_fn(|k| self.functions[k][lane] / self.area[lane]),
        })
    }

    /// Tests one primitive against one ray, whatever it is.
    #[inline(never)]
    pub fn test(&mut self, query: &Query, lane: usize, primitive: u32) {
        let mut best = self.hit(lane);
        query.test(primitive, &mut best, &mut Silent);
        if let Some(hit) = best {
            self.t[lane] = hit.t;
            self.primitive[lane] = hit.primitive;
            // Weights that are ready: divided by 1 they stay what they are.
            for k in 0..3 {
                self.functions[k][lane] = hit.barycentric[k];
            }
            self.area[lane] = 1.0;
        }
    }

    /// Brings the ends of the rays, as t', to their hits; to before their starts if any hit will do.
    #[inline(always)]
    pub fn shorten<const ANY: bool>(&self, max: &mut [f32]) {
        for (i, max) in max.iter_mut().enumerate() {
            let end = if ANY {
                if self.primitive[i] == NONE {
                    f32::INFINITY
                } else {
                    -1.0
                }
            } else {
                // Upwards by more than two roundings.
                let t = (self.t[i] - self.start[i]) * self.rate[i];
                t.max(0.0) as f32 * (1.0 + 2.0 * f32::EPSILON) + f32::MIN_POSITIVE
            };
            *max = if end < *max { end } else { *max };
        }
    }

    /// Tests the triangle of a block's lane against the rays of the mask `met`. The coordinates come
    /// in the order of the view, of each those of all corners. Returns which
    /// rays it is now the closest hit of, and for which the rare branches of the test are needed: those are left.
    #[inline(always)]
    pub fn cross<L: Level>(
        &mut self,
        level: L,
        corners: [&[[f64; LEAF]; 3]; 3],
        lane: usize,
        primitive: u32,
        met: u32,
    ) -> (u32, u32) {
        let see = |k: usize| {
            let [x, y, z] = [
                corners[0][k][lane],
                corners[1][k][lane],
                corners[2][k][lane],
            ];
            lanes::seen::<HALF>(
                |k, _| [x, y, z][k],
                |k, i| self.origin[k][i],
                |k, i| self.slope[k][i],
            )
        };
        let [a, b, c] = [see(0), see(1), see(2)];
        let [u, v, w] = [
            lanes::edge(&b, &c),
            lanes::edge(&c, &a),
            lanes::edge(&a, &b),
        ];
        let candidates = level.positive8(&lanes::inside(&u, &v, &w)) & met;
        if candidates == 0 {
            return (0, 0);
        }

        let area = row(|i| u[i] + v[i] + w[i]);
        let depths = [0, 1, 2].map(|k| {
            let z = corners[2][k][lane];
            row(|i| self.stretch[i] * (z - self.origin[2][i]))
        });
        let t =
            row(|i| (u[i] * depths[0][i] + v[i] * depths[1][i] + w[i] * depths[2][i]) / area[i]);
        let products = |p: &lanes::Seen<HALF>, q: &lanes::Seen<HALF>| {
            row(|i| (q[0][i] * p[1][i]).abs() + (q[1][i] * p[0][i]).abs())
        };
        let [x, y, z] = [products(&b, &c), products(&c, &a), products(&a, &b)];
        let kept = row(|i| area[i].abs() - CANCELLED * (x[i] + y[i] + z[i]));
        let nothing = [0.0; HALF];
        let crossed = [&u, &v, &w].map(|f| level.less8(&nothing, &row(|i| f[i].abs())));
        let plain = level.positive8(&kept) & crossed[0] & crossed[1] & crossed[2];

        let inside = level.less8(&self.interval[0], &t) & level.less8(&t, &self.interval[1]);
        let hits = candidates & plain & inside;
        let closer = level.less8(&t, &self.t);
        let mut taken = hits & closer;
        // As close: the smaller id counts.
        let mut equal = hits & !closer & !level.less8(&self.t, &t);
        while equal != 0 {
            let i = equal.trailing_zeros();
            equal &= equal - 1;
            taken |= u32::from(primitive < self.primitive[i as usize]) << i;
        }
        if taken != 0 {
            level.put8(taken, &t, &mut self.t);
            level.put8(taken, &area, &mut self.area);
            for (f, kept) in [&u, &v, &w].into_iter().zip(&mut self.functions) {
                level.put8(taken, f, kept);
            }
            for (i, kept) in self.primitive.iter_mut().enumerate() {
                *kept = if taken >> i & 1 == 1 {
                    primitive
                } else {
                    *kept
                };
            }
        }
        (taken, candidates & !plain)
    }
}

/// A row of what is the same operation in each lane.
#[inline(always)]
fn row(f: impl Fn(usize) -> f64) -> Row {
    let mut row = [0.0; HALF];
    for (i, out) in row.iter_mut().enumerate() {
        *out = f(i);
    }
    row
}
