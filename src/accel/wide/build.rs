//! Building: binary trees by `obvhs`, collapsed to nodes of eight.

use obvhs::aabb::Aabb as Box32;
use obvhs::bvh2::node::Bvh2Node;
use rayon::prelude::*;

use super::binary::{Binary, clustered, halved, outwards};
use super::parts::parts;
use super::{BLOCK, Block, DEEP, LEAF, Node, WIDTH, Wide};
use crate::accel::Watch;
use crate::accel::local::{Frame, round_up};
use crate::accel::sift::{Sifted, bounds_of, sift};
use crate::accel::simd::Isa;
use crate::geometry::Shape;
use crate::probe::NONE;

/// Shapes with larger coordinates are left outside: products of four lengths must not overflow.
const MAX_REACH: f64 = 1e60;

/// Nodes, the first of them the root, and the blocks that they name.
struct Piece {
    nodes: Vec<Node>,
    blocks: Vec<Block>,
}

/// Builds the tree over `shapes`.
pub fn build(shapes: &[Shape], watch: Watch) -> Wide {
    let Sifted {
        inside: mut ids,
        outside,
        bounds,
        slack,
    } = sift(shapes, MAX_REACH);
    let frame = Frame::new(bounds, slack);
    let mut wide = Wide {
        frame,
        nodes: Vec::new(),
        blocks: Vec::new(),
        outside,
        waiting: 0,
        depth: 0,
        isa: Isa::best(),
    };
    if ids.is_empty() {
        return wide;
    }
    let piece = |build: fn(&[Box32]) -> Binary, ids: &[u32]| {
        let boxed = |&id: &u32| outwards(&frame, bounds_of(shapes, id), id);
        let boxes: Vec<Box32> = ids.iter().map(boxed).collect();
        piece(&build(&boxes), &frame, ids, shapes)
    };
    wide.grow(&mut ids, shapes, |ids| piece(clustered, ids), watch);
    if wide.waiting > DEEP {
        (wide.nodes, wide.blocks) = (Vec::new(), Vec::new());
        wide.append(piece(halved, &ids));
        wide.measure();
    }
    wide
}

impl Wide {
    /// The tree above all parts, and below its leaves what `piece` makes of the parts' primitives.
    fn grow(
        &mut self,
        ids: &mut [u32],
        shapes: &[Shape],
        piece: impl Fn(&[u32]) -> Piece + Sync,
        watch: Watch,
    ) {
        let parts = parts(&self.frame, shapes, ids);
        let ids = &*ids;
        if let [whole] = &parts.ranges[..] {
            self.append(piece(&ids[whole.clone()]));
            self.measure();
            return;
        }
        // Room enough, most of it never touched: lists of aligned elements are copied when they grow or shrink.
        self.blocks.reserve(ids.len() / 2);
        self.nodes.reserve(ids.len() / 8);
        self.nodes
            .extend(collapse(&parts.nodes, |leaf| leaf.first_index));
        // Where each part belongs, in the order of the tree.
        let mut places = Vec::new();
        for (id, node) in self.nodes.iter().enumerate() {
            for (child, &number) in node.children.iter().enumerate() {
                if number != NONE && number & BLOCK != 0 {
                    places.push((id, child, (number & !BLOCK) as usize));
                }
            }
        }
        // Only a few at a time are there twice: by themselves and in the tree.
        let few = 2 * rayon::current_num_threads();
        for (done, places) in (0..).step_by(few).zip(places.chunks(few)) {
            watch(done as f64 / parts.ranges.len() as f64);
            let made = places
                .par_iter()
                .map(|(.., part)| piece(&ids[parts.ranges[*part].clone()]));
            let pieces: Vec<Piece> = made.collect();
            for (piece, &(node, child, _)) in pieces.into_iter().zip(places) {
                self.nodes[node].children[child] = self.append(piece);
            }
        }
        self.measure();
    }

    /// Takes in a piece; the number that its root has then.
    fn append(&mut self, piece: Piece) -> u32 {
        let (nodes, blocks) = (self.nodes.len() as u32, self.blocks.len() as u32);
        if nodes == 0 {
            (self.nodes, self.blocks) = (piece.nodes, piece.blocks);
            return 0;
        }
        self.blocks.extend(piece.blocks);
        self.nodes.extend(piece.nodes.into_iter().map(|mut node| {
            for child in node.children.iter_mut().filter(|child| **child != NONE) {
                *child += if *child & BLOCK == 0 { nodes } else { blocks };
            }
            node
        }));
        nodes
    }

    /// Finds out how deep the tree is, and how many children wait at most while a ray is followed.
    fn measure(&mut self) {
        (self.waiting, self.depth) = (0, 0);
        // A node, its depth, and how many children wait while it is visited.
        let mut work = vec![(0u32, 1u32, 0usize)];
        while let Some((id, depth, waiting)) = work.pop() {
            let children = self.nodes[id as usize].children;
            let count = children.iter().filter(|child| **child != NONE).count();
            self.depth = self.depth.max(depth);
            self.waiting = self.waiting.max(waiting + count);
            let inner = children.iter().filter(|child| **child & BLOCK == 0);
            work.extend(inner.map(|child| (*child, depth + 1, waiting + count - 1)));
        }
    }
}

/// The nodes and blocks of a binary tree over the boxes of `ids`.
fn piece(tree: &Binary, frame: &Frame, ids: &[u32], shapes: &[Shape]) -> Piece {
    let mut blocks = Vec::with_capacity(tree.nodes.len() / 2 + 1);
    let nodes = collapse(&tree.nodes, |leaf| {
        let held = &tree.order[leaf.first_index as usize..][..leaf.prim_count as usize];
        blocks.push(block(frame, held, ids, shapes));
        blocks.len() as u32 - 1
    });
    Piece { nodes, blocks }
}

/// Makes nodes of eight of a binary tree: the child with the largest area is opened, until there are eight. `leaf` tells
/// the number of the block that a leaf becomes.
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
                node.children[i] = BLOCK | leaf(source);
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
