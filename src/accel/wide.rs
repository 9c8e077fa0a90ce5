//! A tree of boxes, eight to a node, for speed: single precision proposes, double precision decides.
//!
//! The boxes are in single precision and are tested eight at once, or against sixteen rays at once. They are only
//! asked what may be left out, and answer within a proven bound (see `accel/local.rs`). What is left is tested in double
//! precision with the operations of the shapes' own tests, so the answers are those of the list, bit for bit.
//!
//! Source: Ernst and Greiner 2008, "Multi bounding volume hierarchies"; Wald, Benthin and Boulos 2008, "Getting rid
//! of packets" (eight boxes for one ray); Wald, Slusallek, Benthin and Wagner 2001, "Interactive rendering with
//! coherent ray tracing" (many rays for one box). The binary tree that nodes are collapsed from is built by `obvhs`:
//! Meister and Bittner 2018, "Parallel locally-ordered clustering".

mod binary;
mod build;
mod packet;
mod parts;
mod single;

use super::local::Frame;
use super::simd::Isa;
use super::{AccelStats, NodeView, Query, Watch};
use crate::geometry::{Hit, Shape};
use crate::probe::{NONE, Probe};

/// Boxes in a node.
const WIDTH: usize = 8;

/// Primitives in a block.
const LEAF: usize = 4;

/// The bit of a child's number that says that it is a block.
const BLOCK: u32 = 1 << 31;

/// How many children may wait while a ray is followed; trees that need more are built again, balanced.
const DEEP: usize = 256;

/// An 8-wide tree of boxes over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Wide {
    /// The space that the boxes are in.
    frame: Frame,
    /// Depth first; the root is 0.
    nodes: Vec<Node>,
    /// What the leaves hold.
    blocks: Vec<Block>,
    /// What is outside the tree and tested first: shapes without an end, and those too large or placed too skew for
    /// a sharp bound.
    outside: Vec<u32>,
    /// How many children wait at most while a ray is followed.
    waiting: usize,
    depth: u32,
    pub(super) isa: Isa,
}

/// Eight boxes, in the frame's space and rounded outwards.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
struct Node {
    /// Rows: the smallest and largest x of all boxes, then y, then z. The box of a child that is none is empty.
    planes: [[f32; WIDTH]; 6],
    /// What is in each box: the number of a node, or that of a block with [`BLOCK`] set, or [`NONE`].
    children: [u32; WIDTH],
}

/// The primitives of a leaf, side by side.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
struct Block {
    /// The corners of four triangles in the frame's space: of each coordinate each corner, of all four. All NaN where
    /// there is no triangle.
    corners: [[[f32; LEAF]; 3]; 3],
    /// Which they are; [`NONE`] where there is none.
    primitives: [u32; LEAF],
    /// None of the triangles is larger along an axis.
    size: f32,
    count: u8,
    /// The mask of those that are other shapes than triangles.
    others: u8,
}

impl Wide {
    /// Builds the tree over `shapes`.
    pub fn build(shapes: &[Shape], watch: Watch) -> Self {
        build::build(shapes, watch)
    }

    /// The closest hit.
    pub fn closest<P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        single::search::<false, P>(self, query, probe)
    }

    /// The first hit that turns up.
    pub fn any<P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        single::search::<true, P>(self, query, probe)
    }

    /// A node as a reader sees it; the blocks are numbered after the nodes. `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let id = id as usize;
        let primitives = if id < self.nodes.len() {
            &[]
        } else {
            self.blocks.get(id - self.nodes.len())?.primitives()
        };
        Some(NodeView {
            plane: None,
            axis: None,
            children: None,
            primitives,
        })
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        let references: usize = self.blocks.iter().map(|b| b.count as usize).sum();
        AccelStats {
            nodes: self.nodes.len() + self.blocks.len(),
            leaves: self.blocks.len(),
            polygon_planes: 0,
            depth: self.depth,
            references: references + self.outside.len(),
            bytes: size_of_val(&self.nodes[..])
                + size_of_val(&self.blocks[..])
                + size_of_val(&self.outside[..]),
        }
    }

    /// A child's number as readers count.
    fn number(&self, child: u32) -> u32 {
        if child & BLOCK == 0 {
            child
        } else {
            self.nodes.len() as u32 + (child & !BLOCK)
        }
    }
}

impl Node {
    /// Eight children that are none.
    const EMPTY: Self = {
        let (above, below) = ([f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]);
        Self {
            planes: [above, below, above, below, above, below],
            children: [NONE; WIDTH],
        }
    };
}

impl Block {
    fn primitives(&self) -> &[u32] {
        &self.primitives[..(self.count as usize).min(LEAF)]
    }
}

#[cfg(test)]
mod tests;
