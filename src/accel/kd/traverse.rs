//! Following a ray through the tree, front to back: the near child at once, the far one from a stack.

use super::{Kd, LEAF, MAX_DEPTH};
use crate::accel::Query;
use crate::accel::bsp::traverse::{Walker, ended};
use crate::geometry::Hit;
use crate::math::{DVec3, Interval};
use crate::probe::{Choice, Event, Probe};

/// A far child that is still to be visited.
#[derive(Clone, Copy)]
struct Pending {
    child: u32,
    /// The part of the ray inside it.
    inside: Interval,
}

impl Kd {
    /// The closest hit.
    pub fn closest<P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        self.search::<false, P>(query, probe)
    }

    /// The first hit that turns up.
    pub fn any<P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        self.search::<true, P>(query, probe)
    }

    // Never inlined: so that a build with and one without probe calls differ in nothing else.
    #[inline(never)]
    fn search<const ANY: bool, P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        let mut best = None;
        if query.test_all::<ANY, P>(&self.outside, &mut best, probe) || self.nodes.is_empty() {
            return best;
        }
        let slack = self.slack.around(query.ray.origin);
        let bounds = self.bounds.padded(DVec3::splat(slack));
        let Some(inside) = bounds.clip(&query.ray, query.interval) else {
            if P::TRAVERSAL {
                probe.event(ended(0, query.interval, Choice::SkippedOutside));
            }
            return best;
        };
        let walker = Walker::new(&query.ray, slack);

        // Each level of the tree leaves at most one far child behind.
        let root = Pending { child: 0, inside };
        let mut stack = [root; MAX_DEPTH as usize + 2];
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let next = stack[waiting];
            // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
            if best.is_some_and(|hit| hit.t < next.inside.min) {
                if P::TRAVERSAL {
                    probe.event(ended(next.child, next.inside, Choice::SkippedCloserHit));
                }
                continue;
            }
            // Down to a leaf: the near child at once, the far one later.
            let (mut id, mut inside) = (next.child, next.inside);
            let leaf = loop {
                let node = &self.nodes[id as usize];
                if node.kind >= LEAF {
                    break node;
                }
                let axis = node.kind as usize;
                let crossing = walker.cross(
                    [id + 1, node.link],
                    walker.origin[axis] - node.d,
                    walker.direction[axis],
                    walker.inverse[axis],
                    inside,
                );
                if P::TRAVERSAL {
                    probe.event(Event::Visit(crossing.visit(id, inside)));
                }
                if !crossing.near_missed && !crossing.far_missed {
                    stack[waiting] = Pending {
                        child: crossing.far,
                        inside: crossing.far_part,
                    };
                    waiting += 1;
                }
                (id, inside) = if crossing.near_missed {
                    (crossing.far, crossing.far_part)
                } else {
                    (crossing.near, crossing.near_part)
                };
            };
            if P::TRAVERSAL {
                probe.event(ended(id, inside, Choice::Leaf));
            }
            if query.test_all::<ANY, P>(self.primitives(leaf), &mut best, probe) {
                return best;
            }
        }
        best
    }
}
