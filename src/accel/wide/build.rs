//! Building: a binary tree by `obvhs`, collapsed to nodes of eight.

use std::time::Duration;

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb as Box32;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::bvh2::node::Bvh2Node;

use super::{BLOCK, Block, DEEP, LEAF, Node, WIDTH, Wide};
use crate::accel::local::{Frame, round_up};
use crate::accel::sift::{Sifted, sift};
use crate::accel::simd::Isa;
use crate::geometry::Shape;
use crate::probe::NONE;

/// Shapes with larger coordinates are left outside: products of four lengths must not overflow.
const MAX_REACH: f64 = 1e60;

/// A binary tree whose leaves hold at most [`LEAF`] primitives.
struct Binary {
    /// Siblings stand next to each other; the root is 0.
    nodes: Vec<Bvh2Node>,
    /// Indices into the boxes that the tree was built over, leaf by leaf.
    order: Vec<u32>,
}

/// Builds the tree over `shapes`.
pub fn build(shapes: &[Shape]) -> Wide {
    let Sifted {
        inside,
        outside,
        bounds,
        slack,
    } = sift(shapes, MAX_REACH);
    let mut wide = Wide {
        frame: Frame::new(bounds, slack),
        nodes: Vec::new(),
        blocks: Vec::new(),
        outside,
        waiting: 0,
        depth: 0,
        isa: Isa::best(),
    };
    if inside.is_empty() {
        return wide;
    }
    let boxes: Vec<Box32> = inside
        .iter()
        .zip(0..)
        .map(|((_, b), index)| {
            let (min, max) = wide.frame.outwards(*b);
            let grow = jitter(index);
            let min = std::array::from_fn(|k| min[k] - grow[k]);
            let max = std::array::from_fn(|k| max[k] + grow[k]);
            Box32::new(Vec3A::from_array(min), Vec3A::from_array(max))
        })
        .collect();
    let ids: Vec<u32> = inside.into_iter().map(|(id, _)| id).collect();
    collapse(&mut wide, &clustered(&boxes), &ids, shapes);
    if wide.waiting > DEEP {
        collapse(&mut wide, &halved(&boxes), &ids, shapes);
    }
    wide
}

/// How much a box is grown: by at most 2^-18, which is as thick as planes are taken anyway, and at random. Boxes that
/// are all equal would all choose the same neighbour, and clustering would take time that grows with their square.
fn jitter(index: u64) -> [f32; 3] {
    let bits = (index + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 32)).wrapping_mul(0xd6e8_feb8_6659_fd93);
    [0, 21, 42].map(|shift| {
        let part = (bits ^ (bits >> 32)) >> shift & 0x1f_ffff;
        part as f32 / (1u64 << 39) as f32
    })
}

/// The good tree.
fn clustered(boxes: &[Box32]) -> Binary {
    let params = BvhBuildParams {
        max_prims_per_leaf: LEAF as u32,
        ..BvhBuildParams::medium_build()
    };
    let tree = build_bvh2(boxes, params, &mut Duration::default());
    Binary {
        nodes: tree.nodes,
        order: tree.primitive_indices,
    }
}

/// A tree that is balanced whatever the boxes are: the list halved again and again.
fn halved(boxes: &[Box32]) -> Binary {
    let around = |range: &[Box32]| range.iter().fold(Box32::INVALID, |a, b| a.union(b));
    let mut nodes = vec![Bvh2Node::new(around(boxes), boxes.len() as u32, 0)];
    let mut next = 0;
    while next < nodes.len() {
        let (first, count) = (
            nodes[next].first_index as usize,
            nodes[next].prim_count as usize,
        );
        if count > LEAF {
            let half = count / 2;
            let child = |first: usize, count: usize| {
                Bvh2Node::new(around(&boxes[first..][..count]), count as u32, first as u32)
            };
            nodes[next].prim_count = 0;
            nodes[next].first_index = nodes.len() as u32;
            nodes.push(child(first, half));
            nodes.push(child(first + half, count - half));
        }
        next += 1;
    }
    Binary {
        nodes,
        order: (0..boxes.len() as u32).collect(),
    }
}

