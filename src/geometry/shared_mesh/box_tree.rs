//! Tree of boxes over the triangles of a mesh, in double precision, and the walk of a ray through it.

use super::MeshSteps;
use super::box_node::{BoxNode, MAX_LEVELS};
use super::build::build;
use crate::geometry::{Aabb, Triangle};
use crate::math::rounding::UNIT_ROUNDOFF;
use crate::math::{DVec3, Interval, Ray};

/// Thickness of boxes in units of u (m + |o|), m being the largest coordinate of the mesh and o the ray's origin. The test of a
/// triangle is right for one that is moved by 40 of them; cutting the ray by a box rounds by 4 on each axis. The sum is doubled more
/// than once, since thick boxes cost nothing.
const THICKNESS: f64 = 256.0 * UNIT_ROUNDOFF;

/// A tree of boxes.
#[derive(Clone, Debug)]
pub(super) struct BoxTree {
    /// The root first, each node before its children.
    nodes: Vec<BoxNode>,
    /// The triangles, leaf by leaf.
    order: Vec<u32>,
    /// The largest coordinate.
    reach: f64,
}

impl BoxTree {
    /// The tree over triangles.
    pub fn new(triangles: &[Triangle]) -> Self {
        let (nodes, order) = build(triangles);
        let bounds = nodes.first().map_or(Aabb::EMPTY, |root| root.bounds);
        let reach = if nodes.is_empty() {
            0.0
        } else {
            bounds.min.abs().max(bounds.max.abs()).max_element()
        };
        Self {
            nodes,
            order,
            reach,
        }
    }

    pub fn bounds(&self) -> Aabb {
        self.nodes.first().map_or(Aabb::EMPTY, |root| root.bounds)
    }

    pub fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..]) + size_of_val(&self.order[..])
    }

    /// Hands out the triangles near the ray, those in near boxes first. `test` gives the t up to which the ray still counts.
    #[inline(always)]
    pub fn visit(
        &self,
        ray: &Ray,
        interval: Interval,
        steps: &mut MeshSteps,
        mut test: impl FnMut(u32) -> f64,
    ) {
        let slabs = Slabs {
            origin: ray.origin,
            inverse: ray.direction.recip(),
            thickness: THICKNESS * (self.reach + ray.origin.abs().max_element()),
            start: interval.min,
        };
        let mut until = interval.max;
        let mut open = [(0, 0.0); MAX_LEVELS + 1];
        let mut depth = 0;
        let root = self.nodes.first().map(|root| slabs.enter(&root.bounds));
        let mut next = root.filter(|t| *t <= until).map(|_| 0);
        steps.boxes += 1;
        loop {
            let Some(id) = next else {
                if depth == 0 {
                    return;
                }
                depth -= 1;
                let (id, enter): (u32, f64) = open[depth];
                next = (enter <= until).then_some(id);
                continue;
            };
            let node = &self.nodes[id as usize];
            if node.count > 0 {
                let first = node.first as usize;
                for part in &self.order[first..first + node.count as usize] {
                    steps.triangles += 1;
                    until = test(*part);
                }
                next = None;
                continue;
            }
            let (mut near, mut far) = (id + 1, node.first);
            let enter = |id: u32| slabs.enter(&self.nodes[id as usize].bounds);
            let (mut t, mut t_far) = (enter(near), enter(far));
            steps.boxes += 2;
            // Where one is missed there is no order.
            if t_far < t {
                (near, far) = (far, near);
                (t, t_far) = (t_far, t);
            }
            if t_far <= until {
                open[depth] = (far, t_far);
                depth += 1;
            }
            next = (t <= until).then_some(near);
        }
    }
}

/// A ray for boxes.
struct Slabs {
    origin: DVec3,
    inverse: DVec3,
    thickness: f64,
    start: f64,
}

impl Slabs {
    /// Where the ray comes into the thick box; NaN if it misses it. A number that is none (0 times infinity: the ray runs in a
    /// side) decides nothing, since `max` and `min` pass over it.
    #[inline(always)]
    fn enter(&self, bounds: &Aabb) -> f64 {
        let (mut enter, mut exit) = (self.start, f64::INFINITY);
        for axis in 0..3 {
            let (o, inverse) = (self.origin[axis], self.inverse[axis]);
            let low = (bounds.min[axis] - self.thickness - o) * inverse;
            let high = (bounds.max[axis] + self.thickness - o) * inverse;
            let (near, far) = if inverse >= 0.0 {
                (low, high)
            } else {
                (high, low)
            };
            enter = enter.max(near);
            exit = exit.min(far);
        }
        if enter <= exit { enter } else { f64::NAN }
    }
}
