//! BSP traversal in the wrong order, back to front: only for looking at, to see what the right one saves.
//!
//! It answers as the right order does. But a hit in a far child says nothing about the near one, so no part of the tree that the ray
//! reaches is ever left out. Pictures are never made with it.

use super::{Bsp, LEAF};
use crate::accel::collect::Collect;
use crate::accel::query::Query;
use crate::accel::volume::Volume;
use crate::math::Interval;
use crate::probe::{Choice, Event, NONE, Probe, Visit, tell};

/// What is still to be done: to test what lies on this node's plane, then to visit a child.
struct LaterPart {
    on: u32,
    child: u32,
    inside: Interval,
}

impl Bsp {
    /// Follows a ray with the far child of each node before the near one.
    pub fn search_far_first<C: Collect, P: Probe>(
        &self,
        query: &Query,
        found: &mut C,
        probe: &mut P,
    ) {
        let root = self.bounds().map(Volume::Box);
        let entry = query.enter(&self.unbounded, root, &self.tolerance, found, probe);
        let Some((tolerance, inside)) = entry else {
            return;
        };
        let walker = super::traverse::Walker::new(&query.ray, tolerance);
        let mut stack = vec![LaterPart {
            on: NONE,
            child: 0,
            inside,
        }];
        while let Some(LaterPart { on, child, inside }) = stack.pop() {
            if on != NONE && query.test_all(self.primitives(&self.nodes[on as usize]), found, probe)
            {
                return;
            }
            let (mut id, mut inside) = (child, inside);
            let leaf = loop {
                let node = &self.nodes[id as usize];
                if node.plane == LEAF {
                    break node;
                }
                let crossing = self.cross(&walker, id, node, inside);
                tell!(probe, Event::Visit(crossing.visit(id, inside)));
                if !crossing.near_missed && !crossing.far_missed {
                    stack.push(LaterPart {
                        on: if node.count > 0 { id } else { NONE },
                        child: crossing.near,
                        inside: crossing.near_part,
                    });
                }
                (id, inside) = if crossing.far_missed {
                    (crossing.near, crossing.near_part)
                } else {
                    (crossing.far, crossing.far_part)
                };
            };
            tell!(probe, Visit::end(id, inside, Choice::Leaf));
            if query.test_all(self.primitives(leaf), found, probe) {
                return;
            }
        }
    }
}
