//! The tree in single precision, to be followed by many rays at once.
//!
//! A plane that is rounded in the space of [`Planes`] is off by 1 u at most, for which they are thick enough.

use super::{Bsp, LEAF};
use crate::accel::local::Frame;
use crate::accel::planes::{MAX_DEPTH, MAX_REACH, Node, Planes, Tree};
use crate::geometry::Shape;

/// The same tree; `None` if not all planes are along the axes, or something is too large or too deep.
pub fn rounded(bsp: &Bsp, shapes: &[Shape]) -> Option<Planes> {
    let bounds = bsp.bounds()?;
    let reach = bounds.min.abs().max(bounds.max.abs()).max_element();
    if !bsp.normals.is_empty() || reach > MAX_REACH {
        return None;
    }
    let frame = Frame::new(bounds, bsp.slack);
    let mut tree = Tree {
        nodes: vec![Node::leaf(0, 0)],
        ..Tree::default()
    };
    // What is to do: a node, its place in the new tree, and how deep that is.
    let mut work = vec![(0u32, 0, 0)];
    while let Some((id, place, depth)) = work.pop() {
        tree.depth = tree.depth.max(depth);
        let node = &bsp.nodes[id as usize];
        let own = bsp.primitives(node);
        if node.plane == LEAF {
            tree.fill(place, own.iter().copied());
            continue;
        }
        let axis = node.plane as usize;
        let d = ((node.d - frame.center[axis]) * frame.scale) as f32;
        let children = tree.pair();
        tree.nodes[place] = Node::along(axis, d, children);
        let (mut behind, mut below) = (children, depth + 1);
        if !own.is_empty() {
            // What lies on the plane has a cell of its own, which is as thin as the plane.
            behind = tree.pair();
            below += 1;
            tree.nodes[children] = Node::along(axis, d, behind);
            tree.fill(behind + 1, own.iter().copied());
        }
        work.push((node.back, behind, below));
        work.push((id + 1, children + 1, depth + 1));
    }
    let (min, max) = frame.outwards(bounds);
    let outside = bsp.outside.clone();
    (tree.depth <= MAX_DEPTH).then(|| Planes::new(frame, [min, max], tree, outside, shapes))
}
