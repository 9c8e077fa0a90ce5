//! A BSP tree in double precision, rounded for packets of rays.
//!
//! A plane that is rounded in the space of the tree is off by 1 u at most, for which planes are thick enough.

use super::{CompactNode, CompactTree, MAX_DEPTH, Tree};
use crate::accel::bsp::{Bsp, LEAF};
use crate::accel::fast::local_ray::{MAX_COORDINATE, UnitBox};
use crate::geometry::Shape;

impl CompactTree {
    /// The tree of `bsp`; `None` if not all its planes are along the axes, or something is too large or too deep.
    pub fn from_bsp(bsp: &Bsp, shapes: &[Shape]) -> Option<Self> {
        let bounds = bsp.bounds()?;
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        if !bsp.normals.is_empty() || largest > MAX_COORDINATE {
            return None;
        }
        let unit_box = UnitBox::new(bounds, bsp.tolerance);
        let mut tree = Tree {
            nodes: vec![CompactNode::leaf(0, 0)],
            ..Tree::default()
        };
        // What is to do: a node, its index in the new tree, and how deep that is.
        let mut work = vec![(0u32, 0, 0)];
        while let Some((id, index, depth)) = work.pop() {
            tree.depth = tree.depth.max(depth);
            let node = &bsp.nodes[id as usize];
            let own = bsp.primitives(node);
            if node.plane == LEAF {
                tree.make_leaf(index, own.iter().copied());
                continue;
            }
            let axis = node.plane as usize;
            let d = ((node.d - unit_box.center[axis]) * unit_box.scale) as f32;
            let children = tree.push_children();
            tree.nodes[index] = CompactNode::along(axis, d, children);
            let (mut behind, mut below) = (children, depth + 1);
            if !own.is_empty() {
                // What lies on the plane has a cell of its own, which is as thin as the plane.
                behind = tree.push_children();
                below += 1;
                tree.nodes[children] = CompactNode::along(axis, d, behind);
                tree.make_leaf(behind + 1, own.iter().copied());
            }
            work.push((node.back, behind, below));
            work.push((id + 1, children + 1, depth + 1));
        }
        let (min, max) = unit_box.outwards(bounds);
        let unbounded = bsp.unbounded.clone();
        (tree.depth <= MAX_DEPTH).then(|| Self::new(unit_box, [min, max], tree, unbounded, shapes))
    }
}
