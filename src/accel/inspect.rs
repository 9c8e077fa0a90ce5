//! What can be read of a structure: its nodes, its size, and how far its building is.

use crate::math::DVec3;

/// Callback for the progress of a build, with the fraction that is done, from 0 to 1. Called by structures that are built
/// part by part: `kd` and `wide` of large scenes.
pub type Progress<'a> = &'a (dyn Fn(f64) + Sync);

/// What can be read of a tree's node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NodeView<'a> {
    /// The splitting plane n.p = d as (n, d), n unit, in world space; `None` for a leaf.
    pub plane: Option<(DVec3, f64)>,
    /// The axis that the plane's normal is, if it is one.
    pub axis: Option<usize>,
    /// The children in front of the plane (where n points) and behind it; `None` for a leaf.
    pub children: Option<[u32; 2]>,
    /// The primitives of a leaf, or those that lie on the plane.
    pub primitives: &'a [u32],
}

/// How large an acceleration structure is; all zero for the list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AccelStats {
    /// Nodes, leaves included.
    pub nodes: usize,
    /// Nodes that are leaves.
    pub leaves: usize,
    /// Nodes that are split by a polygon's own plane, or by one through its edge.
    pub polygon_planes: usize,
    /// Planes on the longest way down.
    pub depth: u32,
    /// How often a primitive is referred to.
    pub references: usize,
    /// Memory.
    pub bytes: usize,
}

impl<'a> NodeView<'a> {
    /// A node without a plane.
    pub fn without_plane(primitives: &'a [u32]) -> Self {
        Self {
            primitives,
            ..Self::default()
        }
    }
}
