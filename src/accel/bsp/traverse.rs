//! BSP traversal, front to back.

use super::{Bsp, BspNode, LEAF, MAX_DEPTH};
use crate::accel::collect::Collect;
use crate::accel::query::Query;
use crate::accel::volume::Volume;
use crate::math::{DVec3, Interval, Ray};
use crate::probe::{Choice, Event, NONE, Probe, Visit, tell};

/// A part of the tree that is still to be visited: what lies on a node's plane, then the node's far child.
#[derive(Clone, Copy)]
struct Pending {
    /// The node whose plane that is, or [`NONE`].
    on: u32,
    child: u32,
    /// The part of the ray inside the child.
    inside: Interval,
}

/// A ray with what every node asks for.
pub struct Walker {
    pub origin: [f64; 3],
    pub direction: [f64; 3],
    /// 1 / direction.
    pub inverse: [f64; 3],
    /// How thick every plane is, on each side.
    tolerance: f64,
}

/// What a ray does at a node's plane.
pub struct PlaneCrossing {
    pub near: u32,
    pub far: u32,
    /// Whether the ray never gets there, and the part of it that does.
    pub near_missed: bool,
    pub near_part: Interval,
    pub far_missed: bool,
    pub far_part: Interval,
    /// The origin's distance from the plane and how fast the ray reduces it: it crosses at height / speed.
    height: f64,
    speed: f64,
}

impl Bsp {
    /// Follows a ray front to back, and tests what lies in the cells that it goes through.
    // Never inlined: so that a build with and one without probe calls differ in nothing else.
    #[inline(never)]
    pub fn search<C: Collect, P: Probe>(&self, query: &Query, found: &mut C, probe: &mut P) {
        let root = self.bounds().map(Volume::Box);
        let entry = query.enter(&self.unbounded, root, &self.tolerance, found, probe);
        let Some((tolerance, inside)) = entry else {
            return;
        };
        let walker = Walker::new(&query.ray, tolerance);

        // Each level of the tree leaves at most one far child behind.
        let root = Pending {
            on: NONE,
            child: 0,
            inside,
        };
        let mut stack = [root; MAX_DEPTH as usize + 2];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let next = stack[count];
            // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
            if found.closest().is_some_and(|hit| hit.t < next.inside.min) {
                if P::TRAVERSAL {
                    tell!(
                        probe,
                        Visit::end(next.child, next.inside, Choice::SkippedCloserHit)
                    );
                }
                continue;
            }
            if next.on != NONE {
                let on = self.primitives(&self.nodes[next.on as usize]);
                if query.test_all(on, found, probe) {
                    return;
                }
            }
            // Down to a leaf: the near child at once, the far one later.
            let (mut id, mut inside) = (next.child, next.inside);
            let leaf = loop {
                let node = &self.nodes[id as usize];
                if node.plane == LEAF {
                    break node;
                }
                let crossing = self.cross(&walker, id, node, inside);
                if P::TRAVERSAL {
                    tell!(probe, Event::Visit(crossing.visit(id, inside)));
                }
                if !crossing.near_missed && !crossing.far_missed {
                    stack[count] = Pending {
                        on: if node.count > 0 { id } else { NONE },
                        child: crossing.far,
                        inside: crossing.far_part,
                    };
                    count += 1;
                }
                (id, inside) = if crossing.near_missed {
                    (crossing.far, crossing.far_part)
                } else {
                    (crossing.near, crossing.near_part)
                };
            };
            if P::TRAVERSAL {
                tell!(probe, Visit::end(id, inside, Choice::Leaf));
            }
            if query.test_all(self.primitives(leaf), found, probe) {
                return;
            }
        }
    }

    /// Which children the ray reaches inside a node, and where. Each child's side of the plane is grown by the tolerance.
    /// NaN, from 0 times infinity, keeps a child in.
    #[inline]
    pub fn cross(
        &self,
        walker: &Walker,
        id: u32,
        node: &BspNode,
        inside: Interval,
    ) -> PlaneCrossing {
        let (s, climb, inverse) = if node.plane < 3 {
            let axis = node.plane as usize;
            let s = walker.origin[axis] - node.d;
            (s, walker.direction[axis], walker.inverse[axis])
        } else {
            let n = self.normals[node.plane as usize - 3];
            let climb = n.dot(DVec3::from(walker.direction));
            let s = n.dot(DVec3::from(walker.origin)) - node.d;
            (s, climb, 1.0 / climb)
        };
        walker.cross([id + 1, node.back], s, climb, inverse, inside)
    }
}

impl Walker {
    /// A ray as the nodes ask for it.
    pub fn new(ray: &Ray, tolerance: f64) -> Self {
        Self {
            origin: ray.origin.to_array(),
            direction: ray.direction.to_array(),
            inverse: ray.direction.recip().to_array(),
            tolerance,
        }
    }

    /// Which of the children in front of a plane and behind it the ray reaches, and where, from its origin's distance
    /// `s`, how fast that grows and the inverse of this.
    #[inline]
    pub fn cross(
        &self,
        [front, back]: [u32; 2],
        s: f64,
        climb: f64,
        inverse: f64,
        inside: Interval,
    ) -> PlaneCrossing {
        // Near is the side that the origin is on.
        let (near, far, height, speed, inverse) = if s >= 0.0 {
            (front, back, s, -climb, -inverse)
        } else {
            (back, front, -s, climb, inverse)
        };
        let Interval { min, max } = inside;
        let t_above = (height - self.tolerance) * inverse;
        let t_below = (height + self.tolerance) * inverse;
        let (near_missed, near_part, far_missed, far_part);
        if speed > 0.0 {
            // Towards the plane: near until it is left below, far once it is no longer above.
            near_missed = t_below < min;
            near_part = Interval::new(min, max.min(t_below));
            far_missed = t_above > max;
            far_part = Interval::new(min.max(t_above), max);
        } else {
            // Away from it or along it: far only as long as it is not yet above.
            near_missed = false;
            near_part = inside;
            far_missed = if speed < 0.0 {
                t_above < min
            } else {
                height > self.tolerance
            };
            far_part = Interval::new(min, if speed < 0.0 { max.min(t_above) } else { max });
        }
        PlaneCrossing {
            near,
            far,
            near_missed,
            near_part,
            far_missed,
            far_part,
            height,
            speed,
        }
    }
}

impl PlaneCrossing {
    /// The step in words, at a node that the ray is inside of for this interval.
    pub fn visit(&self, node: u32, inside: Interval) -> Visit {
        let t_split = self.height / self.speed;
        let clear = self.speed > 0.0 && inside.contains(t_split);
        let choice = match (self.near_missed, self.far_missed) {
            (false, false) if clear => Choice::Both,
            (false, false) => Choice::BothInDoubt,
            (false, true) if self.speed > 0.0 => Choice::NearSplitBeyond,
            (false, true) => Choice::NearRunsAway,
            (true, _) => Choice::FarSplitBefore,
        };
        Visit {
            node,
            interval: [inside.min, inside.max],
            t_split: if self.speed == 0.0 { f64::NAN } else { t_split },
            near: self.near,
            far: self.far,
            choice,
        }
    }
}
