//! A node of the tree of boxes over a mesh.

use crate::geometry::Aabb;

/// Levels of a tree at most.
pub(super) const MAX_LEVELS: usize = 60;

/// A box, and what is in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoxNode {
    pub bounds: Aabb,
    /// Of a leaf the place of its first triangle in the order; else its second child. The first child comes next.
    pub first: u32,
    /// Triangles of a leaf; 0 for a node with children.
    pub count: u32,
}
