//! Following a ray through the tree, front to back: the first child at once, the second from a stack.

use super::{LEAF, MAX_DEPTH, Node, Planes, THICKER, TILTED};
use crate::accel::Query;
use crate::accel::bsp::traverse::ended;
use crate::accel::local::{Local, Plan, larger, lifted, smaller};
use crate::accel::simd::{Level, Task};
use crate::geometry::Hit;
use crate::math::Interval;
use crate::probe::{Choice, Event, Probe, Visit, tell};

/// A child that is still to be visited, and the part of the ray inside it.
#[derive(Clone, Copy)]
struct Pending {
    child: u32,
    min: f32,
    max: f32,
}

/// Where a ray changes sides: before `leave` it may be on the first side, from `enter` on it may be on the second one.
struct Crossing {
    enter: f32,
    leave: f32,
    /// 1 if the first side is the one in front of the plane.
    front: u32,
}

impl Planes {
    /// The closest hit.
    #[inline]
    pub fn closest<P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        self.search::<false, P>(query, probe)
    }

    /// The first hit that turns up.
    #[inline]
    pub fn any<P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        self.search::<true, P>(query, probe)
    }

    #[inline]
    fn search<const ANY: bool, P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        self.isa.unless_told::<P>().run(Search::<ANY, P> {
            planes: self,
            query,
            probe,
        })
    }

    /// The part of a ray inside the box around everything, as t'.
    #[inline(always)]
    pub fn enter(&self, local: &Local) -> Option<(f32, f32)> {
        let (mut min, mut max) = (local.min, local.max);
        for k in 0..3 {
            let (near, far) = (local.backwards[k], 1 - local.backwards[k]);
            min = larger(min, self.bounds[near][k] * local.inverse[k] - local.near[k]);
            max = smaller(max, self.bounds[far][k] * local.inverse[k] - local.far[k]);
        }
        (min <= max).then_some((min, max))
    }

    /// Where a ray crosses a node's plane.
    #[inline(always)]
    fn cross<L: Level>(&self, level: L, node: Node, local: &Local) -> Crossing {
        let kind = node.kind() as usize;
        if kind < TILTED as usize {
            let inverse = local.inverse[kind];
            return Crossing {
                enter: level.multiply_subtract(node.value, inverse, local.near[kind]),
                leave: level.multiply_subtract(node.value, inverse, local.far[kind]),
                front: local.backwards[kind] as u32,
            };
        }
        let plane = &self.tree.tilted[node.number()];
        let [x, y, z] = plane.normal;
        let dot = |v: &[f32; 3]| x * v[0] + y * v[1] + z * v[2];
        let climb = lifted(dot(&local.direction));
        let inverse = 1.0 / climb;
        let t = (plane.d - dot(&local.origin)) * inverse;
        let half = THICKER * local.pad * inverse.abs();
        Crossing {
            enter: t - half,
            leave: t + half,
            front: u32::from(climb < 0.0),
        }
    }
}

struct Search<'a, const ANY: bool, P> {
    planes: &'a Planes,
    query: &'a Query<'a>,
    probe: &'a mut P,
}

impl<const ANY: bool, P: Probe> Task for Search<'_, ANY, P> {
    type Output = Option<Hit>;

    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Option<Hit> {
        let Self {
            planes,
            query,
            probe,
        } = self;
        let mut best = None;
        if query.test_all::<ANY, P>(&planes.outside, &mut best, probe)
            || planes.tree.nodes.is_empty()
        {
            return best;
        }
        let local = match planes.frame.plan(&query.ray, query.interval) {
            Plan::Miss => None,
            Plan::Follow(local) => planes.enter(&local).map(|inside| (local, inside)),
            Plan::TestAll => {
                test_all::<ANY, P>(planes, query, &mut best, probe);
                return best;
            }
        };
        if let Some((local, inside)) = local {
            follow::<ANY, L, P>(level, planes, query, &local, inside, &mut best, probe);
        } else if P::TRAVERSAL {
            tell!(probe, ended(0, query.interval, Choice::SkippedOutside));
        }
        best
    }
}

