//! BSP tree (binary space partitioning): planes that split space in two, again and again.
//!
//! At every node the ray's origin is on one side of the plane, the near one. What lies there comes first, then what
//! lies on the plane, then what lies on the far side; and where the ray never reaches a side, nothing there is
//! tested. Source: Fuchs, Kedem and Naylor 1980, "On visible surface generation by a priori tree structures" (planes
//! of the polygons); Kaplan 1985 and Havran 2000 (axis-aligned planes, rays).
//!
//! The tree answers as the list does, bit for bit. That stands on three things:
//! - Polygons are cut only to learn which leaves they reach. Leaves refer to whole primitives, and those are tested.
//! - A shape's hit at t lies within a few roundings of the shape, seen from the ray's point at t: every test is
//!   backward stable. So a primitive that is hit reaches a cell that the ray is in at t, or is as close to it as
//!   rounding allows.
//! - `Tolerance` bounds that closeness, and the traversal treats every plane as that thick.

mod build;
pub mod classify;
mod far_first;
mod sah;
mod traverse;

use super::inspect::{AccelStats, NodeView};
use super::kind::AccelKind;
use super::tolerance::Tolerance;
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;
use crate::probe::NONE;

/// No tree is deeper, so a traversal's stack has a fixed size.
const MAX_DEPTH: u32 = 62;

/// Up to so many shapes the polygons' planes are tried first, and given up if so many lie on one.
const FEW: usize = 256;
const CROWD: u32 = 16;

/// [`BspNode::plane`] of a leaf; 0, 1 and 2 are the axes, greater numbers count [`Bsp::normals`] from 3.
pub const LEAF: u32 = u32::MAX;

/// A tree of planes over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Bsp {
    /// Around all that is in the tree.
    bounds: Aabb,
    /// Depth first: the root is 0, and the child in front of a node's plane is the node after it.
    pub nodes: Vec<BspNode>,
    /// Unit normals of the planes that are not along an axis.
    pub normals: Vec<DVec3>,
    /// The primitives of all nodes, those of one node next to each other and in order.
    references: Vec<u32>,
    /// Shapes without a sharp bound, which are tested first.
    pub unbounded: Vec<u32>,
    pub tolerance: Tolerance,
    depth: u32,
}

/// A plane with two children, or a leaf.
#[derive(Clone, Copy, Debug)]
pub struct BspNode {
    /// The plane's distance from the world's origin along its normal.
    pub d: f64,
    /// Its normal: an axis, an index or [`LEAF`].
    pub plane: u32,
    /// The child behind it.
    pub back: u32,
    /// Where the node's references begin: a leaf's primitives, or those that lie on the plane.
    first: u32,
    /// How many they are.
    count: u32,
}

impl Bsp {
    /// Builds the tree over `shapes`. [`AccelKind::BspPolygon`] takes the planes of the triangles where they part the
    /// rest at all, [`AccelKind::BspAxis`] only planes along the axes.
    ///
    /// The scene decides like this: few shapes that are mostly triangles get the triangles' planes, unless too many
    /// of them lie on one; all others get planes along the axes. Measured with `cargo bench -p raytree-benches`: the triangles' planes
    /// are 1.2 to 1.9 times as fast on 36 to 256 triangles, about equal on 1,000 and slower from there on.
    pub fn build(kind: AccelKind, shapes: &[Shape]) -> Self {
        if kind == AccelKind::BspPolygon {
            return build::build(shapes, true);
        }
        let triangle = |shape: &&Shape| matches!(shape, Shape::Triangle(_));
        let triangles = shapes.iter().filter(triangle).count();
        if kind == AccelKind::Bsp && shapes.len() <= FEW && 2 * triangles > shapes.len() {
            let tree = build::build(shapes, true);
            if tree.nodes.iter().all(|node| node.count <= CROWD) {
                return tree;
            }
        }
        build::build(shapes, false)
    }

    /// The box around all that is in the tree; `None` if the tree is empty.
    pub fn bounds(&self) -> Option<Aabb> {
        (!self.nodes.is_empty()).then_some(self.bounds)
    }

    /// What can be read of a node; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let node = self.nodes.get(id as usize)?;
        let leaf = node.plane == LEAF;
        Some(NodeView {
            plane: (!leaf).then(|| (self.normal(node), node.d)),
            axis: (node.plane < 3).then_some(node.plane as usize),
            children: (!leaf).then_some([id + 1, node.back]),
            primitives: self.primitives(node),
        })
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        let leaves = self.nodes.iter().filter(|n| n.plane == LEAF).count();
        AccelStats {
            nodes: self.nodes.len(),
            leaves,
            polygon_planes: self.normals.len(),
            depth: self.depth,
            references: self.references.len() + self.unbounded.len(),
            bytes: size_of_val(&self.nodes[..])
                + size_of_val(&self.normals[..])
                + size_of_val(&self.references[..])
                + size_of_val(&self.unbounded[..]),
        }
    }

    fn normal(&self, node: &BspNode) -> DVec3 {
        match node.plane {
            axis @ 0..3 => DVec3::AXES[axis as usize],
            index => self.normals[(index - 3) as usize],
        }
    }

    /// The primitives of a leaf, or those on a node's plane.
    pub fn primitives(&self, node: &BspNode) -> &[u32] {
        &self.references[node.first as usize..][..node.count as usize]
    }
}

impl BspNode {
    /// A leaf, or, before its plane is known, any node.
    fn leaf(first: u32, count: u32) -> Self {
        Self {
            d: 0.0,
            plane: LEAF,
            back: NONE,
            first,
            count,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Triangle;

    #[test]
    fn a_node_stays_small() {
        assert_eq!(size_of::<BspNode>(), 24);
    }

    #[test]
    fn the_scene_decides_on_its_planes() {
        // A row of slanted walls, and as many in one plane.
        let wall = |x: f64, y: f64| {
            let corners = [[x, y, 0.0], [x + 0.5, y + 1.0, 0.0], [x, y, 1.0]];
            Shape::Triangle(Triangle {
                corners: corners.map(DVec3::from),
            })
        };
        let planes = |shapes: &[Shape]| {
            let stats = Bsp::build(AccelKind::Bsp, shapes).stats();
            stats.polygon_planes
        };
        let row: Vec<_> = (0..100).map(|i| wall(f64::from(i), 0.0)).collect();
        assert!(planes(&row) > 0);
        let flat: Vec<_> = (0..100)
            .map(|i| wall(f64::from(i), 2.0 * f64::from(i)))
            .collect();
        assert_eq!(planes(&flat), 0);
        let many: Vec<_> = (0..300).map(|i| wall(f64::from(i), 0.0)).collect();
        assert_eq!(planes(&many), 0);
    }
}
