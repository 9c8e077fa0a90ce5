//! BVH traversal, the nearest volume first.

use super::Bvh;
use crate::accel::collect::Collect;
use crate::accel::query::Query;
use crate::math::Interval;
use crate::probe::{Choice, NONE, Probe, Visit, tell};

/// Nodes on the stack at most.
const MAX_STACK: usize = 160;

/// A node that is still to be visited, and the part of the ray inside it.
type Pending = (u32, Interval);

impl Bvh {
    /// Descends into the volumes that the ray meets, and tests what is in their leaves.
    #[inline(never)]
    pub fn search<C: Collect, P: Probe>(&self, query: &Query, found: &mut C, probe: &mut P) {
        let root = self.nodes.first().map(|node| node.volume);
        let entry = query.enter(&self.unbounded, root, &self.tolerance, found, probe);
        let Some((tolerance, inside)) = entry else {
            return;
        };
        // The nearest on top.
        let mut stack = [(0, inside); MAX_STACK];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (id, inside) = stack[count];
            // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
            if found.closest().is_some_and(|hit| hit.t < inside.min) {
                if P::TRAVERSAL {
                    tell!(probe, Visit::end(id, inside, Choice::SkippedCloserHit));
                }
                continue;
            }
            let node = &self.nodes[id as usize];
            if node.leaf {
                if P::TRAVERSAL {
                    tell!(probe, Visit::end(id, inside, Choice::Leaf));
                }
                if query.test_all(self.primitives(node), found, probe) {
                    return;
                }
                continue;
            }
            let (first, mut missed) = (count, 0u32);
            for child in node.first..node.first + node.count {
                let volume = &self.nodes[child as usize].volume;
                if let Some(inside) = volume.clip(&query.ray, query.interval, tolerance) {
                    // Insertion sort by the entry.
                    let mut at = count;
                    while at > first && stack[at - 1].1.min < inside.min {
                        stack[at] = stack[at - 1];
                        at -= 1;
                    }
                    stack[at] = (child, inside);
                    count += 1;
                } else {
                    missed |= 1 << (child - node.first);
                }
            }
            if P::TRAVERSAL {
                let children = (node.first..node.first + node.count).zip(0..);
                let missed = children.filter(|(_, bit)| missed >> bit & 1 == 1);
                let missed = missed.map(|(child, _)| child);
                tell_children((id, inside), &stack[first..count], missed, probe);
            }
        }
    }
}

/// Tells which children of a node are visited, nearest first, then which are missed.
fn tell_children<P: Probe>(
    (id, inside): Pending,
    visited: &[Pending],
    missed: impl Iterator<Item = u32>,
    probe: &mut P,
) {
    let nearest = |rank| visited.iter().nth_back(rank).map_or(NONE, |child| child.0);
    tell!(probe, Visit::children(id, inside, [nearest(0), nearest(1)]));
    for child in missed {
        tell!(probe, Visit::end(child, inside, Choice::SkippedMissed));
    }
}
