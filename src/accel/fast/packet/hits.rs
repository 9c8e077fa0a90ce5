//! Hits of a packet of rays.
//!
//! A triangle is tested in single precision first (see [`crate::accel::fast::triangle_filter`]). A triangle that a ray may hit
//! is kept for later: most rays meet only one, and at the end those of all rays are tested in double precision at once. A
//! triangle that is surely hit already hides what lies behind it.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use super::rays::{Lanes, PACKET_SIZE, RayPacket};
use super::triangle8::{Corners, LANES};
use crate::accel::fast::local_ray::{larger, smaller};
use crate::accel::fast::simd::Level;
use crate::accel::fast::triangle_filter::{depth_error, depth_inside};
use crate::accel::query::Query;
use crate::geometry::{Hit, Shape};
use crate::math::{Interval, Ray};
use crate::probe::{NONE, Silent};

/// So many rays of eight are tested at once in less time than one by one.
const WORTH_EIGHT: u32 = 2;

/// Hits of a packet, as far as they are known.
pub struct PacketHits<'a> {
    shapes: &'a [Shape],
    queries: &'a [(Ray, Interval)],
    /// What double precision has decided.
    best: &'a mut [Option<Hit>],
    /// The mask of rays that keep a triangle for later; its id, and where it is hit at the nearest, as t'.
    kept: u32,
    pending: Lanes<u32>,
    nearest: Lanes<f32>,
    /// The mask of rays that hit something, if any hit will do.
    pub found: u32,
}

impl<'a> PacketHits<'a> {
    /// Nothing is hit yet.
    #[inline(always)]
    pub fn new(
        shapes: &'a [Shape],
        queries: &'a [(Ray, Interval)],
        best: &'a mut [Option<Hit>],
    ) -> Self {
        Self {
            shapes,
            queries,
            best,
            kept: 0,
            pending: [NONE; PACKET_SIZE],
            nearest: [0.0; PACKET_SIZE],
            found: 0,
        }
    }

    /// Tests one primitive against one ray, whatever it is.
    #[inline(never)]
    pub fn test<const ANY: bool>(&mut self, rays: &mut RayPacket, lane: usize, primitive: u32) {
        let (ray, interval) = &self.queries[lane];
        let best = &mut self.best[lane];
        let query = if self.shapes[primitive as usize].needs_view() {
            Query::new(self.shapes, ray, *interval)
        } else {
            Query::without_view(self.shapes, ray, *interval)
        };
        query.test(primitive, best, &mut Silent);
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
    pub fn test_triangle<const ANY: bool, L: Level>(
        &mut self,
        level: L,
        rays: &mut RayPacket,
        corners: [[f32; 3]; 3],
        error: f32,
        primitive: u32,
        met: u32,
    ) -> bool {
        let [x, y, z] = rays.axes;
        let o = [&rays.origin[x], &rays.origin[y], &rays.origin[z]];
        let slope = &rays.slope;
        let depth = depth_inside::<PACKET_SIZE>(
            |c, k, _| corners[k][c],
            |k, i| o[k][i],
            |k, i| slope[k][i],
        );
        let mut may = level.le16(&[-error; PACKET_SIZE], &depth) & met;
        if may == 0 {
            return false;
        }
        // The corners' depths: where the triangle begins and ends on each ray.
        let [a, b, c] = corners[2];
        let (low, high) = (smaller(smaller(a, b), c), larger(larger(a, b), c));
        let (first, last) = if rays.negative[z] == 1 {
            (high, low)
        } else {
            (low, high)
        };
        let (mut nearest, mut farthest) = ([0.0; PACKET_SIZE], [0.0; PACKET_SIZE]);
        let (rate, pad) = (&rays.inverse[z], depth_error(rays.pad));
        for i in 0..PACKET_SIZE {
            nearest[i] = (first - o[2][i]) * rate[i] - pad;
            farthest[i] = (last - o[2][i]) * rate[i] + pad;
        }
        may &= level.le16(&nearest, &rays.max);
        let surely = level.le16(&[error; PACKET_SIZE], &depth)
            & level.le16(&rays.min, &nearest)
            & level.le16(&farthest, &rays.max)
            & may;
        if ANY {
            self.find(rays, surely);
            self.test_now(level, rays, primitive, may & !surely);
            return may != 0;
        }
        // Behind what was kept: the double test of that comes now, unless this one surely hides it.
        let hidden = surely & !level.le16(&self.nearest, &farthest);
        for i in set_bits(may & self.kept & !hidden) {
            if self.pending[i] != primitive {
                self.test::<ANY>(rays, i, self.pending[i]);
            }
        }
        self.kept |= may;
        set(&mut self.pending, may, &[primitive; PACKET_SIZE]);
        set(&mut self.nearest, may, &nearest);
        set(&mut rays.max, surely, &farthest);
        surely != 0
    }

    /// The rays of the mask hit something, and any hit will do.
    #[inline(always)]
    fn find(&mut self, rays: &mut RayPacket, mask: u32) {
        self.found |= mask;
        set(&mut rays.max, mask, &[-1.0; PACKET_SIZE]);
    }

    /// The double test of one triangle against the rays of the mask, if any hit will do. Where shadow rays start and end,
    /// single precision cannot decide: neighbours meet the same triangles there.
    #[inline(always)]
    fn test_now<L: Level>(&mut self, level: L, rays: &mut RayPacket, primitive: u32, mask: u32) {
        for half in 0..PACKET_SIZE / LANES {
            let mut open = mask >> (half * LANES) & ((1 << LANES) - 1);
            if open.count_ones() >= WORTH_EIGHT
                && let Shape::Triangle(triangle) = &self.shapes[primitive as usize]
            {
                let found = Corners::all(triangle).test(level, rays, half);
                self.find(rays, (found.hits & open) << (half * LANES));
                open &= found.rare;
            }
            for lane in set_bits(open) {
                self.test::<true>(rays, half * LANES + lane, primitive);
            }
        }
    }

    /// The double test of all triangles that were kept.
    #[inline(always)]
    pub fn test_kept<L: Level>(&mut self, level: L, rays: &mut RayPacket) {
        for half in 0..PACKET_SIZE / LANES {
            if (self.kept >> (half * LANES)).trailing_zeros() >= LANES as u32 {
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
            let found = corners.test(level, rays, half);
            for lane in set_bits(found.hits & open) {
                let i = half * LANES + lane;
                let hit = found.hit(lane, self.pending[i]);
                let best = &mut self.best[i];
                if best.is_none_or(|b| (hit.t, hit.primitive) < (b.t, b.primitive)) {
                    *best = Some(hit);
                }
            }
            for lane in set_bits(found.rare & open) {
                let i = half * LANES + lane;
                self.test::<false>(rays, i, self.pending[i]);
            }
        }
    }
}

/// Sets the numbers of a mask.
#[inline(always)]
fn set<T: Copy>(row: &mut Lanes<T>, mask: u32, to: &Lanes<T>) {
    for i in 0..PACKET_SIZE {
        row[i] = if mask >> i & 1 == 1 { to[i] } else { row[i] };
    }
}

/// Indices of the bits of a mask.
#[inline(always)]
pub fn set_bits(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (mask != 0).then(|| mask.trailing_zeros() as usize);
        mask &= mask.wrapping_sub(1);
        place
    })
}
