//! Traversal by a single ray, front to back: the first child at once, the second from a stack.

use super::{CompactNode, CompactTree, LEAF, MAX_DEPTH, OBLIQUE, OBLIQUE_THICKNESS};
use crate::accel::collect::Collect;
use crate::accel::fast::local_ray::{LocalRay, Localized, larger, nonzero, smaller};
use crate::accel::fast::simd::{Level, SimdKernel};
use crate::accel::query::Query;
use crate::math::Interval;
use crate::probe::{Choice, Event, Probe, Visit, tell};

/// A child that is still to be visited, and the part of the ray inside it.
#[derive(Clone, Copy, Default)]
struct Pending {
    child: u32,
    min: f32,
    max: f32,
}

/// Where a ray changes sides: before `leave` it may be on the first side, from `enter` on it may be on the second one.
struct PlaneCrossing {
    enter: f32,
    leave: f32,
    /// 1 if the first side is the one in front of the plane.
    front: u32,
}

impl CompactTree {
    /// Descends to the cells that the ray goes through, and tests what is in them.
    #[inline]
    pub fn search<C: Collect, P: Probe>(&self, query: &Query, found: &mut C, probe: &mut P) {
        self.isa.unless_recorded::<P>().run(Search {
            tree: self,
            query,
            found,
            probe,
        });
    }

    /// The part of a ray inside the box around everything, as t'.
    #[inline(always)]
    fn clip(&self, local: &LocalRay) -> Option<[f32; 2]> {
        let (mut min, mut max) = (local.min, local.max);
        for k in 0..3 {
            let (near, far) = (local.negative[k], 1 - local.negative[k]);
            min = larger(min, self.bounds[near][k] * local.inverse[k] - local.near[k]);
            max = smaller(max, self.bounds[far][k] * local.inverse[k] - local.far[k]);
        }
        (min <= max).then_some([min, max])
    }

    /// Where a ray crosses a node's plane.
    #[inline(always)]
    fn cross<L: Level>(&self, level: L, node: CompactNode, local: &LocalRay) -> PlaneCrossing {
        let kind = node.kind() as usize;
        if kind < OBLIQUE as usize {
            let inverse = local.inverse[kind];
            return PlaneCrossing {
                enter: level.multiply_subtract(node.value, inverse, local.near[kind]),
                leave: level.multiply_subtract(node.value, inverse, local.far[kind]),
                front: local.negative[kind] as u32,
            };
        }
        let plane = &self.tree.oblique[node.number()];
        let [x, y, z] = plane.normal;
        let dot = |v: &[f32; 3]| x * v[0] + y * v[1] + z * v[2];
        let climb = nonzero(dot(&local.direction));
        let inverse = 1.0 / climb;
        let t = (plane.d - dot(&local.origin)) * inverse;
        let half = OBLIQUE_THICKNESS * local.pad * inverse.abs();
        PlaneCrossing {
            enter: t - half,
            leave: t + half,
            front: u32::from(climb < 0.0),
        }
    }
}

struct Search<'a, C, P> {
    tree: &'a CompactTree,
    query: &'a Query<'a>,
    found: &'a mut C,
    probe: &'a mut P,
}

impl<C: Collect, P: Probe> SimdKernel for Search<'_, C, P> {
    type Output = ();

    #[inline(always)]
    fn run<L: Level>(mut self, level: L) {
        let Self { tree, query, .. } = self;
        let is_over = query.test_all(&tree.unbounded, self.found, self.probe);
        if is_over || tree.tree.nodes.is_empty() {
            return;
        }
        let entry = match tree.unit_box.localize(&query.ray, query.interval) {
            Localized::Miss => None,
            Localized::Ray(local) => tree.clip(&local).map(|inside| (local, inside)),
            Localized::Unbounded => return self.test_all(),
        };
        if let Some((local, inside)) = entry {
            self.descend(level, &local, inside);
        } else if P::TRAVERSAL {
            tell!(
                self.probe,
                Visit::end(0, query.interval, Choice::SkippedOutside)
            );
        }
    }
}

