//! Sixteen rays through the tree together: rays that start close to each other and go the same way meet the same
//! boxes and triangles.
//!
//! A node's eight boxes are first tested against all rays at once, by interval arithmetic; then each box that is left
//! against each ray. Source: Boulos, Wald and Shirley 2006, "Geometric and arithmetic culling methods for entire ray
//! packets"; Wald, Boulos and Shirley 2007, "Ray tracing deformable scenes using dynamic bounding volume
//! hierarchies".
//!
//! A triangle is tested in single precision first (see `filter`). One that a ray may hit is put off: most rays meet
//! only one on their whole way, and at the end all rays decide in double precision together. One that is surely hit
//! already hides what lies behind it.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use super::filter::{depth_doubt, depth_inside, doubt};
use super::single::{larger, smaller};
use super::{BLOCK, Block, DEEP, Node, WIDTH, Wide};
use crate::accel::Query;
use crate::accel::simd::{Level, Task};
use crate::geometry::{Hit, Shape};
use crate::math::{Interval, Ray};
use crate::probe::{NONE, Silent};

mod decide;
mod rays;

use decide::{LANES, Pairs};
pub use rays::RAYS;
use rays::{Rays, Row, folded};

/// The closest hits of at most [`RAYS`] rays; false, and nothing done, if they do not go together.
#[inline]
pub fn closest(
    wide: &Wide,
    shapes: &[Shape],
    rays: &[(Ray, Interval)],
    out: &mut [Option<Hit>],
) -> bool {
    let best = &mut out[..rays.len().min(RAYS)];
    let asked = Asked {
        wide,
        shapes,
        rays,
        best,
    };
    wide.isa.run(Together::<false>(asked)).is_some()
}

/// Whether each of at most [`RAYS`] rays hits anything; false, and nothing done, if they do not go together.
#[inline]
pub fn any(wide: &Wide, shapes: &[Shape], rays: &[(Ray, Interval)], out: &mut [bool]) -> bool {
    let best = &mut [None; RAYS][..rays.len().min(RAYS)];
    let asked = Asked {
        wide,
        shapes,
        rays,
        best,
    };
    let Some(found) = wide.isa.run(Together::<true>(asked)) else {
        return false;
    };
    for (i, out) in out.iter_mut().enumerate().take(rays.len()) {
        *out = found >> i & 1 == 1;
    }
    true
}

/// Rays that may go together, and room for their hits.
struct Asked<'a> {
    wide: &'a Wide,
    shapes: &'a [Shape],
    rays: &'a [(Ray, Interval)],
    best: &'a mut [Option<Hit>],
}

struct Together<'a, const ANY: bool>(Asked<'a>);

impl<const ANY: bool> Task for Together<'_, ANY> {
    /// The mask of rays that surely hit, if any hit will do.
    type Output = Option<u32>;

    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Option<u32> {
        let Self(asked) = self;
        if asked.wide.nodes.is_empty() {
            return None;
        }
        let rays = Rays::new(level, &asked.wide.frame, asked.rays)?;
        asked.best.fill(None);
        let mut packet = Packet {
            all: Bounds::new(&rays),
            rays,
            pending: [NONE; RAYS],
            nearest: [0.0; RAYS],
            found: 0,
            asked,
        };
        packet.test_outside::<ANY>();
        packet.follow::<ANY, L>(level);
        packet.decide(level);
        Some(packet.found)
    }
}

/// Sixteen rays, each of their numbers side by side.
struct Packet<'a> {
    asked: Asked<'a>,
    rays: Rays,
    all: Bounds,
    /// Which triangle each ray has put off, or [`NONE`], and where it is hit at the nearest, as t'.
    pending: Row<u32>,
    nearest: Row<f32>,
    /// The mask of rays that hit something, if any hit will do.
    found: u32,
}

/// Bounds for all rays of a packet.
struct Bounds {
    /// The origins, moved by the pad, from which near planes are nearest and far planes farthest.
    near: [f32; 3],
    far: [f32; 3],
    /// The least and greatest inverses of the directions.
    least: [f32; 3],
    greatest: [f32; 3],
    min: f32,
    max: f32,
}

