//! A tree of planes along the axes, for speed: single precision proposes, double precision decides.
//!
//! The traversal of the tree that `kd` builds. Nodes live in the space of [`super::wide`]'s boxes and are asked with its
//! rays: a plane is taken as thick as a box is grown there, so what lies beyond it is missed by no rounding. Source: Wald
//! 2004, "Realtime ray tracing and interactive global illumination", section 7.2 (nodes of eight bytes).
//!
//! How thick, in units of u = 2^-24 and with r the largest coordinate of the ray's origin: a plane is a side of a box of
//! [`super::wide`], and bounds that are rounded to it add 1 to the 7 r + 8 there.

mod traverse;

use super::local::Frame;
use super::sift::Sifted;
use super::{AccelStats, NodeView};
use crate::math::DVec3;

/// No tree is deeper, so a traversal's stack has a fixed size.
pub const MAX_DEPTH: u32 = 62;

/// How many references there are at most, for each primitive.
pub const MAX_REFERENCES: usize = 8;

/// Shapes with larger coordinates are left outside: products of four lengths must not overflow.
pub const MAX_REACH: f64 = 1e60;

/// A tree of planes over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Planes {
    /// The space that the planes are in.
    frame: Frame,
    /// Around all that is in the tree: the smallest and the largest x, y and z.
    bounds: [[f32; 3]; 2],
    tree: Tree,
    /// What is outside the tree and tested first, in order.
    outside: Vec<u32>,
    isa: super::simd::Isa,
}

/// A tree, or a part of one that is being built.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// Depth first, the root being 0; siblings stand next to each other, the one behind the plane at first.
    pub nodes: Vec<Node>,
    /// The primitives of all leaves, those of one leaf next to each other and in order.
    pub references: Vec<u32>,
    /// Planes on the longest way down.
    pub depth: u32,
}

/// A plane with two children, or a leaf, in eight bytes.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Where the plane crosses its axis; the bits of a leaf's number of primitives.
    value: f32,
    /// The lowest two bits tell the kind: an axis or [`LEAF`]. The rest is the first child, or where a leaf's primitives
    /// begin.
    link: u32,
}

const LEAF: u32 = 3;

impl Node {
    /// A leaf.
    pub fn leaf(first: usize, count: usize) -> Self {
        Self {
            value: f32::from_bits(count as u32),
            link: (first as u32) << 2 | LEAF,
        }
    }

    /// A plane along an axis.
    pub fn along(axis: usize, d: f32, children: usize) -> Self {
        Self {
            value: d,
            link: (children as u32) << 2 | axis as u32,
        }
    }

    #[inline(always)]
    fn kind(self) -> u32 {
        self.link & 3
    }

    #[inline(always)]
    fn first(self) -> u32 {
        self.link >> 2
    }

    #[inline(always)]
    fn number(self) -> usize {
        self.value.to_bits() as usize
    }
}

impl Tree {
    /// Puts a tree into the place of a node.
    pub fn graft(&mut self, place: usize, other: Self) {
        let (nodes, references) = (self.nodes.len(), self.references.len());
        // The root goes to its place, so what comes after it moves up by one.
        let moved = |node: &Node| match node.kind() {
            LEAF => Node::leaf(references + node.first() as usize, node.number()),
            axis => Node::along(axis as usize, node.value, nodes + node.first() as usize - 1),
        };
        let Some((root, rest)) = other.nodes.split_first() else {
            return;
        };
        self.nodes[place] = moved(root);
        self.nodes.extend(rest.iter().map(moved));
        self.references.extend(other.references);
        self.depth = self.depth.max(other.depth);
    }

    /// Makes a node a leaf with these primitives.
    pub fn fill(&mut self, place: usize, primitives: impl Iterator<Item = u32>) {
        let first = self.references.len();
        self.references.extend(primitives);
        self.references[first..].sort_unstable();
        self.nodes[place] = Node::leaf(first, self.references.len() - first);
    }

    /// Room for the two children of a node; where they begin.
    pub fn pair(&mut self) -> usize {
        self.nodes.extend([Node::leaf(0, 0); 2]);
        self.nodes.len() - 2
    }

    fn primitives(&self, leaf: Node) -> &[u32] {
        &self.references[leaf.first() as usize..][..leaf.number()]
    }
}

impl Planes {
    /// A finished tree over what `sifted` says is inside; `bounds` are around it, in the frame's space.
    pub fn new(frame: Frame, bounds: [[f32; 3]; 2], mut tree: Tree, sifted: Sifted) -> Self {
        tree.nodes.shrink_to_fit();
        tree.references.shrink_to_fit();
        Self {
            frame,
            bounds,
            tree,
            outside: sifted.outside,
            isa: super::simd::Isa::best(),
        }
    }

    /// A node as a reader sees it; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let node = *self.tree.nodes.get(id as usize)?;
        if node.kind() == LEAF {
            return Some(NodeView {
                plane: None,
                axis: None,
                children: None,
                primitives: self.tree.primitives(node),
            });
        }
        let first = node.first();
        let normal = DVec3::AXES[node.kind() as usize];
        let plane = (normal, self.frame.outside(normal, f64::from(node.value)));
        Some(NodeView {
            plane: Some(plane),
            axis: Some(node.kind() as usize),
            children: Some([first + 1, first]),
            primitives: &[],
        })
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        let Tree {
            nodes,
            references,
            depth,
        } = &self.tree;
        AccelStats {
            nodes: nodes.len(),
            leaves: nodes.iter().filter(|n| n.kind() == LEAF).count(),
            polygon_planes: 0,
            depth: *depth,
            references: references.len() + self.outside.len(),
            bytes: size_of_val(&nodes[..])
                + size_of_val(&references[..])
                + size_of_val(&self.outside[..]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_stays_small() {
        assert_eq!(size_of::<Node>(), 8);
    }
}
