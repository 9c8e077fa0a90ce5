//! BVH8 construction: binary trees by `obvhs`, collapsed to nodes of eight.

use obvhs::aabb::Aabb as Box32;
use obvhs::bvh2::node::Bvh2Node;
use rayon::prelude::*;

use super::binary::{Binary, clustered, halved, outwards};
use super::partition::partition;
use super::rounds::takes_many_rounds;
use super::{Bvh8, LEAF_BIT, LEAF_SIZE, Leaf, MAX_STACK, Node, WIDTH};
use crate::accel::bounded::{Primitives, bounds_of};
use crate::accel::bvh::MAX_SAH_DEPTH;
use crate::accel::fast::local_ray::{MAX_COORDINATE, UnitBox, round_up};
use crate::accel::fast::simd::Isa;
use crate::accel::inspect::Progress;
use crate::geometry::Shape;
use crate::probe::NONE;

/// Primitives that are clustered together at most.
const PART: usize = 1 << 13;

/// Part of a tree: nodes, the first of them the root, and the leaves that they name.
struct Subtree {
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
}

/// Builds the tree over `shapes`.
pub fn build(shapes: &[Shape], progress: Progress) -> Bvh8 {
    let Primitives {
        bounded: mut ids,
        unbounded,
        bounds,
        tolerance,
    } = Primitives::new(shapes, MAX_COORDINATE);
    let unit_box = UnitBox::new(bounds, tolerance);
    let mut bvh8 = Bvh8 {
        unit_box,
        nodes: Vec::new(),
        leaves: Vec::new(),
        unbounded,
        stack: 0,
        depth: 0,
        isa: Isa::best(),
    };
    if ids.is_empty() {
        return bvh8;
    }
    let halved = |ids: &[u32], sah_depth| {
        let mut ids = ids.to_vec();
        let tree = halved(&unit_box, shapes, &mut ids, sah_depth);
        subtree(&tree, &unit_box, &ids, shapes)
    };
    let best = |ids: &[u32]| {
        let boxed = |&id: &u32| outwards(&unit_box, bounds_of(shapes, id), id);
        let boxes: Vec<Box32> = ids.iter().map(boxed).collect();
        if takes_many_rounds(&boxes) {
            return halved(ids, MAX_SAH_DEPTH);
        }
        subtree(&clustered(&boxes), &unit_box, ids, shapes)
    };
    bvh8.grow(&mut ids, shapes, best, progress);
    if bvh8.stack > MAX_STACK {
        (bvh8.nodes, bvh8.leaves) = (Vec::new(), Vec::new());
        bvh8.append(halved(&ids, 0));
        bvh8.measure();
    }
    bvh8
}

impl Bvh8 {
    /// The tree above all parts, and below its leaves what `subtree` makes of the parts' primitives.
    fn grow(
        &mut self,
        ids: &mut [u32],
        shapes: &[Shape],
        subtree: impl Fn(&[u32]) -> Subtree + Sync,
        progress: Progress,
    ) {
        let parts = partition(&self.unit_box, shapes, ids, PART, MAX_SAH_DEPTH);
        let ids = &*ids;
        if let [whole] = &parts.ranges[..] {
            self.append(subtree(&ids[whole.clone()]));
            self.measure();
            return;
        }
        // Reserved once, most of it never touched: lists of aligned elements are copied when they grow or shrink.
        self.leaves.reserve(ids.len() / 2);
        self.nodes.reserve(ids.len() / 8);
        self.nodes
            .extend(collapse(&parts.nodes, |leaf| leaf.first_index));
        // The child that each part becomes, in the order of the tree.
        let mut slots = Vec::new();
        for (id, node) in self.nodes.iter().enumerate() {
            for (child, &number) in node.children.iter().enumerate() {
                if number != NONE && number & LEAF_BIT != 0 {
                    slots.push((id, child, (number & !LEAF_BIT) as usize));
                }
            }
        }
        // Only a few at a time are there twice: by themselves and in the tree.
        let few = 2 * rayon::current_num_threads();
        for (done, slots) in (0..).step_by(few).zip(slots.chunks(few)) {
            progress(done as f64 / parts.ranges.len() as f64);
            let made = slots
                .par_iter()
                .map(|(.., part)| subtree(&ids[parts.ranges[*part].clone()]));
            let subtrees: Vec<Subtree> = made.collect();
            for (subtree, &(node, child, _)) in subtrees.into_iter().zip(slots) {
                self.nodes[node].children[child] = self.append(subtree);
            }
        }
        self.measure();
    }

    /// Takes in a subtree; the number that its root has then.
    fn append(&mut self, subtree: Subtree) -> u32 {
        let (nodes, leaves) = (self.nodes.len() as u32, self.leaves.len() as u32);
        if nodes == 0 {
            (self.nodes, self.leaves) = (subtree.nodes, subtree.leaves);
            return 0;
        }
        self.leaves.extend(subtree.leaves);
        self.nodes.extend(subtree.nodes.into_iter().map(|mut node| {
            for child in node.children.iter_mut().filter(|child| **child != NONE) {
                *child += if *child & LEAF_BIT == 0 {
                    nodes
                } else {
                    leaves
                };
            }
            node
        }));
        nodes
    }

