//! Sixteen rays through the tree together.
//!
//! A node's eight boxes are first tested against all rays at once, by interval arithmetic; then each box that is left
//! against each ray. Source: Boulos, Wald and Shirley 2006, "Geometric and arithmetic culling methods for entire ray
//! packets"; Wald, Boulos and Shirley 2007, "Ray tracing deformable scenes using dynamic bounding volume
//! hierarchies".

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use super::{BLOCK, Block, DEEP, Node, WIDTH, Wide};
use crate::accel::filter::doubt;
use crate::accel::local::{Frame, larger, smaller};
use crate::accel::packet::{Follow, Hits, RAYS, Rays, each, folded};
use crate::accel::simd::{Isa, Level};

/// Sixteen rays on their way through the tree.
struct Packet<'a, 'b> {
    wide: &'a Wide,
    rays: &'a mut Rays,
    hits: &'a mut Hits<'b>,
    all: Bounds,
    /// Children that wait, the nearest on top: where the first ray enters at the earliest, and the place of the child in
    /// all nodes.
    stack: &'a mut [u64; DEEP],
}

/// Room for the children that wait.
pub struct Waiting([u64; DEEP]);

impl Default for Waiting {
    fn default() -> Self {
        Self([0; DEEP])
    }
}

impl Follow for Wide {
    type Waiting = Waiting;

    fn frame(&self) -> Option<&Frame> {
        (!self.nodes.is_empty()).then_some(&self.frame)
    }

    fn outside(&self) -> &[u32] {
        &self.outside
    }

    fn isa(&self) -> Isa {
        self.isa
    }

    #[inline(always)]
    fn follow<const ANY: bool, L: Level>(
        &self,
        level: L,
        rays: &mut Rays,
        hits: &mut Hits,
        waiting: &mut Waiting,
    ) {
        let mut packet = Packet {
            wide: self,
            all: Bounds::new(rays),
            rays,
            hits,
            stack: &mut waiting.0,
        };
        packet.follow::<ANY, L>(level);
    }
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

impl Packet<'_, '_> {
    /// Brings the end of all to the last end of one.
    #[inline(always)]
    fn shorten(&mut self) {
        self.all.max = folded(self.rays.max, larger);
    }

    #[inline(always)]
    fn follow<const ANY: bool, L: Level>(&mut self, level: L) {
        let wide = self.wide;
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
                while place > first && self.stack[place - 1] < key {
                    self.stack[place] = self.stack[place - 1];
                    place -= 1;
                }
                self.stack[place] = key;
                waiting += 1;
            }
            id = loop {
                if waiting == 0 {
                    return;
                }
                waiting -= 1;
                let enter = f32::from_bits((self.stack[waiting] >> 32) as u32);
                // As for one ray: a hit at the very entry does not count.
                if enter > self.all.max {
                    continue;
                }
                let place = self.stack[waiting] as u32 as usize;
                let (node, slot) = (&wide.nodes[place / WIDTH], place % WIDTH);
                let child = node.children[slot];
                // Rays that go together seldom miss a box that their bounds meet; the next node's bounds tell.
                if child & BLOCK == 0 {
                    break child;
                }
                let met = self.cross(level, node, slot);
                if met == 0 {
                    continue;
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
        let (mut n, mut f) = ([0.0; 3], [0.0; 3]);
        for k in 0..3 {
            n[k] = node.planes[2 * k + backwards[k]][slot];
            f[k] = node.planes[2 * k + 1 - backwards[k]][slot];
        }
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
                    self.hits.test::<ANY>(self.rays, i, primitive);
                }
                shorter = true;
            } else {
                let mut corners = [[0.0; 3]; 3];
                for k in 0..3 {
                    let [a, b, c] = &block.corners[self.rays.axes[k]];
                    corners[k] = [a[lane], b[lane], c[lane]];
                }
                shorter |= self
                    .hits
                    .meet_triangle::<ANY, L>(level, self.rays, corners, doubt, primitive, met);
            }
        }
        shorter
    }
}

impl Bounds {
    #[inline(always)]
    fn new(rays: &Rays) -> Self {
        let mut out = Self {
            near: [0.0; 3],
            far: [0.0; 3],
            least: [0.0; 3],
            greatest: [0.0; 3],
            min: folded(rays.min, smaller),
            max: folded(rays.max, larger),
        };
        for k in 0..3 {
            out.least[k] = folded(rays.inverse[k], smaller);
            out.greatest[k] = folded(rays.inverse[k], larger);
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