/// Makes nodes of eight of a binary tree: the child with the largest area is opened, until there are eight.
/// Source: Wald, Benthin and Boulos 2008, section 3.1.
fn collapse(wide: &mut Wide, tree: &Binary, ids: &[u32], shapes: &[Shape]) {
    wide.nodes = Vec::with_capacity(tree.nodes.len() / 8 + 1);
    wide.blocks = Vec::with_capacity(tree.nodes.len() / 2 + 1);
    (wide.waiting, wide.depth) = (0, 0);
    // What is to do: a binary node, which child of which node it becomes, its depth, and how many children wait
    // while it is visited.
    let mut work = vec![(0usize, None, 1u32, 0usize)];
    while let Some((root, parent, depth, waiting)) = work.pop() {
        let mut open = [root; WIDTH];
        let mut count = 1;
        while count < WIDTH {
            let area = |&(_, &node): &(usize, &usize)| tree.nodes[node].aabb().half_area();
            let inner = open[..count]
                .iter()
                .enumerate()
                .filter(|(_, node)| !tree.nodes[**node].is_leaf());
            let Some((at, &largest)) = inner.max_by(|a, b| area(a).total_cmp(&area(b))) else {
                break;
            };
            let first = tree.nodes[largest].first_index as usize;
            (open[at], open[count]) = (first, first + 1);
            count += 1;
        }

        let id = wide.nodes.len() as u32;
        if let Some((node, child)) = parent {
            let node: &mut Node = &mut wide.nodes[node as usize];
            node.children[child as usize] = id;
        }
        wide.depth = wide.depth.max(depth);
        wide.waiting = wide.waiting.max(waiting + count);
        let mut node = Node::EMPTY;
        for (i, &child) in open[..count].iter().enumerate() {
            let source = &tree.nodes[child];
            let (min, max) = (source.aabb().min.to_array(), source.aabb().max.to_array());
            for axis in 0..3 {
                node.planes[2 * axis][i] = min[axis];
                node.planes[2 * axis + 1][i] = max[axis];
            }
            if source.is_leaf() {
                node.children[i] = BLOCK | wide.blocks.len() as u32;
                let leaf = &tree.order[source.first_index as usize..][..source.prim_count as usize];
                let block = block(&wide.frame, leaf, ids, shapes);
                wide.blocks.push(block);
            }
        }
        wide.nodes.push(node);
        for (i, &child) in open[..count].iter().enumerate().rev() {
            if !tree.nodes[child].is_leaf() {
                work.push((child, Some((id, i as u32)), depth + 1, waiting + count - 1));
            }
        }
    }
    wide.nodes.shrink_to_fit();
    wide.blocks.shrink_to_fit();
}

/// The primitives of a leaf, in the order of their ids.
fn block(frame: &Frame, leaf: &[u32], ids: &[u32], shapes: &[Shape]) -> Block {
    let mut block = Block {
        corners: [[[f32::NAN; LEAF]; 3]; 3],
        primitives: [NONE; LEAF],
        size: 0.0,
        count: leaf.len() as u8,
        others: 0,
    };
    for (to, &index) in block.primitives.iter_mut().zip(leaf) {
        *to = ids[index as usize];
    }
    block.primitives[..leaf.len().min(LEAF)].sort_unstable();
    for (lane, &primitive) in block.primitives.iter().enumerate().take(leaf.len()) {
        let Shape::Triangle(triangle) = &shapes[primitive as usize] else {
            block.others |= 1 << lane;
            continue;
        };
        for (corner, &place) in triangle.corners.iter().enumerate() {
            for (axis, part) in frame.point(place).into_iter().enumerate() {
                block.corners[axis][corner][lane] = part;
            }
        }
        let size = triangle.bounds().size().max_element() * frame.scale;
        block.size = block.size.max(round_up(size));
    }
    block
}
