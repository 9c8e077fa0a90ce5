//! A BSP tree with nodes of eight bytes, in single precision.
//!
//! `kd` and `bsp-sah` build it, and `bsp` has one for packets of rays. Planes are in the space of [`super::local_ray`] and
//! are as thick as boxes are padded there, so rounding loses nothing that lies beyond them. Source: Wald 2004, "Realtime ray tracing and interactive global illumination",
//! section 7.2 (nodes of eight bytes).
//!
//! How thick, in units of u = 2^-24 and with r the largest coordinate of the ray's origin: a plane along an axis is a
//! side of a box, and bounds that are rounded to it add 1 to the 7 r + 8 there. For n.p = d at any
//! angle, with |n| = 1: rounding n, d and o and the operations of n.o - d give 11 r + 9; those of n.direction 12, over
//! a way of at most 2 (r + 1); the division 4 (r + 1); in all less than 48 (r + 1), and the tolerance along n is at most
//! sqrt 3 times that along an axis. Four times the thickness for axes, 64 (1 + r), is more.

mod from_bsp;
mod packet;
mod traverse;

use super::local_ray::UnitBox;
use super::packet::TriangleF32;
use super::simd::Isa;
use crate::accel::inspect::{AccelStats, NodeView};
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;

/// No tree is deeper, so a traversal's stack has a fixed size.
pub const MAX_DEPTH: u32 = 62;

/// How many references there are at most, for each primitive.
pub const MAX_REFERENCES: usize = 8;

/// How much thicker planes at any angle are.
const OBLIQUE_THICKNESS: f32 = 4.0;

/// A BSP tree in single precision over a scene's primitives.
#[derive(Clone, Debug)]
pub struct CompactTree {
    /// The space that the planes are in.
    unit_box: UnitBox,
    /// Around all that is in the tree: the smallest and the largest x, y and z.
    bounds: [[f32; 3]; 2],
    tree: Tree,
    /// All shapes, for the single-precision test of triangles.
    triangles_f32: Vec<TriangleF32>,
    /// Shapes without a sharp bound, in order; they are tested first.
    unbounded: Vec<u32>,
    pub isa: Isa,
}

/// The nodes of a tree, or of a part of one that is being built.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// Depth first, the root being 0; siblings stand next to each other, the one behind the plane at first.
    pub nodes: Vec<CompactNode>,
    /// Planes that are not along an axis.
    pub oblique: Vec<ObliquePlane>,
    /// The primitives of all leaves, those of one leaf next to each other and in order.
    pub references: Vec<u32>,
    /// Planes on the longest way down.
    pub depth: u32,
}

/// A plane with two children, or a leaf, in eight bytes.
#[derive(Clone, Copy, Debug)]
pub struct CompactNode {
    /// Where a plane along an axis crosses it; else the bits of a plane's number or of a leaf's number of primitives.
    value: f32,
    /// The lowest three bits tell the kind: an axis, [`OBLIQUE`] or [`LEAF`]. The rest is the first child, or where a
    /// leaf's primitives begin.
    link: u32,
}

/// The plane n.p = d, n unit.
#[derive(Clone, Copy, Debug)]
pub struct ObliquePlane {
    /// n.
    pub normal: [f32; 3],
    /// d.
    pub d: f32,
}

const OBLIQUE: u32 = 3;
const LEAF: u32 = 4;

