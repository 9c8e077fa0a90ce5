//! BVH8 traversal by a single ray, the nearest boxes first.

use super::{Bvh8, LEAF_BIT, LEAF_SIZE, Leaf, MAX_STACK, Node, WIDTH};
use crate::accel::collect::Collect;
use crate::accel::fast::local_ray::{LocalRay, Localized, larger, smaller};
use crate::accel::fast::simd::{Level, SimdKernel};
use crate::accel::fast::triangle_filter::{depth_inside, edge_error};
use crate::accel::query::Query;
use crate::math::Interval;
use crate::probe::{Choice, NONE, Probe, Visit, tell};

/// Most trees need no larger stack than this; a small one is soon cleared.
const USUAL_STACK: usize = 64;

impl Bvh8 {
    /// Descends into the boxes that the ray meets, and tests what is in their leaves.
    #[inline]
    pub fn search<C: Collect, P: Probe>(&self, query: &Query, found: &mut C, probe: &mut P) {
        self.isa.unless_recorded::<P>().run(Search {
            tree: self,
            query,
            found,
            probe,
        });
    }
}

struct Search<'a, C, P> {
    tree: &'a Bvh8,
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
        if is_over || tree.nodes.is_empty() {
            return;
        }
        match tree.unit_box.localize(&query.ray, query.interval) {
            Localized::Miss => {
                if P::TRAVERSAL {
                    tell!(
                        self.probe,
                        Visit::end(0, query.interval, Choice::SkippedOutside)
                    );
                }
            }
            Localized::Unbounded => self.test_all(),
            Localized::Ray(local) if tree.stack <= USUAL_STACK => {
                self.descend::<USUAL_STACK, L>(level, &local);
            }
            Localized::Ray(local) => self.descend::<MAX_STACK, L>(level, &local),
        }
    }
}

impl<C: Collect, P: Probe> Search<'_, C, P> {
    /// Tests every primitive of the tree.
    #[cold]
    #[inline(never)]
    fn test_all(self) {
        for leaf in &self.tree.leaves {
            if self
                .query
                .test_all(leaf.primitives(), self.found, self.probe)
            {
                return;
            }
        }
    }

    /// Follows the ray through the tree, with a stack of `STACK` children.
    #[inline(always)]
    fn descend<const STACK: usize, L: Level>(&mut self, level: L, local: &LocalRay) {
        let (tree, query) = (self.tree, self.query);
        let view = RayView::new(local, query.shear.axes);
        // Children, the nearest on top: where the ray enters (not negative, so its bits sort as it does), and which.
        let mut stack = [0u64; STACK];
        let mut count = 0;
        // Where the ray leaves each child that it met: only a log asks.
        let mut exits: Vec<(u32, f32)> = Vec::new();
        let hit = self.found.closest();
        let mut max = hit.map_or(local.max, |hit| smaller(local.max, local.not_before(hit.t)));
        let mut id = 0;
        loop {
            // The children that the ray meets, by an insertion sort.
            let node = &tree.nodes[id as usize];
            let (near, far) = cross(level, node, local, max);
            let mut met = level.le8(&near, &far);
            if P::TRAVERSAL {
                self.tell_children(id, local, (&near, &far), met);
                exits.extend(node.children.into_iter().zip(far));
            }
            let first = count;
            while met != 0 {
                let child = met.trailing_zeros() as usize;
                met &= met - 1;
                let key = u64::from(near[child].to_bits()) << 32 | u64::from(node.children[child]);
                let mut at = count;
                while at > first && stack[at - 1] < key {
                    stack[at] = stack[at - 1];
                    at -= 1;
                }
                stack[at] = key;
                count += 1;
            }
            // Leaves are tested until the nearest child is a node.
            id = loop {
                if count == 0 {
                    return;
                }
                count -= 1;
                let (enter, child) = (
                    f32::from_bits((stack[count] >> 32) as u32),
                    stack[count] as u32,
                );
                // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
                if enter > max {
                    if P::TRAVERSAL {
                        let exit = exit_of(&exits, child, local.max);
                        let part = Interval::new(local.world(enter), local.world(exit));
                        let step = Visit::end(tree.number(child), part, Choice::SkippedCloserHit);
                        tell!(self.probe, step);
                    }
                    continue;
                }
                if child & LEAF_BIT == 0 {
                    break child;
                }
                let leaf = &tree.leaves[(child & !LEAF_BIT) as usize];
                if P::TRAVERSAL {
                    let exit = exit_of(&exits, child, max);
                    let part = Interval::new(local.world(enter), local.world(exit));
                    tell!(
                        self.probe,
                        Visit::end(tree.number(child), part, Choice::Leaf)
                    );
                }
                if self.test_leaf(level, &view, leaf) {
                    return;
                }
                if let Some(hit) = self.found.closest() {
                    max = smaller(max, local.not_before(hit.t));
                }
            };
        }
    }

    /// Tests the primitives of a leaf: those that the ray may hit, or all if the probe records. True if the search is over.
    #[inline(always)]
    fn test_leaf<L: Level>(&mut self, level: L, view: &RayView, leaf: &Leaf) -> bool {
        if P::TRAVERSAL {
            return self
                .query
                .test_all(leaf.primitives(), self.found, self.probe);
        }
        let mut candidates = view.candidates(level, leaf);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            self.query
                .test(leaf.primitives[lane], self.found, self.probe);
            if self.found.is_over() {
                return true;
            }
        }
        false
    }

    /// Tells which children of a node are met, nearest first, then which are not.
    fn tell_children(
        &mut self,
        id: u32,
        local: &LocalRay,
        (near, far): (&[f32; WIDTH], &[f32; WIDTH]),
        met: u32,
    ) {
        let (tree, node) = (self.tree, &self.tree.nodes[id as usize]);
        let is_met = |i: &usize| met >> i & 1 == 1;
        let mut order: Vec<usize> = (0..WIDTH).filter(is_met).collect();
        order.sort_by(|&i, &j| near[i].total_cmp(&near[j]));
        let child = |rank: usize| {
            let slot = order.get(rank);
            slot.map_or(NONE, |&i| tree.number(node.children[i]))
        };
        let enter = near.iter().copied().fold(f32::INFINITY, f32::min);
        let leave = far.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        let part = Interval::new(local.world(enter), local.world(leave));
        tell!(self.probe, Visit::children(id, part, [child(0), child(1)]));
        for i in (0..WIDTH).filter(|i| !is_met(i) && node.children[*i] != NONE) {
            let part = Interval::new(local.world(near[i]), local.world(far[i]));
            let number = tree.number(node.children[i]);
            tell!(self.probe, Visit::end(number, part, Choice::SkippedMissed));
        }
    }
}

