//! Partition of a large scene: clustering needs some two hundred bytes a box, so it is only given so many boxes at a time,
//! and as many threads as there are work side by side.
//!
//! The parts are halves of halves, as in the tree of [`crate::accel::bvh`], but where to halve is found by a
//! sample of the boxes, spread over all of them. The tree above the parts is this one, and each part becomes the tree
//! below one of its leaves. No step depends on the number of threads.

use std::ops::Range;

use glam::Vec3A;
use obvhs::aabb::Aabb as Box32;
use obvhs::bvh2::node::Bvh2Node;

use crate::accel::bounded::bounds_of;
use crate::accel::bvh::{choose, halve};
use crate::accel::fast::local_ray::UnitBox;
use crate::geometry::{Aabb, Shape};

/// Boxes of a sample, about.
const SAMPLE: usize = 1 << 11;

/// A scene's primitives in parts.
pub struct Parts {
    /// The binary tree above them: a leaf holds one part, whose number is its first index. Siblings stand next to each
    /// other, behind what they are halves of; the root is 0.
    pub nodes: Vec<Bvh2Node>,
    /// Where in the list of primitives each part is.
    pub ranges: Vec<Range<usize>>,
}

/// Sorts the primitives into parts of at most `size`; above the depth `sah_depth` by the surface area heuristic.
pub fn partition(
    unit_box: &UnitBox,
    shapes: &[Shape],
    ids: &mut [u32],
    size: usize,
    sah_depth: u32,
) -> Parts {
    let bounds = |id: &u32| bounds_of(shapes, *id);
    let around = |ids: &[u32]| {
        let all = ids.iter().map(bounds).fold(Aabb::EMPTY, Aabb::union);
        let (min, max) = unit_box.outwards(all);
        Box32::new(Vec3A::from_array(min), Vec3A::from_array(max))
    };
    let mut parts = Parts {
        nodes: vec![Bvh2Node::default()],
        ranges: Vec::new(),
    };
    // What is to do: a node, what is below it, and its depth.
    let mut work = vec![(0, 0..ids.len(), 1)];
    while let Some((node, range, depth)) = work.pop() {
        let part = &mut ids[range.clone()];
        if part.len() <= size {
            parts.nodes[node] = Bvh2Node::new(around(part), 1, parts.ranges.len() as u32);
            parts.ranges.push(range);
            continue;
        }
        let sample = part
            .iter()
            .step_by((part.len() / SAMPLE).max(1))
            .map(bounds);
        let plane = (depth < sah_depth).then(|| choose(&sample)).flatten();
        let middle = range.start + halve(part, bounds, plane);
        let first = parts.nodes.len();
        parts.nodes[node].first_index = first as u32;
        parts.nodes.extend([Bvh2Node::default(); 2]);
        work.push((first + 1, middle..range.end, depth + 1));
        work.push((first, range.start..middle, depth + 1));
    }
    // The children of a node come behind it: from the last to the first, their boxes are known.
    for node in (0..parts.nodes.len()).rev() {
        let Bvh2Node {
            prim_count,
            first_index,
            ..
        } = parts.nodes[node];
        if prim_count == 0 {
            let [a, b] = [0, 1].map(|k| *parts.nodes[first_index as usize + k].aabb());
            parts.nodes[node] = Bvh2Node::new(a.union(&b), 0, first_index);
        }
    }
    parts
}
