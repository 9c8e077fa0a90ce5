//! What the rays of a packet hit.
//!
//! A triangle is tested in single precision first (see [`crate::accel::filter`]). One that a ray may hit is put off:
//! most rays meet only one on their whole way, and at the end all rays decide in double precision together. One that is
//! surely hit already hides what lies behind it.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use super::decide::{Corners, LANES};
use super::rays::{RAYS, Rays, Row};
use crate::accel::Query;
use crate::accel::filter::{depth_doubt, depth_inside};
use crate::accel::local::{larger, smaller};
use crate::accel::simd::Level;
use crate::geometry::{Hit, Shape};
use crate::math::{Interval, Ray};
use crate::probe::{NONE, Silent};

/// So many rays of eight are decided together in less time than one by one.
const TOGETHER: u32 = 2;

/// What was asked, and what is known of the answers.
pub struct Hits<'a> {
    shapes: &'a [Shape],
    asked: &'a [(Ray, Interval)],
    /// What double precision has decided.
    best: &'a mut [Option<Hit>],
    /// The mask of rays that have put off a triangle; which it is, and where it is hit at the nearest, as t'.
    waiting: u32,
    pending: Row<u32>,
    nearest: Row<f32>,
    /// The mask of rays that hit something, if any hit will do.
    pub found: u32,
}

impl<'a> Hits<'a> {
    /// Nothing is hit yet.
    #[inline(always)]
    pub fn new(
        shapes: &'a [Shape],
        asked: &'a [(Ray, Interval)],
        best: &'a mut [Option<Hit>],
    ) -> Self {
        Self {
            shapes,
            asked,
            best,
            waiting: 0,
            pending: [NONE; RAYS],
            nearest: [0.0; RAYS],
            found: 0,
        }
    }

    /// Tests one primitive against one ray, whatever it is.
    #[inline(never)]
    pub fn test<const ANY: bool>(&mut self, rays: &mut Rays, lane: usize, primitive: u32) {
        let (ray, interval) = &self.asked[lane];
        let best = &mut self.best[lane];
        Query::new(self.shapes, ray, *interval).test(primitive, best, &mut Silent);
        if let Some(hit) = best {
            if ANY {
                self.found |= 1 << lane;
                rays.max[lane] = -1.0;
            } else {
                rays.end(lane, hit.t);
            }
        }
    }

    /// Tests a triangle against the rays of the mask `met`; true if a ray became shorter. The coordinates come in the
    /// order of the view, of each those of all corners.
    #[inline(always)]
    pub fn meet_triangle<const ANY: bool, L: Level>(
        &mut self,
        level: L,
        rays: &mut Rays,
        corners: [[f32; 3]; 3],
        doubt: f32,
        primitive: u32,
        met: u32,
    ) -> bool {
        let [x, y, z] = rays.axes;
        let o = [&rays.origin[x], &rays.origin[y], &rays.origin[z]];
        let slope = &rays.slope;
        let depth =
            depth_inside::<RAYS>(|c, k, _| corners[k][c], |k, i| o[k][i], |k, i| slope[k][i]);
        let mut may = level.le16(&[-doubt; RAYS], &depth) & met;
        if may == 0 {
            return false;
        }
        // The corners' depths: where the triangle begins and ends on each ray.
        let [a, b, c] = corners[2];
        let (low, high) = (smaller(smaller(a, b), c), larger(larger(a, b), c));
        let (first, last) = if rays.backwards[z] == 1 {
            (high, low)
        } else {
            (low, high)
        };
        let (mut nearest, mut farthest) = ([0.0; RAYS], [0.0; RAYS]);
        let (rate, error) = (&rays.inverse[z], depth_doubt(rays.pad));
        for i in 0..RAYS {
            nearest[i] = (first - o[2][i]) * rate[i] - error;
            farthest[i] = (last - o[2][i]) * rate[i] + error;
        }
        may &= level.le16(&nearest, &rays.max);
        let surely = level.le16(&[doubt; RAYS], &depth)
            & level.le16(&rays.min, &nearest)
            & level.le16(&farthest, &rays.max)
            & may;
        if ANY {
            self.find(rays, surely);
            self.decide_one(level, rays, primitive, may & !surely);
            return may != 0;
        }
        // Behind what was put off: the double test of that comes now, unless this one surely hides it.
        let hidden = surely & !level.le16(&self.nearest, &farthest);
        for i in each(may & self.waiting & !hidden) {
            if self.pending[i] != primitive {
                self.test::<ANY>(rays, i, self.pending[i]);
            }
        }
        self.waiting |= may;
        set(&mut self.pending, may, &[primitive; RAYS]);
        set(&mut self.nearest, may, &nearest);
        set(&mut rays.max, surely, &farthest);
        surely != 0
    }

    /// The rays of the mask hit something, and any hit will do.
    #[inline(always)]
    fn find(&mut self, rays: &mut Rays, mask: u32) {
        self.found |= mask;
        set(&mut rays.max, mask, &[-1.0; RAYS]);
    }

    /// The double test of one triangle against the rays of the mask, if any hit will do. Where shadow rays start and end,
    /// single precision cannot decide: neighbours meet the same triangles there.
    #[inline(always)]
    fn decide_one<L: Level>(&mut self, level: L, rays: &mut Rays, primitive: u32, mask: u32) {
        for half in 0..RAYS / LANES {
            let mut open = mask >> (half * LANES) & ((1 << LANES) - 1);
            if open.count_ones() >= TOGETHER
                && let Shape::Triangle(triangle) = &self.shapes[primitive as usize]
            {
                let found = Corners::all(triangle).decide(level, rays, half);
                self.find(rays, (found.hits & open) << (half * LANES));
                open &= found.rare;
            }
            for lane in each(open) {
                self.test::<true>(rays, half * LANES + lane, primitive);
            }
        }
    }

    /// The double test of all that was put off.
    #[inline(always)]
    pub fn decide<L: Level>(&mut self, level: L, rays: &mut Rays) {
        for half in 0..RAYS / LANES {
            if (self.waiting >> (half * LANES)).trailing_zeros() >= LANES as u32 {
                continue;
            }
            let mut corners = Corners::NONE;
            let mut open = 0;
            for lane in 0..LANES {
                let primitive = self.pending[half * LANES + lane];
                if primitive == NONE {
                    continue;
                }
                if let Shape::Triangle(triangle) = &self.shapes[primitive as usize] {
                    open |= 1 << lane;
                    corners.set(lane, triangle);
                }
            }
            let found = corners.decide(level, rays, half);
            for lane in each(found.hits & open) {
                let i = half * LANES + lane;
                let hit = found.hit(lane, self.pending[i]);
                let best = &mut self.best[i];
                if best.is_none_or(|b| (hit.t, hit.primitive) < (b.t, b.primitive)) {
                    *best = Some(hit);
                }
            }
            for lane in each(found.rare & open) {
                let i = half * LANES + lane;
                self.test::<false>(rays, i, self.pending[i]);
            }
        }
    }
}

/// Sets the numbers of a mask.
#[inline(always)]
fn set<T: Copy>(row: &mut Row<T>, mask: u32, to: &Row<T>) {
    for i in 0..RAYS {
        row[i] = if mask >> i & 1 == 1 { to[i] } else { row[i] };
    }
}

/// The places of the bits of a mask.
#[inline(always)]
pub fn each(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (mask != 0).then(|| mask.trailing_zeros() as usize);
        mask &= mask.wrapping_sub(1);
        place
    })
}