/// Where the ray leaves a child of a node that it was in, at most `max`.
fn exit_of(exits: &[(u32, f32)], child: u32, max: f32) -> f32 {
    let told = exits.iter().rev().find(|(other, _)| *other == child);
    told.map_or(max, |(_, exit)| smaller(*exit, max))
}

/// Where the ray enters each box and where it leaves it, cut to the interval.
#[inline(always)]
fn cross<L: Level>(
    level: L,
    node: &Node,
    local: &LocalRay,
    max: f32,
) -> ([f32; WIDTH], [f32; WIDTH]) {
    let [x, y, z] = local.negative;
    let (nx, ny, nz) = (&node.planes[x], &node.planes[2 + y], &node.planes[4 + z]);
    let (fx, fy, fz) = (
        &node.planes[1 - x],
        &node.planes[3 - y],
        &node.planes[5 - z],
    );
    let LocalRay {
        inverse: inv,
        near,
        far,
        min,
        ..
    } = *local;
    let t =
        |plane: f32, k: usize, offset: [f32; 3]| level.multiply_subtract(plane, inv[k], offset[k]);
    let (mut enter, mut leave) = ([0.0; WIDTH], [0.0; WIDTH]);
    for i in 0..WIDTH {
        let xy = larger(t(nx[i], 0, near), t(ny[i], 1, near));
        enter[i] = larger(larger(xy, t(nz[i], 2, near)), min);
        let xy = smaller(t(fx[i], 0, far), t(fy[i], 1, far));
        leave[i] = smaller(smaller(xy, t(fz[i], 2, far)), max);
    }
    (enter, leave)
}

/// A ray as the single-precision triangle test sees it, in the tree's space.
struct RayView {
    axes: [usize; 3],
    origin: [f32; 3],
    slope: [f32; 2],
    pad: f32,
}

impl RayView {
    #[inline(always)]
    fn new(local: &LocalRay, axes: [usize; 3]) -> Self {
        let [x, y, z] = axes;
        let (o, inverse) = (local.origin, local.inverse);
        Self {
            axes,
            origin: [o[x], o[y], o[z]],
            slope: [inverse[z] / inverse[x], inverse[z] / inverse[y]],
            pad: local.pad,
        }
    }

    /// The mask of what may be hit in a leaf.
    #[inline(always)]
    fn candidates<L: Level>(&self, level: L, leaf: &Leaf) -> u32 {
        let [x, y, z] = self.axes;
        let rows = [&leaf.corners[x], &leaf.corners[y], &leaf.corners[z]];
        let depth = depth_inside::<LEAF_SIZE>(
            |c, k, i| rows[k][c][i],
            |k, _| self.origin[k],
            |k, _| self.slope[k],
        );
        level.le4(&[-edge_error(leaf.size, self.pad); LEAF_SIZE], &depth) | u32::from(leaf.others)
    }
}
