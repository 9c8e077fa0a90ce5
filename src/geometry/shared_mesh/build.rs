//! Building of the tree of boxes: top down, each box cut where the surface area heuristic expects the least work.
//! Source: Wald 2007, "On fast construction of SAH-based bounding volume hierarchies": planes between bins of middles.

use super::box_node::{BoxNode, MAX_LEVELS};
use crate::geometry::{Aabb, Triangle};
use crate::math::DVec3;

/// Bins along each axis.
const BINS: usize = 16;

/// Triangles of a leaf at most.
const LEAF: usize = 4;

/// From this level on boxes are halved by number, so that a tree of 2^28 triangles has [`MAX_LEVELS`] levels at most.
const BY_NUMBER: usize = MAX_LEVELS - 28;

/// A triangle with its box.
struct Boxed {
    part: u32,
    bounds: Aabb,
    middle: DVec3,
}

/// The nodes, the root first and each before its children, and the triangles leaf by leaf.
pub(super) fn build(triangles: &[Triangle]) -> (Vec<BoxNode>, Vec<u32>) {
    let boxed = |(triangle, part): (&Triangle, u32)| {
        let bounds = Aabb::around(triangle.corners);
        let middle = bounds.center();
        Boxed {
            part,
            bounds,
            middle,
        }
    };
    let mut all: Vec<Boxed> = triangles.iter().zip(0..).map(boxed).collect();
    let mut nodes = Vec::new();
    if !all.is_empty() {
        add(&mut nodes, &mut all, 0, 0);
    }
    nodes.shrink_to_fit();
    (nodes, all.iter().map(|boxed| boxed.part).collect())
}

/// Adds the node of these triangles, which start at `first` in the order, and all below it.
fn add(nodes: &mut Vec<BoxNode>, all: &mut [Boxed], first: usize, level: usize) {
    let bounds = all.iter().fold(Aabb::EMPTY, |b, t| b.union(t.bounds));
    let id = nodes.len();
    nodes.push(BoxNode {
        bounds,
        first: first as u32,
        count: all.len() as u32,
    });
    if all.len() <= LEAF {
        return;
    }
    let middle = match split(all, level) {
        Some((axis, at)) => {
            let is_below = |t: &Boxed| t.middle[axis] < at;
            all.sort_by_key(|t| !is_below(t));
            all.partition_point(is_below)
        }
        None => all.len() / 2,
    };
    let (below, above) = all.split_at_mut(middle);
    add(nodes, below, first, level + 1);
    nodes[id].first = nodes.len() as u32;
    nodes[id].count = 0;
    add(nodes, above, first + middle, level + 1);
}

/// The best plane: its axis and place. `None` to halve by number: deep down, or where all middles are one.
fn split(all: &[Boxed], level: usize) -> Option<(usize, f64)> {
    if level >= BY_NUMBER {
        return None;
    }
    let middles = Aabb::around(all.iter().map(|t| t.middle));
    let mut best: Option<(f64, usize, f64)> = None;
    for axis in 0..3 {
        let (low, width) = (middles.min[axis], middles.size()[axis] / BINS as f64);
        if !(width > 0.0 && width.is_finite()) {
            continue;
        }
        let mut bins = [(Aabb::EMPTY, 0_usize); BINS];
        for t in all {
            let bin = (((t.middle[axis] - low) / width) as usize).min(BINS - 1);
            bins[bin] = (bins[bin].0.union(t.bounds), bins[bin].1 + 1);
        }
        let join = |a: (Aabb, usize), b: (Aabb, usize)| (a.0.union(b.0), a.1 + b.1);
        let cost = |side: (Aabb, usize)| side.0.surface_area() * side.1 as f64;
        for border in 1..BINS {
            let [below, above] = [&bins[..border], &bins[border..]]
                .map(|side| side.iter().copied().fold((Aabb::EMPTY, 0), join));
            let at = low + border as f64 * width;
            let cost = cost(below) + cost(above);
            // Both sides must hold something as the middles are compared, not only as they were put into bins.
            let splits = middles.min[axis] < at && at <= middles.max[axis];
            if splits && best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, axis, at));
            }
        }
    }
    best.map(|(_, axis, at)| (axis, at))
}
