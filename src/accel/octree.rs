//! Octree: a cube, halved along all three axes at once, again and again where there is much in it.
//!
//! Primitives are put into every cell that their boxes reach. Source: Glassner 1984, "Space subdivision for fast ray
//! tracing".

use super::bvh::{Bvh, BvhNode, Item};
use super::volume::Volume;
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;

/// Cells with no more primitives stay whole.
const LEAF_SIZE: usize = 6;

/// No cell is halved more often; each level leaves at most 7 children on the stack.
const MAX_DEPTH: u32 = 20;

/// How many references there are at most, for each primitive.
const MAX_REFERENCES: usize = 8;

/// A cell that is still to be parted.
struct Task {
    node: usize,
    items: Vec<Item>,
    cell: Aabb,
    depth: u32,
    /// How many references may still be added below.
    spare: usize,
}

/// Builds the tree over `shapes`.
pub fn build(shapes: &[Shape]) -> Bvh {
    let (mut tree, items) = Bvh::without_nodes(shapes);
    if items.is_empty() {
        return tree;
    }
    let bounds = items.iter().fold(Aabb::EMPTY, |b, i| b.union(i.bounds));
    let half = DVec3::splat(0.5 * bounds.size().max_element());
    let center = bounds.center();
    // The cube around all, and for rounding's sake the box itself.
    let cell = Aabb {
        min: (center - half).min(bounds.min),
        max: (center + half).max(bounds.max),
    };
    tree.nodes.push(node(cell));
    let mut work = vec![Task {
        node: 0,
        spare: (MAX_REFERENCES - 1) * items.len(),
        items,
        cell,
        depth: 1,
    }];
    while let Some(task) = work.pop() {
        tree.depth = tree.depth.max(task.depth);
        let parts = split(&task);
        let total: usize = parts.iter().map(|(_, items)| items.len()).sum();
        let added = total.saturating_sub(task.items.len());
        // Parting is no use if all children hold nearly all.
        if parts.is_empty() || added > task.spare || total > 4 * task.items.len() {
            tree.make_leaf(task.node, &task.items);
            continue;
        }
        let first = tree.nodes.len();
        let parent = &mut tree.nodes[task.node];
        (parent.first, parent.count) = (first as u32, parts.len() as u32);
        for (k, (cell, items)) in parts.into_iter().enumerate() {
            tree.nodes.push(node(cell));
            // What may still be added is shared out by need.
            let spare = (task.spare - added) as u128 * items.len() as u128 / total as u128;
            work.push(Task {
                node: first + k,
                items,
                cell,
                depth: task.depth + 1,
                spare: spare as usize,
            });
        }
    }
    tree
}

/// The eighths of a cell that hold something; none if the cell stays whole.
fn split(task: &Task) -> Vec<(Aabb, Vec<Item>)> {
    let Task {
        items, cell, depth, ..
    } = task;
    let middle = cell.center();
    let narrow = middle.cmpeq(cell.min) | middle.cmpeq(cell.max);
    if items.len() <= LEAF_SIZE || *depth >= MAX_DEPTH || narrow.any() {
        return Vec::new();
    }
    let eighth = |corner: DVec3| {
        let cell = Aabb::around([corner, middle]);
        let reaches = |b: &Aabb| (b.min.cmple(cell.max) & b.max.cmpge(cell.min)).all();
        let inside: Vec<Item> = items
            .iter()
            .filter(|i| reaches(&i.bounds))
            .copied()
            .collect();
        (cell, inside)
    };
    let eighths = cell.corners().map(eighth);
    eighths
        .into_iter()
        .filter(|(_, items)| !items.is_empty())
        .collect()
}

fn node(cell: Aabb) -> BvhNode {
    BvhNode {
        volume: Volume::Box(cell),
        first: 0,
        count: 0,
        leaf: false,
    }
}
