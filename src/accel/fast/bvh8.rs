//! BVH8: a bounding volume hierarchy of boxes, eight to a node, in single precision.
//!
//! Boxes are tested eight at once, or against sixteen rays at once, within the bounds of [`super::local_ray`].
//!
//! Source: Ernst and Greiner 2008, "Multi bounding volume hierarchies"; Wald, Benthin and Boulos 2008, "Getting rid
//! of packets" (eight boxes for one ray); Wald, Slusallek, Benthin and Wagner 2001, "Interactive rendering with
//! coherent ray tracing" (many rays for one box). The binary tree that nodes are collapsed from is built by `obvhs`:
//! Meister and Bittner 2018, "Parallel locally-ordered clustering".

mod binary;
mod build;
mod packet;
mod partition;
mod rounds;
mod single;

use super::local_ray::UnitBox;
use super::simd::Isa;
use crate::accel::inspect::{AccelStats, NodeView, Progress};
use crate::geometry::Shape;
use crate::probe::NONE;

/// Boxes in a node.
const WIDTH: usize = 8;

/// Primitives in a leaf.
const LEAF_SIZE: usize = 4;

/// The bit of a child's number that says that it is a leaf.
const LEAF_BIT: u32 = 1 << 31;

/// Children on the stack at most; trees that need more are built again, balanced.
const MAX_STACK: usize = 256;

/// An 8-bvh8 tree of boxes over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Bvh8 {
    /// The space that the boxes are in.
    unit_box: UnitBox,
    /// Depth first; the root is 0.
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
    /// Shapes without a sharp bound, which are tested first.
    unbounded: Vec<u32>,
    /// Children on the stack at most.
    stack: usize,
    depth: u32,
    pub isa: Isa,
}

/// Eight boxes, in the unit box's space and rounded outwards.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
struct Node {
    /// Rows: the smallest and largest x of all boxes, then y, then z. The box of no child is empty.
    planes: [[f32; WIDTH]; 6],
    /// What is in each box: the number of a node, or that of a leaf with [`LEAF_BIT`] set, or [`NONE`].
    children: [u32; WIDTH],
}

/// The primitives of a leaf, side by side.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
struct Leaf {
    /// The corners of four triangles in the unit box's space: of each coordinate each corner, of all four. All NaN where
    /// there is no triangle.
    corners: [[[f32; LEAF_SIZE]; 3]; 3],
    /// Their ids; [`NONE`] where there is none.
    primitives: [u32; LEAF_SIZE],
    /// None of the triangles is larger along an axis.
    size: f32,
    count: u8,
    /// The mask of those that are other shapes than triangles.
    others: u8,
}

impl Bvh8 {
    /// Builds the tree over `shapes`.
    pub fn build(shapes: &[Shape], progress: Progress) -> Self {
        build::build(shapes, progress)
    }

    /// What can be read of a node; leaves are numbered after the nodes. `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let id = id as usize;
        let primitives = if id < self.nodes.len() {
            &[]
        } else {
            self.leaves.get(id - self.nodes.len())?.primitives()
        };
        Some(NodeView::without_plane(primitives))
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        let references: usize = self.leaves.iter().map(|b| b.count as usize).sum();
        AccelStats {
            nodes: self.nodes.len() + self.leaves.len(),
            leaves: self.leaves.len(),
            polygon_planes: 0,
            depth: self.depth,
            references: references + self.unbounded.len(),
            bytes: size_of_val(&self.nodes[..])
                + size_of_val(&self.leaves[..])
                + size_of_val(&self.unbounded[..]),
        }
    }

    /// A child's number as readers count.
    fn number(&self, child: u32) -> u32 {
        if child & LEAF_BIT == 0 {
            child
        } else {
            self.nodes.len() as u32 + (child & !LEAF_BIT)
        }
    }
}

impl Node {
    /// A node without children.
    const EMPTY: Self = {
        let (above, below) = ([f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]);
        Self {
            planes: [above, below, above, below, above, below],
            children: [NONE; WIDTH],
        }
    };
}

impl Leaf {
    fn primitives(&self) -> &[u32] {
        &self.primitives[..(self.count as usize).min(LEAF_SIZE)]
    }
}

#[cfg(test)]
mod tests;
