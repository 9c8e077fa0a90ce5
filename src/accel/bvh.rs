//! Bounding volume hierarchies: if a ray misses a volume, it misses all that is in it.
//!
//! One traversal for three trees, which differ only in how they are built and bounded: a binary tree of boxes, the same
//! tree of spheres, and an octree. Source: Rubin and Whitted 1980, "A 3-dimensional
//! representation for fast rendering of complex scenes"; Kay and Kajiya 1986 (nearest volume first).
//!
//! A hit at t lies within the tolerance of its shape (see `tolerance`), and the shape inside the volume: so volumes are grown
//! by the tolerance before they are tested, and no hit is lost.

mod build;
mod traverse;

pub use build::{MAX_SAH_DEPTH, build, choose, halve};

use super::bounded::{Primitives, bounds_of};
use super::inspect::{AccelStats, NodeView};
use super::tolerance::Tolerance;
use super::volume::Volume;
use crate::geometry::{Aabb, Shape};

/// A tree of bounding volumes over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Bvh {
    /// The root is 0; the children of a node stand next to each other.
    pub nodes: Vec<BvhNode>,
    /// The primitives of all leaves, those of one leaf next to each other and in order.
    pub references: Vec<u32>,
    /// Shapes without a sharp bound, which are tested first.
    pub unbounded: Vec<u32>,
    /// How much volumes are grown.
    pub tolerance: Tolerance,
    /// Nodes on the longest way down.
    pub depth: u32,
}

/// A volume with what is in it.
#[derive(Clone, Copy, Debug)]
pub struct BvhNode {
    pub volume: Volume,
    /// The first child, or a leaf's first reference.
    pub first: u32,
    /// How many of them.
    pub count: u32,
    pub leaf: bool,
}

/// A primitive to put into a tree.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    pub primitive: u32,
    pub bounds: Aabb,
}

impl Bvh {
    /// A tree without nodes, and the items to grow it from.
    pub fn without_nodes(shapes: &[Shape]) -> (Self, Vec<Item>) {
        let Primitives {
            bounded,
            unbounded,
            tolerance,
            ..
        } = Primitives::new(shapes, Tolerance::MAX_COORDINATE);
        let item = |primitive| Item {
            primitive,
            bounds: bounds_of(shapes, primitive),
        };
        let items: Vec<Item> = bounded.into_iter().map(item).collect();
        let tree = Self {
            nodes: Vec::new(),
            references: Vec::with_capacity(items.len()),
            unbounded,
            tolerance,
            depth: 0,
        };
        (tree, items)
    }

    /// Makes a node a leaf that holds these items.
    pub fn make_leaf(&mut self, node: usize, items: &[Item]) {
        let first = self.references.len();
        self.references.extend(items.iter().map(|i| i.primitive));
        self.references[first..].sort_unstable();
        let node = &mut self.nodes[node];
        (node.first, node.count, node.leaf) = (first as u32, items.len() as u32, true);
    }

    /// What can be read of a node; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let node = self.nodes.get(id as usize)?;
        let primitives = if node.leaf {
            self.primitives(node)
        } else {
            &[]
        };
        Some(NodeView::without_plane(primitives))
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        AccelStats {
            nodes: self.nodes.len(),
            leaves: self.nodes.iter().filter(|n| n.leaf).count(),
            polygon_planes: 0,
            depth: self.depth,
            references: self.references.len() + self.unbounded.len(),
            bytes: size_of_val(&self.nodes[..])
                + size_of_val(&self.references[..])
                + size_of_val(&self.unbounded[..]),
        }
    }

    fn primitives(&self, leaf: &BvhNode) -> &[u32] {
        &self.references[leaf.first as usize..][..leaf.count as usize]
    }
}
