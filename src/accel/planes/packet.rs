//! Sixteen rays through the tree together. They go the same way along each axis, so the same child comes first for all
//! of them; a child is visited if one ray reaches it. Source: Wald 2004, "Realtime ray tracing and interactive global
//! illumination", section 7.2.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use super::{LEAF, MAX_DEPTH, Planes};
use crate::accel::local::{Frame, larger, smaller};
use crate::accel::packet::{Follow, Hits, RAYS, Rays, Row};
use crate::accel::simd::{Isa, Level};
use crate::probe::NONE;

/// The part of each ray inside a cell, as t'. It ends before it starts for rays that do not reach the cell.
#[derive(Clone, Copy)]
struct Part {
    min: Row<f32>,
    max: Row<f32>,
}

/// A child that is still to be visited.
#[derive(Clone, Copy)]
struct Pending {
    child: u32,
    part: Part,
}

impl Pending {
    const NONE: Self = Self {
        child: 0,
        part: Part {
            min: [0.0; RAYS],
            max: [0.0; RAYS],
        },
    };
}

/// Room for the children that wait: each level of the tree leaves at most one behind.
pub struct Waiting([Pending; MAX_DEPTH as usize]);

impl Default for Waiting {
    fn default() -> Self {
        Self([Pending::NONE; MAX_DEPTH as usize])
    }
}

/// Which rays were tested against which primitives last: a primitive is often in several leaves next to each other.
/// Source: Amanatides and Woo 1987 (mailboxes).
struct Tested([(u32, u32); 8]);

impl Follow for Planes {
    type Waiting = Waiting;

    fn frame(&self) -> Option<&Frame> {
        // Planes at an angle have no side that is near for all rays.
        let is_followed = !self.tree.nodes.is_empty() && self.tree.tilted.is_empty();
        is_followed.then_some(&self.frame)
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
        descend::<ANY, L>(self, level, rays, hits, &mut waiting.0);
    }
}

#[inline(always)]
fn descend<const ANY: bool, L: Level>(
    planes: &Planes,
    level: L,
    rays: &mut Rays,
    hits: &mut Hits,
    stack: &mut [Pending; MAX_DEPTH as usize],
) {
    let mut part = Part::of(rays, &planes.bounds);
    // The rays that reach the node at hand.
    let mut met = part.reaching(level);
    if met == 0 {
        return;
    }
    let mut waiting = 0;
    let mut tested = Tested([(NONE, 0); 8]);
    let mut id = 0;
    loop {
        // Down to a leaf: the first child at once, the second one later.
        let leaf = loop {
            let node = planes.tree.nodes[id as usize];
            if node.kind() == LEAF {
                break node;
            }
            let axis = node.kind() as usize;
            let front = rays.backwards[axis] as u32;
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
                stack[waiting] = Pending {
                    child: second,
                    part: Part {
                        min: level.max16(&part.min, &enter),
                        max: part.max,
                    },
                };
                part.max = level.min16(&part.max, &leave);
                waiting += 1;
                (id, met) = (first, before);
            }
        };
        for &primitive in planes.tree.primitives(leaf) {
            let met = tested.add(primitive, met);
            if met != 0 {
                let outline = &planes.outlines[primitive as usize];
                outline.meet::<ANY, L>(level, (rays, hits), primitive, met);
            }
        }
        loop {
            if waiting == 0 {
                return;
            }
            waiting -= 1;
            (id, part) = (stack[waiting].child, stack[waiting].part);
            // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
            part.max = level.min16(&part.max, &rays.max);
            met = part.reaching(level);
            if met != 0 {
                break;
            }
        }
    }
}

impl Part {
    /// The part of each ray inside a box.
    #[inline(always)]
    fn of(rays: &Rays, bounds: &[[f32; 3]; 2]) -> Self {
        let (mut min, mut max) = (rays.min, rays.max);
        for (k, &near) in rays.backwards.iter().enumerate() {
            let inverse = &rays.inverse[k];
            let (first, last) = (bounds[near][k], bounds[1 - near][k]);
            for i in 0..RAYS {
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

impl Tested {
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