/// Every primitive of the tree, since no useful bound is known.
#[cold]
#[inline(never)]
fn test_all<const ANY: bool, P: Probe>(
    planes: &Planes,
    query: &Query,
    best: &mut Option<Hit>,
    probe: &mut P,
) {
    for primitive in 0..query.shapes.len() as u32 {
        if planes.outside.binary_search(&primitive).is_err() {
            query.test(primitive, best, probe);
            if ANY && best.is_some() {
                return;
            }
        }
    }
}

#[inline(always)]
fn follow<const ANY: bool, L: Level, P: Probe>(
    level: L,
    planes: &Planes,
    query: &Query,
    local: &Local,
    (mut min, mut max): (f32, f32),
    best: &mut Option<Hit>,
    probe: &mut P,
) {
    let mut end = best.map_or(f32::INFINITY, |hit| local.not_before(hit.t));
    // Each level of the tree leaves at most one child behind.
    let mut stack = [Pending {
        child: 0,
        min: 0.0,
        max: 0.0,
    }; MAX_DEPTH as usize + 2];
    let mut waiting = 0;
    let mut id = 0;
    loop {
        // Down to a leaf: the first child at once, the second one later.
        let leaf = loop {
            let node = planes.tree.nodes[id as usize];
            if node.kind() == LEAF {
                break node;
            }
            let crossing = planes.cross(level, node, local);
            if P::TRAVERSAL {
                tell!(probe, tell(planes, id, query, local, &crossing, (min, max)));
            }
            let first = node.first() + crossing.front;
            let second = node.first() + 1 - crossing.front;
            if crossing.leave < min {
                (id, min) = (second, larger(min, crossing.enter));
                continue;
            }
            if crossing.enter <= max {
                stack[waiting] = Pending {
                    child: second,
                    min: larger(min, crossing.enter),
                    max,
                };
                waiting += 1;
            }
            (id, max) = (first, smaller(max, crossing.leave));
        };
        if P::TRAVERSAL {
            tell!(probe, ended(id, part(local, min, max), Choice::Leaf));
        }
        if query.test_all::<ANY, P>(planes.tree.primitives(leaf), best, probe) {
            return;
        }
        if let Some(hit) = best {
            end = local.not_before(hit.t);
        }
        loop {
            if waiting == 0 {
                return;
            }
            waiting -= 1;
            let next = stack[waiting];
            // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
            if next.min <= end {
                (id, min, max) = (next.child, next.min, smaller(next.max, end));
                break;
            }
            if P::TRAVERSAL {
                let inside = part(local, next.min, next.max);
                tell!(probe, ended(next.child, inside, Choice::SkippedCloserHit));
            }
        }
    }
}

fn part(local: &Local, min: f32, max: f32) -> Interval {
    Interval::new(local.world(min), local.world(max))
}

/// The step in words. Near is the side that the ray's origin is on.
fn tell(
    planes: &Planes,
    id: u32,
    query: &Query,
    local: &Local,
    crossing: &Crossing,
    (min, max): (f32, f32),
) -> Event {
    let children = planes.tree.nodes[id as usize].first();
    let view = planes.node(id).and_then(|node| node.plane);
    let t_split = view.map_or(f64::NAN, |(n, d)| {
        let climb = n.dot(query.ray.direction);
        if climb == 0.0 {
            f64::NAN
        } else {
            (d - n.dot(query.ray.origin)) / climb
        }
    });
    let inside = part(local, min, max);
    let (first_missed, second_missed) = (crossing.leave < min, crossing.enter > max);
    // Also if it runs along the plane, which it never crosses.
    let along = t_split.is_nan();
    let runs_away = first_missed && (along || t_split < 0.0);
    let (near, far) = (
        children + (crossing.front ^ u32::from(runs_away)),
        children + 1 - (crossing.front ^ u32::from(runs_away)),
    );
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
        near,
        far,
        choice,
    })
}
