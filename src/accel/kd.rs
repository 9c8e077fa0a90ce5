//! A kd-tree: a binary space partitioning tree whose planes are all along the axes, each the best of all that there
//! are by the surface area heuristic.
//!
//! It answers as the list does for the reasons given in [`super::bsp`], whose clipping and whose thick planes it
//! shares. Source: Wald and Havran 2006, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)".

mod build;
mod traverse;

use super::slack::Slack;
use super::{AccelStats, NodeView};
use crate::geometry::Aabb;
use crate::math::DVec3;

/// No tree is deeper, so a traversal's stack has a fixed size.
const MAX_DEPTH: u32 = 62;

/// [`Node::kind`] of a leaf without primitives.
const LEAF: u32 = 3;

/// A kd-tree over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Kd {
    /// Around all that is in the tree.
    bounds: Aabb,
    /// Depth first: the root is 0, and the child in front of a node's plane is the node after it.
    nodes: Vec<Node>,
    /// The primitives of all leaves, those of one leaf next to each other and in order.
    references: Vec<u32>,
    /// What is outside the tree and tested first.
    outside: Vec<u32>,
    slack: Slack,
    depth: u32,
}

/// A plane with two children, or a leaf.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// Where the plane crosses its axis.
    d: f64,
    /// The axis, or [`LEAF`] plus the number of a leaf's primitives.
    kind: u32,
    /// The child behind the plane, or where a leaf's primitives begin.
    link: u32,
}

impl Kd {
    /// A node as a reader sees it; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let node = self.nodes.get(id as usize)?;
        if node.kind >= LEAF {
            return Some(NodeView {
                plane: None,
                axis: None,
                children: None,
                primitives: self.primitives(node),
            });
        }
        let axis = node.kind as usize;
        Some(NodeView {
            plane: Some((DVec3::AXES[axis], node.d)),
            axis: Some(axis),
            children: Some([id + 1, node.link]),
            primitives: &[],
        })
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        AccelStats {
            nodes: self.nodes.len(),
            leaves: self.nodes.iter().filter(|n| n.kind >= LEAF).count(),
            polygon_planes: 0,
            depth: self.depth,
            references: self.references.len() + self.outside.len(),
            bytes: size_of_val(&self.nodes[..])
                + size_of_val(&self.references[..])
                + size_of_val(&self.outside[..]),
        }
    }

    /// The primitives of a leaf.
    fn primitives(&self, leaf: &Node) -> &[u32] {
        &self.references[leaf.link as usize..][..(leaf.kind - LEAF) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_stays_small() {
        assert_eq!(size_of::<Node>(), 16);
    }
}