impl<C: Collect, P: Probe> Search<'_, C, P> {
    /// Tests every primitive of the tree.
    #[cold]
    #[inline(never)]
    fn test_all(self) {
        for primitive in 0..self.query.shapes.len() as u32 {
            let is_bounded = self.tree.unbounded.binary_search(&primitive).is_err();
            if is_bounded && self.query.test_all(&[primitive], self.found, self.probe) {
                return;
            }
        }
    }

    /// Follows the ray through the tree; `min` and `max` bound its part inside.
    #[inline(always)]
    fn descend<L: Level>(&mut self, level: L, local: &LocalRay, [mut min, mut max]: [f32; 2]) {
        let Self { tree, query, .. } = *self;
        let (found, probe) = (&mut *self.found, &mut *self.probe);
        let hit = found.closest();
        let mut end = hit.map_or(f32::INFINITY, |hit| local.not_before(hit.t));
        // Each level of the tree leaves at most one child behind.
        let mut stack = [Pending::default(); MAX_DEPTH as usize + 2];
        let mut count = 0;
        let mut id = 0;
        loop {
            // Down to a leaf: the first child at once, the second one later.
            let leaf = loop {
                let node = tree.tree.nodes[id as usize];
                if node.kind() == LEAF {
                    break node;
                }
                let crossing = tree.cross(level, node, local);
                if P::TRAVERSAL {
                    tell!(probe, visit(tree, id, query, local, &crossing, [min, max]));
                }
                let first = node.first() + crossing.front;
                let second = node.first() + 1 - crossing.front;
                if crossing.leave < min {
                    (id, min) = (second, larger(min, crossing.enter));
                    continue;
                }
                if crossing.enter <= max {
                    stack[count] = Pending {
                        child: second,
                        min: larger(min, crossing.enter),
                        max,
                    };
                    count += 1;
                }
                (id, max) = (first, smaller(max, crossing.leave));
            };
            if P::TRAVERSAL {
                tell!(probe, Visit::end(id, part(local, [min, max]), Choice::Leaf));
            }
            if query.test_all(tree.tree.primitives(leaf), found, probe) {
                return;
            }
            if let Some(hit) = found.closest() {
                end = local.not_before(hit.t);
            }
            // Up to the nearest child that is left.
            loop {
                if count == 0 {
                    return;
                }
                count -= 1;
                let next = stack[count];
                // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
                if next.min <= end {
                    (id, min, max) = (next.child, next.min, smaller(next.max, end));
                    break;
                }
                if P::TRAVERSAL {
                    let inside = part(local, [next.min, next.max]);
                    tell!(
                        probe,
                        Visit::end(next.child, inside, Choice::SkippedCloserHit)
                    );
                }
            }
        }
    }
}

/// The interval of t between two t'.
fn part(local: &LocalRay, [min, max]: [f32; 2]) -> Interval {
    Interval::new(local.world(min), local.world(max))
}

/// The step at a plane as an event. Near is the side that the ray's origin is on.
fn visit(
    tree: &CompactTree,
    id: u32,
    query: &Query,
    local: &LocalRay,
    crossing: &PlaneCrossing,
    [min, max]: [f32; 2],
) -> Event {
    let children = tree.tree.nodes[id as usize].first();
    let view = tree.node(id).and_then(|node| node.plane);
    let t_split = view.map_or(f64::NAN, |(n, d)| {
        let climb = n.dot(query.ray.direction);
        if climb == 0.0 {
            f64::NAN
        } else {
            (d - n.dot(query.ray.origin)) / climb
        }
    });
    let inside = part(local, [min, max]);
    let (first_missed, second_missed) = (crossing.leave < min, crossing.enter > max);
    // Also if it runs along the plane, which it never crosses.
    let along = t_split.is_nan();
    let runs_away = first_missed && (along || t_split < 0.0);
    let near_side = crossing.front ^ u32::from(runs_away);
    let choice = match (first_missed, second_missed) {
        (true, _) if runs_away => Choice::NearRunsAway,
        (true, _) => Choice::FarSplitBefore,
        (false, true) if along => Choice::NearRunsAway,
        (false, true) => Choice::NearSplitBeyond,
        _ if inside.contains(t_split) => Choice::Both,
        _ => Choice::BothInDoubt,
    };
    Event::Visit(Visit {
        node: id,
        interval: [inside.min, inside.max],
        t_split,
        near: children + near_side,
        far: children + 1 - near_side,
        choice,
    })
}