impl Packet<'_> {
    /// Tests what is outside the tree.
    #[inline(always)]
    fn test_outside<const ANY: bool>(&mut self) {
        let Asked { wide, rays, .. } = self.asked;
        for &primitive in &wide.outside {
            for i in 0..rays.len().min(RAYS) {
                self.test::<ANY>(i, primitive);
            }
        }
        self.shorten();
    }

    /// Tests one primitive against one ray, whatever it is.
    #[inline(never)]
    fn test<const ANY: bool>(&mut self, lane: usize, primitive: u32) {
        let Asked { shapes, rays, .. } = self.asked;
        let (ray, interval) = &rays[lane];
        let best = &mut self.asked.best[lane];
        Query::new(shapes, ray, *interval).test(primitive, best, &mut Silent);
        if let Some(hit) = best {
            if ANY {
                self.found |= 1 << lane;
                self.rays.max[lane] = -1.0;
            } else {
                self.rays.end(lane, hit.t);
            }
        }
    }

    /// Brings the end of all to the last end of one.
    #[inline(always)]
    fn shorten(&mut self) {
        self.all.max = folded(self.rays.max, larger);
    }

    #[inline(always)]
    fn follow<const ANY: bool, L: Level>(&mut self, level: L) {
        // Children that wait, the nearest on top: where the first ray enters at the earliest, and the place of the
        // child in all nodes.
        let wide = self.asked.wide;
        let mut stack = [0u64; DEEP];
        let mut waiting = 0;
        let mut id = 0;
        loop {
            let node = &wide.nodes[id as usize];
            let (near, far) = self.all.cross(node, self.rays.backwards);
            let mut met = level.le8(&near, &far);
            let first = waiting;
            while met != 0 {
                let child = met.trailing_zeros();
                met &= met - 1;
                let key = u64::from(near[child as usize].to_bits()) << 32
                    | (u64::from(id) * WIDTH as u64 + u64::from(child));
                let mut place = waiting;
                while place > first && stack[place - 1] < key {
                    stack[place] = stack[place - 1];
                    place -= 1;
                }
                stack[place] = key;
                waiting += 1;
            }
            id = loop {
                if waiting == 0 {
                    return;
                }
                waiting -= 1;
                let enter = f32::from_bits((stack[waiting] >> 32) as u32);
                // As for one ray: a hit at the very entry does not count.
                if enter > self.all.max {
                    continue;
                }
                let place = stack[waiting] as u32 as usize;
                let (node, slot) = (&wide.nodes[place / WIDTH], place % WIDTH);
                let met = self.cross(level, node, slot);
                if met == 0 {
                    continue;
                }
                let child = node.children[slot];
                if child & BLOCK == 0 {
                    break child;
                }
                let block = &wide.blocks[(child & !BLOCK) as usize];
                if self.meet::<ANY, L>(level, block, met) {
                    self.shorten();
                    if self.all.max < 0.0 {
                        return;
                    }
                }
            };
        }
    }

    /// Which rays meet a box.
    #[inline(always)]
    fn cross<L: Level>(&self, level: L, node: &Node, slot: usize) -> u32 {
        let Rays {
            inverse: inv,
            near,
            far,
            min,
            max,
            backwards,
            ..
        } = &self.rays;
        let n: [f32; 3] = std::array::from_fn(|k| node.planes[2 * k + backwards[k]][slot]);
        let f: [f32; 3] = std::array::from_fn(|k| node.planes[2 * k + 1 - backwards[k]][slot]);
        let (mut enter, mut leave) = ([0.0; RAYS], [0.0; RAYS]);
        for i in 0..RAYS {
            let t = |k: usize| level.multiply_subtract(n[k], inv[k][i], near[k][i]);
            enter[i] = larger(larger(larger(t(0), t(1)), t(2)), min[i]);
            let t = |k: usize| level.multiply_subtract(f[k], inv[k][i], far[k][i]);
            leave[i] = smaller(smaller(smaller(t(0), t(1)), t(2)), max[i]);
        }
        level.le16(&enter, &leave)
    }

    /// Tests the primitives of a block against the rays of the mask `met`; true if a ray became shorter.
    #[inline(always)]
    fn meet<const ANY: bool, L: Level>(&mut self, level: L, block: &Block, met: u32) -> bool {
        let doubt = doubt(block.size, self.rays.pad);
        let mut shorter = false;
        for (lane, &primitive) in block.primitives().iter().enumerate() {
            if block.others >> lane & 1 == 1 {
                for i in each(met) {
                    self.test::<ANY>(i, primitive);
                }
                shorter = true;
            } else {
                let axes = self.rays.axes;
                let corners = axes.map(|axis| block.corners[axis].map(|row| row[lane]));
                shorter |= self.meet_triangle::<ANY, L>(level, corners, doubt, primitive, met);
            }
        }
        shorter
    }

    /// Tests a triangle against the rays of the mask `met`; true if a ray became shorter. The coordinates come in the
    /// order of the view, of each those of all corners.
    #[inline(always)]
    fn meet_triangle<const ANY: bool, L: Level>(
        &mut self,
        level: L,
        corners: [[f32; 3]; 3],
        doubt: f32,
        primitive: u32,
        met: u32,
    ) -> bool {
        let Rays { axes, origin, .. } = &self.rays;
        let o = axes.map(|axis| &origin[axis]);
        let slope = &self.rays.slope;
        let depth =
            depth_inside::<RAYS>(|c, k, _| corners[k][c], |k, i| o[k][i], |k, i| slope[k][i]);
        let mut may = level.le16(&[-doubt; RAYS], &depth) & met;
        if may == 0 {
            return false;
        }
        // The corners' depths: where the triangle begins and ends on each ray.
        let z = corners[2];
        let (low, high) = (
            smaller(smaller(z[0], z[1]), z[2]),
            larger(larger(z[0], z[1]), z[2]),
        );
        let (first, last) = if self.rays.backwards[axes[2]] == 1 {
            (high, low)
        } else {
            (low, high)
        };
        let (mut nearest, mut farthest) = ([0.0; RAYS], [0.0; RAYS]);
        let (rate, error) = (&self.rays.inverse[axes[2]], depth_doubt(self.rays.pad));
        for i in 0..RAYS {
            nearest[i] = (first - o[2][i]) * rate[i] - error;
            farthest[i] = (last - o[2][i]) * rate[i] + error;
        }
        may &= level.le16(&nearest, &self.rays.max);
        let surely = level.le16(&[doubt; RAYS], &depth)
            & level.le16(&self.rays.min, &nearest)
            & level.le16(&farthest, &self.rays.max)
            & may;
        if ANY {
            for i in each(may & !surely) {
                self.test::<ANY>(i, primitive);
            }
            self.found |= surely;
            for i in each(surely) {
                self.rays.max[i] = -1.0;
            }
            return may != 0;
        }
        // Behind what was put off: the double test of that comes now, unless this one surely hides it.
        for i in each(may) {
            let hides = surely >> i & 1 == 1 && farthest[i] < self.nearest[i];
            if self.pending[i] != NONE && !hides {
                self.test::<ANY>(i, self.pending[i]);
            }
            self.pending[i] = primitive;
            self.nearest[i] = nearest[i];
        }
        for i in each(surely) {
            self.rays.max[i] = smaller(self.rays.max[i], farthest[i]);
        }
        surely != 0
    }

    /// The double test of all that was put off.
    #[inline(always)]
    fn decide<L: Level>(&mut self, level: L) {
        let Asked { shapes, rays, .. } = self.asked;
        for half in 0..RAYS / LANES {
            let mut pairs = Pairs::NONE;
            let mut open = 0;
            for lane in 0..LANES {
                let (i, primitive) = (half * LANES + lane, self.pending[half * LANES + lane]);
                if primitive == NONE {
                    continue;
                }
                if let Shape::Triangle(triangle) = &shapes[primitive as usize] {
                    open |= 1 << lane;
                    pairs.set(lane, &rays[i], triangle);
                }
            }
            if open == 0 {
                continue;
            }
            let found = pairs.decide(level);
            for lane in each(found.hits & open) {
                let i = half * LANES + lane;
                let hit = found.hit(lane, self.pending[i]);
                let best = &mut self.asked.best[i];
                if best.is_none_or(|b| (hit.t, hit.primitive) < (b.t, b.primitive)) {
                    *best = Some(hit);
                }
            }
            for lane in each(found.rare & open) {
                let i = half * LANES + lane;
                self.test::<false>(i, self.pending[i]);
            }
        }
    }
}

