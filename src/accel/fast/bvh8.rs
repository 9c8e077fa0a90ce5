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
use crate::accel::bounded::bounds_of;
use crate::accel::inspect::{AccelStats, NodeView, Progress};
use crate::geometry::{Aabb, Shape};
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

    /// The box around all that is in the tree; `None` if it is empty.
    pub fn bounds(&self) -> Option<Aabb> {
        self.nodes.first().map(|root| self.box_of(root))
    }

    /// The box around what is in a node or a leaf; `None` if there is none of that number.
    pub fn node_bounds(&self, shapes: &[Shape], id: u32) -> Option<Aabb> {
        if let Some(node) = self.nodes.get(id as usize) {
            return Some(self.box_of(node));
        }
        let leaf = self.leaves.get(id as usize - self.nodes.len())?;
        let bounds = leaf.primitives().iter().map(|id| bounds_of(shapes, *id));
        Some(bounds.fold(Aabb::EMPTY, Aabb::union))
    }

    /// The children of a node, as readers count; none of a leaf.
    pub fn children(&self, id: u32) -> Vec<u32> {
        let node = self.nodes.get(id as usize);
        let children = node.map_or(&[][..], |node| &node.children);
        let some = children.iter().filter(|child| **child != NONE);
        some.map(|child| self.number(*child)).collect()
    }

    /// Shapes without a sharp bound, in order.
    pub fn unbounded(&self) -> &[u32] {
        &self.unbounded
    }

    /// The box around a node's children, in world space.
    fn box_of(&self, node: &Node) -> Aabb {
        let corners = (0..WIDTH)
            .filter(|i| node.children[*i] != NONE)
            .flat_map(|i| {
                let side = |at: usize| [0, 2, 4].map(|axis| node.planes[axis + at][i]);
                [side(0), side(1)].map(|p| self.unit_box.to_world(p))
            });
        Aabb::around(corners)
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
