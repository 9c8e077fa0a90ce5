//! Traversal by a packet of sixteen rays. They go the same way along each axis, so the same child comes first for all
//! of them; a child is visited if one ray reaches it. Source: Wald 2004, "Realtime ray tracing and interactive global
//! illumination", section 7.2.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use super::{CompactTree, LEAF, MAX_DEPTH};
use crate::accel::fast::local_ray::{UnitBox, larger, smaller};
use crate::accel::fast::packet::{Lanes, PACKET_SIZE, PacketHits, PacketTree, RayPacket};
use crate::accel::fast::simd::{Isa, Level};
use crate::probe::NONE;

/// The part of each ray inside a cell, as t'. It ends before it starts for rays that do not reach the cell.
#[derive(Clone, Copy, Default)]
struct RayParts {
    min: Lanes<f32>,
    max: Lanes<f32>,
}

/// A child that is still to be visited.
#[derive(Clone, Copy)]
struct Pending {
    child: u32,
    part: RayParts,
}

/// Stack of a packet: each level of the tree leaves at most one child behind. (What is not used is not written either.)
pub struct Stack(Vec<Pending>);

impl Default for Stack {
    fn default() -> Self {
        Self(Vec::with_capacity(MAX_DEPTH as usize))
    }
}

/// Mailboxes: which rays were tested against which primitives last, since a primitive is often in several leaves next to
/// each other. Source: Amanatides and Woo 1987.
struct Mailboxes([(u32, u32); 8]);

impl PacketTree for CompactTree {
    type Stack = Stack;

    fn unit_box(&self) -> Option<&UnitBox> {
        // Planes at an angle have no side that is near for all rays.
        let is_traced = !self.tree.nodes.is_empty() && self.tree.oblique.is_empty();
        is_traced.then_some(&self.unit_box)
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
        descend::<ANY, L>(self, level, rays, hits, &mut stack.0);
    }
}

/// Follows a packet through the tree.
#[inline(always)]
fn descend<const ANY: bool, L: Level>(
    tree: &CompactTree,
    level: L,
    rays: &mut RayPacket,
    hits: &mut PacketHits,
    stack: &mut Vec<Pending>,
) {
    stack.clear();
    let mut part = RayParts::of(rays, &tree.bounds);
    // The mask of rays that reach the node.
    let mut met = part.reaching(level);
    if met == 0 {
        return;
    }
    let mut id = 0;
    let mut mailboxes = Mailboxes([(NONE, 0); 8]);
    loop {
        // Down to a leaf: the first child at once, the second one later.
        let leaf = loop {
            let node = tree.tree.nodes[id as usize];
            if node.kind() == LEAF {
                break node;
            }
            let axis = node.kind() as usize;
            let front = rays.negative[axis] as u32;
            let (first, second) = (node.first() + front, node.first() + 1 - front);
            let (inverse, near, far) = (&rays.inverse[axis], &rays.near[axis], &rays.far[axis]);
            let leave = level.multiply_subtract16(node.value, inverse, far);
            let enter = level.multiply_subtract16(node.value, inverse, near);
            let before = level.le16(&part.min, &leave) & met;
            let beyond = level.le16(&enter, &part.max) & met;
            // On one side only, the part of every ray stays as it is.
            if before == 0 {
                id = second;
            } else if beyond == 0 {
                id = first;
            } else {
                let min = level.max16(&part.min, &enter);
                stack.push(Pending {
                    child: second,
                    part: RayParts { min, max: part.max },
                });
                part.max = level.min16(&part.max, &leave);
                (id, met) = (first, before);
            }
        };
        for &primitive in tree.tree.primitives(leaf) {
            let met = mailboxes.add(primitive, met);
            if met != 0 {
                let triangle = &tree.triangles_f32[primitive as usize];
                triangle.test::<ANY, L>(level, rays, hits, primitive, met);
            }
        }
        loop {
            let Some(pending) = stack.pop() else {
                return;
            };
            (id, part) = (pending.child, pending.part);
            // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
            part.max = level.min16(&part.max, &rays.max);
            met = part.reaching(level);
            if met != 0 {
                break;
            }
        }
    }
}

impl RayParts {
    /// The part of each ray inside a box.
    #[inline(always)]
    fn of(rays: &RayPacket, bounds: &[[f32; 3]; 2]) -> Self {
        let (mut min, mut max) = (rays.min, rays.max);
        for (k, &near) in rays.negative.iter().enumerate() {
            let inverse = &rays.inverse[k];
            let (first, last) = (bounds[near][k], bounds[1 - near][k]);
            for i in 0..PACKET_SIZE {
                min[i] = larger(min[i], first * inverse[i] - rays.near[k][i]);
                max[i] = smaller(max[i], last * inverse[i] - rays.far[k][i]);
            }
        }
        Self { min, max }
    }

    /// The mask of rays that have a part.
    #[inline(always)]
    fn reaching<L: Level>(&self, level: L) -> u32 {
        level.le16(&self.min, &self.max)
    }
}

impl Mailboxes {
    /// Adds rays; returns those that were not there.
    #[inline(always)]
    fn add(&mut self, primitive: u32, met: u32) -> u32 {
        let (last, rays) = &mut self.0[primitive as usize % 8];
        if *last != primitive {
            (*last, *rays) = (primitive, met);
            return met;
        }
        let new = met & !*rays;
        *rays |= met;
        new
    }
}
