//! BVH construction: the primitives are split in two, again and again, and each part is bounded.
//!
//! Where they are split is chosen by the surface area heuristic, counted in bins. Source: Goldsmith and Salmon 1987,
//! "Automatic creation of object hierarchies for ray tracing"; Wald 2007, "On fast construction of SAH-based bounding
//! volume hierarchies". Bounded by spheres instead of boxes, as by Rubin and Whitted in 1980, the same tree lets more
//! rays in: a sphere around something long and thin is mostly empty.

use super::{Bvh, BvhNode, Item};
use crate::accel::volume::Volume;
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;

/// Leaves hold no more, unless parting does not pay.
const LEAF_SIZE: usize = 4;

/// How many bins an axis is cut into.
const BINS: usize = 16;

/// Deeper, the parts are halved, so that the depth stays below 64 for any number of primitives.
pub const MAX_SAH_DEPTH: u32 = 32;

/// Builds the tree over `shapes`, bounded by boxes or by spheres.
pub fn build(shapes: &[Shape], spheres: bool) -> Bvh {
    let (mut tree, mut items) = Bvh::without_nodes(shapes);
    if items.is_empty() {
        return tree;
    }
    let node = |items: &[Item]| BvhNode {
        volume: if spheres {
            sphere_around(items, shapes)
        } else {
            Volume::Box(bounds_of(items))
        },
        first: 0,
        count: 0,
        leaf: false,
    };
    tree.nodes.push(node(&items));
    // What is to do: a node, which of the items are below it, and its depth.
    let mut work = vec![(0, 0..items.len(), 1)];
    while let Some((id, range, depth)) = work.pop() {
        tree.depth = tree.depth.max(depth);
        let part = &mut items[range.clone()];
        if part.len() <= LEAF_SIZE {
            tree.make_leaf(id, part);
            continue;
        }
        let plane = (depth < MAX_SAH_DEPTH)
            .then(|| choose(&part.iter().map(|item| item.bounds)))
            .flatten();
        let middle = range.start + halve(part, |item| item.bounds, plane);
        let first = tree.nodes.len();
        for (k, half) in [range.start..middle, middle..range.end]
            .into_iter()
            .enumerate()
        {
            tree.nodes.push(node(&items[half.clone()]));
            work.push((first + k, half, depth + 1));
        }
        (tree.nodes[id].first, tree.nodes[id].count) = (first as u32, 2);
    }
    tree
}

/// Sorts items, two or more, into those whose centers are behind a plane across an axis and the others; how many are in the
/// first part. Neither is empty.
pub fn halve<T>(
    items: &mut [T],
    bounds: impl Fn(&T) -> Aabb,
    plane: Option<(usize, f64)>,
) -> usize {
    if let Some((axis, d)) = plane {
        let (mut low, mut high) = (0, items.len());
        while low < high {
            if bounds(&items[low]).center()[axis] < d {
                low += 1;
            } else {
                high -= 1;
                items.swap(low, high);
            }
        }
        if low > 0 && low < items.len() {
            return low;
        }
    }
    items.len() / 2
}

/// The best plane between the centers of boxes, an axis and a position on it: the border between bins with the least sum of area times
/// number on both sides. `None` if all centers are equal.
pub fn choose(boxes: &(impl Iterator<Item = Aabb> + Clone)) -> Option<(usize, f64)> {
    let centers = Aabb::around(boxes.clone().map(Aabb::center));
    let (mut best, mut least) = (None, f64::INFINITY);
    for axis in 0..3 {
        let (min, width) = (centers.min[axis], centers.size()[axis] / BINS as f64);
        if !(width > 0.0 && width.is_finite()) {
            continue;
        }
        let mut bins = [(Aabb::EMPTY, 0); BINS];
        for b in boxes.clone() {
            let bin = ((b.center()[axis] - min) / width) as usize;
            let bin = &mut bins[bin.min(BINS - 1)];
            *bin = (bin.0.union(b), bin.1 + 1);
        }
        let add = |sum: &mut (Aabb, u32), bin: &(Aabb, u32)| {
            *sum = (sum.0.union(bin.0), sum.1 + bin.1);
            Some(sum.0.surface_area() * f64::from(sum.1))
        };
        let below: Vec<f64> = bins.iter().scan((Aabb::EMPTY, 0), add).collect();
        let above: Vec<f64> = bins.iter().rev().scan((Aabb::EMPTY, 0), add).collect();
        for border in 1..BINS {
            let cost = below[border - 1] + above[BINS - 1 - border];
            if cost < least {
                (best, least) = (Some((axis, min + border as f64 * width)), cost);
            }
        }
    }
    best
}

fn bounds_of(items: &[Item]) -> Aabb {
    let join = |b: Aabb, item: &Item| b.union(item.bounds);
    items.iter().fold(Aabb::EMPTY, join)
}

/// A sphere around the middle of the items' box, just large enough for all of them.
fn sphere_around(items: &[Item], shapes: &[Shape]) -> Volume {
    let center = bounds_of(items).center();
    let farthest = |points: &[DVec3]| {
        let all = points.iter().map(|p| p.distance(center));
        all.fold(0.0, f64::max)
    };
    let distance = |item: &Item| match &shapes[item.primitive as usize] {
        Shape::Triangle(triangle) => farthest(&triangle.corners),
        Shape::Sphere(sphere) => sphere.center.distance(center) + sphere.radius,
        _ => farthest(&item.bounds.corners()),
    };
    Volume::Sphere {
        center,
        radius: items.iter().map(distance).fold(0.0, f64::max),
    }
}
