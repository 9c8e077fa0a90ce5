//! A tree of planes for speed: single precision proposes, double precision decides.
//!
//! The traversal of the tree that `kd` builds, and that of `bsp` for many rays at once. Nodes live in the space of
//! [`super::wide`]'s boxes and are asked with its rays: a plane is taken as thick as a box is grown there, so what lies
//! beyond it is missed by no rounding. Source: Wald 2004, "Realtime ray tracing and interactive global illumination",
//! section 7.2 (nodes of eight bytes).
//!
//! How thick, in units of u = 2^-24 and with r the largest coordinate of the ray's origin: a plane along an axis is a
//! side of a box of [`super::wide`], and bounds that are rounded to it add 1 to the 7 r + 8 there. For n.p = d at any
//! angle, with |n| = 1: rounding n, d and o and the operations of n.o - d give 11 r + 9; those of n.direction 12, over
//! a way of at most 2 (r + 1); the division 4 (r + 1); in all less than 48 (r + 1), and the slack along n is at most
//! sqrt 3 times that along an axis. Four times the thickness for axes, 64 (1 + r), is more.

mod packet;
mod traverse;

use super::local::Frame;
use super::packet::Outline;
use super::{AccelStats, NodeView};
use crate::geometry::Shape;
use crate::math::DVec3;

/// No tree is deeper, so a traversal's stack has a fixed size.
pub const MAX_DEPTH: u32 = 62;

/// How many references there are at most, for each primitive.
pub const MAX_REFERENCES: usize = 8;

/// Shapes with larger coordinates are left outside: products of four lengths must not overflow.
pub const MAX_REACH: f64 = 1e60;

/// How much thicker planes at any angle are.
const THICKER: f32 = 4.0;

/// A tree of planes over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Planes {
    /// The space that the planes are in.
    frame: Frame,
    /// Around all that is in the tree: the smallest and the largest x, y and z.
    bounds: [[f32; 3]; 2],
    tree: Tree,
    /// All shapes, for the filter of triangles.
    outlines: Vec<Outline>,
    /// What is outside the tree and tested first, in order.
    outside: Vec<u32>,
    pub(super) isa: super::simd::Isa,
}

/// A tree, or a part of one that is being built.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// Depth first, the root being 0; siblings stand next to each other, the one behind the plane at first.
    pub nodes: Vec<Node>,
    /// Planes that are not along an axis.
    pub tilted: Vec<Tilted>,
    /// The primitives of all leaves, those of one leaf next to each other and in order.
    pub references: Vec<u32>,
    /// Planes on the longest way down.
    pub depth: u32,
}

/// A plane with two children, or a leaf, in eight bytes.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Where a plane along an axis crosses it; else the bits of a plane's number or of a leaf's number of primitives.
    value: f32,
    /// The lowest three bits tell the kind: an axis, [`TILTED`] or [`LEAF`]. The rest is the first child, or where a
    /// leaf's primitives begin.
    link: u32,
}

/// The plane n.p = d, n unit.
#[derive(Clone, Copy, Debug)]
pub struct Tilted {
    /// n.
    pub normal: [f32; 3],
    /// d.
    pub d: f32,
}

const TILTED: u32 = 3;
const LEAF: u32 = 4;

impl Node {
    /// A leaf.
    pub fn leaf(first: usize, count: usize) -> Self {
        Self {
            value: f32::from_bits(count as u32),
            link: (first as u32) << 3 | LEAF,
        }
    }

    /// A plane along an axis.
    pub fn along(axis: usize, d: f32, children: usize) -> Self {
        Self {
            value: d,
            link: (children as u32) << 3 | axis as u32,
        }
    }

    /// The plane of that number.
    pub fn tilted(plane: usize, children: usize) -> Self {
        Self {
            value: f32::from_bits(plane as u32),
            link: (children as u32) << 3 | TILTED,
        }
    }

    #[inline(always)]
    fn kind(self) -> u32 {
        self.link & 7
    }

    #[inline(always)]
    fn first(self) -> u32 {
        self.link >> 3
    }

    #[inline(always)]
    fn number(self) -> usize {
        self.value.to_bits() as usize
    }
}

impl Tree {
    /// Puts a tree into the place of a node.
    pub fn graft(&mut self, place: usize, other: Self) {
        let (nodes, planes, references) =
            (self.nodes.len(), self.tilted.len(), self.references.len());
        // The root goes to its place, so what comes after it moves up by one.
        let moved = |node: &Node| match node.kind() {
            LEAF => Node::leaf(references + node.first() as usize, node.number()),
            TILTED => Node::tilted(planes + node.number(), nodes + node.first() as usize - 1),
            axis => Node::along(axis as usize, node.value, nodes + node.first() as usize - 1),
        };
        let Some((root, rest)) = other.nodes.split_first() else {
            return;
        };
        self.nodes[place] = moved(root);
        self.nodes.extend(rest.iter().map(moved));
        self.tilted.extend(other.tilted);
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

    #[inline(always)]
    fn primitives(&self, leaf: Node) -> &[u32] {
        &self.references[leaf.first() as usize..][..leaf.number()]
    }
}

impl Planes {
    /// A finished tree over all shapes but those `outside`; `bounds` are around them, in the frame's space.
    pub fn new(
        frame: Frame,
        bounds: [[f32; 3]; 2],
        mut tree: Tree,
        outside: Vec<u32>,
        shapes: &[Shape],
    ) -> Self {
        tree.nodes.shrink_to_fit();
        tree.references.shrink_to_fit();
        // Rays go together only where all planes are along the axes.
        let followed = if tree.tilted.is_empty() { shapes } else { &[] };
        Self {
            frame,
            bounds,
            tree,
            outlines: followed.iter().map(|s| Outline::of(&frame, s)).collect(),
            outside,
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
        let (normal, d) = if node.kind() == TILTED {
            let plane = self.tree.tilted[node.number()];
            (DVec3::from(plane.normal.map(f64::from)), f64::from(plane.d))
        } else {
            (DVec3::AXES[node.kind() as usize], f64::from(node.value))
        };
        // Single precision leaves a normal of nearly unit length.
        let length = normal.length();
        let plane = (normal / length, self.frame.outside(normal, d) / length);
        Some(NodeView {
            plane: Some(plane),
            axis: (node.kind() < TILTED).then_some(node.kind() as usize),
            children: Some([first + 1, first]),
            primitives: &[],
        })
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        let Tree {
            nodes,
            tilted,
            references,
            depth,
        } = &self.tree;
        AccelStats {
            nodes: nodes.len(),
            leaves: nodes.iter().filter(|n| n.kind() == LEAF).count(),
            polygon_planes: tilted.len(),
            depth: *depth,
            references: references.len() + self.outside.len(),
            bytes: size_of_val(&nodes[..])
                + size_of_val(&tilted[..])
                + size_of_val(&references[..])
                + size_of_val(&self.outlines[..])
                + size_of_val(&self.outside[..]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_stays_small() {
        assert_eq!((size_of::<Node>(), size_of::<Tilted>()), (8, 16));
    }
}