/// The places of the bits of a mask.
#[inline(always)]
fn each(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (mask != 0).then(|| mask.trailing_zeros() as usize);
        mask &= mask.wrapping_sub(1);
        place
    })
}

impl Bounds {
    #[inline(always)]
    fn new(rays: &Rays) -> Self {
        let mut out = Self {
            near: [0.0; 3],
            far: [0.0; 3],
            least: rays.inverse.map(|row| folded(row, smaller)),
            greatest: rays.inverse.map(|row| folded(row, larger)),
            min: folded(rays.min, smaller),
            max: folded(rays.max, larger),
        };
        for k in 0..3 {
            let low = folded(rays.origin[k], smaller) - rays.pad;
            let high = folded(rays.origin[k], larger) + rays.pad;
            (out.near[k], out.far[k]) = if rays.backwards[k] == 1 {
                (low, high)
            } else {
                (high, low)
            };
        }
        out
    }

    /// Bounds for where the first ray enters each box and the last one leaves it.
    #[inline(always)]
    fn cross(&self, node: &Node, backwards: [usize; 3]) -> ([f32; WIDTH], [f32; WIDTH]) {
        let (mut enter, mut leave) = ([self.min; WIDTH], [self.max; WIDTH]);
        for (k, backwards) in backwards.into_iter().enumerate() {
            let (n, f) = (
                &node.planes[2 * k + backwards],
                &node.planes[2 * k + 1 - backwards],
            );
            for i in 0..WIDTH {
                let d = n[i] - self.near[k];
                enter[i] = larger(enter[i], smaller(d * self.least[k], d * self.greatest[k]));
                let d = f[i] - self.far[k];
                leave[i] = smaller(leave[i], larger(d * self.least[k], d * self.greatest[k]));
            }
        }
        (enter, leave)
    }
}