impl CompactNode {
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
    pub fn oblique(plane: usize, children: usize) -> Self {
        Self {
            value: f32::from_bits(plane as u32),
            link: (children as u32) << 3 | OBLIQUE,
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
    /// Replaces a node by a tree.
    pub fn graft(&mut self, node: usize, other: Self) {
        let (nodes, planes, references) =
            (self.nodes.len(), self.oblique.len(), self.references.len());
        // The root replaces the node, so the nodes after it move up by one.
        let moved = |node: &CompactNode| match node.kind() {
            LEAF => CompactNode::leaf(references + node.first() as usize, node.number()),
            OBLIQUE => {
                CompactNode::oblique(planes + node.number(), nodes + node.first() as usize - 1)
            }
            axis => {
                CompactNode::along(axis as usize, node.value, nodes + node.first() as usize - 1)
            }
        };
        let Some((root, rest)) = other.nodes.split_first() else {
            return;
        };
        self.nodes[node] = moved(root);
        self.nodes.extend(rest.iter().map(moved));
        self.oblique.extend(other.oblique);
        self.references.extend(other.references);
        self.depth = self.depth.max(other.depth);
    }

    /// Makes a node a leaf with these primitives.
    pub fn make_leaf(&mut self, node: usize, primitives: impl Iterator<Item = u32>) {
        let first = self.references.len();
        self.references.extend(primitives);
        self.references[first..].sort_unstable();
        self.nodes[node] = CompactNode::leaf(first, self.references.len() - first);
    }

    /// Adds two children that are still to be made; the index of the first.
    pub fn push_children(&mut self) -> usize {
        self.nodes.extend([CompactNode::leaf(0, 0); 2]);
        self.nodes.len() - 2
    }

    #[inline(always)]
    fn primitives(&self, leaf: CompactNode) -> &[u32] {
        &self.references[leaf.first() as usize..][..leaf.number()]
    }
}

impl CompactTree {
    /// A finished tree over all shapes but the `unbounded` ones; `bounds` are around them, in the unit box's space.
    pub fn new(
        unit_box: UnitBox,
        bounds: [[f32; 3]; 2],
        mut tree: Tree,
        unbounded: Vec<u32>,
        shapes: &[Shape],
    ) -> Self {
        tree.nodes.shrink_to_fit();
        tree.references.shrink_to_fit();
        // Packets are traced only where all planes are along the axes.
        let traced = if tree.oblique.is_empty() { shapes } else { &[] };
        Self {
            unit_box,
            bounds,
            tree,
            triangles_f32: traced
                .iter()
                .map(|s| TriangleF32::of(&unit_box, s))
                .collect(),
            unbounded,
            isa: Isa::best(),
        }
    }

    /// What can be read of a node; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let node = *self.tree.nodes.get(id as usize)?;
        if node.kind() == LEAF {
            return Some(NodeView::without_plane(self.tree.primitives(node)));
        }
        let first = node.first();
        let (normal, d) = if node.kind() == OBLIQUE {
            let plane = self.tree.oblique[node.number()];
            (DVec3::from(plane.normal.map(f64::from)), f64::from(plane.d))
        } else {
            (DVec3::AXES[node.kind() as usize], f64::from(node.value))
        };
        // Single precision leaves a normal of nearly unit length.
        let length = normal.length();
        let plane = (
            normal / length,
            self.unit_box.plane_to_world(normal, d) / length,
        );
        Some(NodeView {
            plane: Some(plane),
            axis: (node.kind() < OBLIQUE).then_some(node.kind() as usize),
            children: Some([first + 1, first]),
            primitives: &[],
        })
    }

    /// The box around all that is in the tree, in world space; `None` if the tree is empty.
    pub fn bounds(&self) -> Option<Aabb> {
        let corners = self.bounds.map(|p| self.unit_box.to_world(p));
        (!self.tree.nodes.is_empty()).then(|| Aabb::around(corners))
    }

    /// Shapes without a sharp bound, in order.
    pub fn unbounded(&self) -> &[u32] {
        &self.unbounded
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        let Tree {
            nodes,
            oblique,
            references,
            depth,
        } = &self.tree;
        AccelStats {
            nodes: nodes.len(),
            leaves: nodes.iter().filter(|n| n.kind() == LEAF).count(),
            polygon_planes: oblique.len(),
            depth: *depth,
            references: references.len() + self.unbounded.len(),
            bytes: size_of_val(&nodes[..])
                + size_of_val(&oblique[..])
                + size_of_val(&references[..])
                + size_of_val(&self.triangles_f32[..])
                + size_of_val(&self.unbounded[..]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_stays_small() {
        assert_eq!(
            (size_of::<CompactNode>(), size_of::<ObliquePlane>()),
            (8, 16)
        );
    }
}
