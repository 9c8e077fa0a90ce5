//! BVH8 traversal by a packet of sixteen rays.
//!
//! A node's eight boxes are first tested against all rays at once, by interval arithmetic; then each box that is left
//! against each ray. Source: Boulos, Wald and Shirley 2006, "Geometric and arithmetic culling methods for entire ray
//! packets"; Wald, Boulos and Shirley 2007, "Ray tracing deformable scenes using dynamic bounding volume
//! hierarchies".

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use super::{Bvh8, LEAF_BIT, Leaf, MAX_STACK, Node, WIDTH};
use crate::accel::fast::local_ray::{UnitBox, larger, smaller};
use crate::accel::fast::packet::{
    PACKET_SIZE, PacketHits, PacketTree, RayPacket, reduce, set_bits,
};
use crate::accel::fast::simd::{Isa, Level};
use crate::accel::fast::triangle_filter::edge_error;

/// Boxes of leaves that are met in vain until the rays are asked at nodes as well.
const SPARSE: u32 = 4;

/// Packet on its way through the tree.
struct Packet<'a, 'b> {
    bvh8: &'a Bvh8,
    rays: &'a mut RayPacket,
    hits: &'a mut PacketHits<'b>,
    all: Bounds,
    /// Boxes of leaves that no ray met, although the bounds of all rays did.
    vain: u32,
    /// Children, the nearest on top: where the first ray enters at the earliest, and the index of the child in all nodes.
    stack: &'a mut [u64; MAX_STACK],
}

/// Stack of a packet.
pub struct Stack([u64; MAX_STACK]);

impl Default for Stack {
    fn default() -> Self {
        Self([0; MAX_STACK])
    }
}

impl PacketTree for Bvh8 {
    type Stack = Stack;

    fn unit_box(&self) -> Option<&UnitBox> {
        (!self.nodes.is_empty()).then_some(&self.unit_box)
    }

    fn unbounded(&self) -> &[u32] {
        &self.unbounded
    }

    fn isa(&self) -> Isa {
        self.isa
    }

    #[inline(always)]
    fn trace<const ANY: bool, L: Level>(
        &self,
        level: L,
        rays: &mut RayPacket,
        hits: &mut PacketHits,
        stack: &mut Stack,
    ) {
        let mut packet = Packet {
            bvh8: self,
            all: Bounds::new(rays),
            rays,
            hits,
            vain: 0,
            stack: &mut stack.0,
        };
        packet.descend::<ANY, L>(level);
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
        self.all.max = reduce(self.rays.max, larger);
    }

    #[inline(always)]
    fn descend<const ANY: bool, L: Level>(&mut self, level: L) {
        let bvh8 = self.bvh8;
        let mut count = 0;
        let mut id = 0;
        loop {
            let node = &bvh8.nodes[id as usize];
            let (near, far) = self.all.cross(node, self.rays.negative);
            let mut met = level.le8(&near, &far);
            let first = count;
            while met != 0 {
                let child = met.trailing_zeros();
                met &= met - 1;
                let key = u64::from(near[child as usize].to_bits()) << 32
                    | (u64::from(id) * WIDTH as u64 + u64::from(child));
                let mut at = count;
                while at > first && self.stack[at - 1] < key {
                    self.stack[at] = self.stack[at - 1];
                    at -= 1;
                }
                self.stack[at] = key;
                count += 1;
            }
            id = loop {
                if count == 0 {
                    return;
                }
                count -= 1;
                let enter = f32::from_bits((self.stack[count] >> 32) as u32);
                // As for one ray: a hit at the very entry does not count.
                if enter > self.all.max {
                    continue;
                }
                let index = self.stack[count] as u32 as usize;
                let (node, slot) = (&bvh8.nodes[index / WIDTH], index % WIDTH);
                let child = node.children[slot];
                // Coherent rays seldom miss a box that their bounds meet; the next node's bounds tell. Where boxes are smaller than
                // the gaps between the rays, all of them are asked.
                let is_node = child & LEAF_BIT == 0;
                if is_node && self.vain < SPARSE {
                    break child;
                }
                let met = self.cross(level, node, slot);
                if met == 0 {
                    self.vain += 1;
                    continue;
                }
                if is_node {
                    break child;
                }
                let leaf = &bvh8.leaves[(child & !LEAF_BIT) as usize];
                if self.test_leaf::<ANY, L>(level, leaf, met) {
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
        let RayPacket {
            inverse: inv,
            near,
            far,
            min,
            max,
            negative,
            ..
        } = &self.rays;
        let (mut n, mut f) = ([0.0; 3], [0.0; 3]);
        for k in 0..3 {
            n[k] = node.planes[2 * k + negative[k]][slot];
            f[k] = node.planes[2 * k + 1 - negative[k]][slot];
        }
        let (mut enter, mut leave) = ([0.0; PACKET_SIZE], [0.0; PACKET_SIZE]);
        for i in 0..PACKET_SIZE {
            let t = |k: usize| level.multiply_subtract(n[k], inv[k][i], near[k][i]);
            enter[i] = larger(larger(larger(t(0), t(1)), t(2)), min[i]);
            let t = |k: usize| level.multiply_subtract(f[k], inv[k][i], far[k][i]);
            leave[i] = smaller(smaller(smaller(t(0), t(1)), t(2)), max[i]);
        }
        level.le16(&enter, &leave)
    }

    /// Tests the primitives of a leaf against the rays of the mask `met`; true if a ray became shorter.
    #[inline(always)]
    fn test_leaf<const ANY: bool, L: Level>(&mut self, level: L, leaf: &Leaf, met: u32) -> bool {
        let error = edge_error(leaf.size, self.rays.pad);
        let mut shorter = false;
        for (lane, &primitive) in leaf.primitives().iter().enumerate() {
            if leaf.others >> lane & 1 == 1 {
                for i in set_bits(met) {
                    self.hits.test::<ANY>(self.rays, i, primitive);
                }
                shorter = true;
            } else {
                let mut corners = [[0.0; 3]; 3];
                for k in 0..3 {
                    let [a, b, c] = &leaf.corners[self.rays.axes[k]];
                    corners[k] = [a[lane], b[lane], c[lane]];
                }
                shorter |= self
                    .hits
                    .test_triangle::<ANY, L>(level, self.rays, corners, error, primitive, met);
            }
        }
        shorter
    }
}

impl Bounds {
    #[inline(always)]
    fn new(rays: &RayPacket) -> Self {
        let mut out = Self {
            near: [0.0; 3],
            far: [0.0; 3],
            least: [0.0; 3],
            greatest: [0.0; 3],
            min: reduce(rays.min, smaller),
            max: reduce(rays.max, larger),
        };
        for k in 0..3 {
            out.least[k] = reduce(rays.inverse[k], smaller);
            out.greatest[k] = reduce(rays.inverse[k], larger);
            let low = reduce(rays.origin[k], smaller) - rays.pad;
            let high = reduce(rays.origin[k], larger) + rays.pad;
            (out.near[k], out.far[k]) = if rays.negative[k] == 1 {
                (low, high)
            } else {
                (high, low)
            };
        }
        out
    }

    /// Bounds for where the first ray enters each box and the last one leaves it.
    #[inline(always)]
    fn cross(&self, node: &Node, negative: [usize; 3]) -> ([f32; WIDTH], [f32; WIDTH]) {
        let (mut enter, mut leave) = ([self.min; WIDTH], [self.max; WIDTH]);
        for (k, negative) in negative.into_iter().enumerate() {
            let (n, f) = (
                &node.planes[2 * k + negative],
                &node.planes[2 * k + 1 - negative],
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