    /// Finds out how deep the tree is, and how large a stack it needs.
    fn measure(&mut self) {
        (self.stack, self.depth) = (0, 0);
        // A node, its depth, and how many children are on the stack while it is visited.
        let mut work = vec![(0u32, 1u32, 0usize)];
        while let Some((id, depth, stack)) = work.pop() {
            let children = self.nodes[id as usize].children;
            let count = children.iter().filter(|child| **child != NONE).count();
            self.depth = self.depth.max(depth);
            self.stack = self.stack.max(stack + count);
            let inner = children.iter().filter(|child| **child & LEAF_BIT == 0);
            work.extend(inner.map(|child| (*child, depth + 1, stack + count - 1)));
        }
    }
}

/// The nodes and leaves of a binary tree over the boxes of `ids`.
fn subtree(tree: &Binary, unit_box: &UnitBox, ids: &[u32], shapes: &[Shape]) -> Subtree {
    let mut leaves = Vec::with_capacity(tree.nodes.len() / 2 + 1);
    let nodes = collapse(&tree.nodes, |leaf| {
        let held = &tree.order[leaf.first_index as usize..][..leaf.prim_count as usize];
        leaves.push(make_leaf(unit_box, held, ids, shapes));
        leaves.len() as u32 - 1
    });
    Subtree { nodes, leaves }
}

/// Makes nodes of eight of a binary tree: the child with the largest area is opened, until there are eight. `leaf` tells
/// the number of the leaf that a leaf becomes.
/// Source: Wald, Benthin and Boulos 2008, section 3.1.
fn collapse(tree: &[Bvh2Node], mut leaf: impl FnMut(&Bvh2Node) -> u32) -> Vec<Node> {
    let mut nodes: Vec<Node> = Vec::with_capacity(tree.len() / 8 + 1);
    // What is to do: a binary node, and which child of which node it becomes.
    let mut work = vec![(0usize, None)];
    while let Some((root, parent)) = work.pop() {
        let mut open = [root; WIDTH];
        let mut count = 1;
        while count < WIDTH {
            let area = |&(_, &node): &(usize, &usize)| tree[node].aabb().half_area();
            let inner = open[..count]
                .iter()
                .enumerate()
                .filter(|(_, node)| !tree[**node].is_leaf());
            let Some((at, &largest)) = inner.max_by(|a, b| area(a).total_cmp(&area(b))) else {
                break;
            };
            let first = tree[largest].first_index as usize;
            (open[at], open[count]) = (first, first + 1);
            count += 1;
        }

        let id = nodes.len();
        if let Some((node, child)) = parent {
            let node: &mut Node = &mut nodes[node];
            node.children[child] = id as u32;
        }
        let mut node = Node::EMPTY;
        for (i, &child) in open[..count].iter().enumerate() {
            let source = &tree[child];
            let (min, max) = (source.aabb().min.to_array(), source.aabb().max.to_array());
            for axis in 0..3 {
                node.planes[2 * axis][i] = min[axis];
                node.planes[2 * axis + 1][i] = max[axis];
            }
            if source.is_leaf() {
                node.children[i] = LEAF_BIT | leaf(source);
            }
        }
        nodes.push(node);
        for (i, &child) in open[..count].iter().enumerate().rev() {
            if !tree[child].is_leaf() {
                work.push((child, Some((id, i))));
            }
        }
    }
    nodes
}

/// The primitives of a leaf, in the order of their ids.
fn make_leaf(unit_box: &UnitBox, items: &[u32], ids: &[u32], shapes: &[Shape]) -> Leaf {
    let mut leaf = Leaf {
        corners: [[[f32::NAN; LEAF_SIZE]; 3]; 3],
        primitives: [NONE; LEAF_SIZE],
        size: 0.0,
        count: items.len() as u8,
        others: 0,
    };
    for (to, &index) in leaf.primitives.iter_mut().zip(items) {
        *to = ids[index as usize];
    }
    leaf.primitives[..items.len().min(LEAF_SIZE)].sort_unstable();
    for (lane, &primitive) in leaf.primitives.iter().enumerate().take(items.len()) {
        let Shape::Triangle(triangle) = &shapes[primitive as usize] else {
            leaf.others |= 1 << lane;
            continue;
        };
        for (corner, &point) in triangle.corners.iter().enumerate() {
            for (axis, part) in unit_box.point(point).into_iter().enumerate() {
                leaf.corners[axis][corner][lane] = part;
            }
        }
        let size = triangle.bounds().size().max_element() * unit_box.scale;
        leaf.size = leaf.size.max(round_up(size));
    }
    leaf
}
