//! What part of space a structure and its nodes take up, and which nodes hang on which: for drawings, not for traversal.

use super::Accel;
use super::volume::Volume;
use crate::geometry::{Aabb, Shape};

impl Accel {
    /// The box around all that is in the structure; `None` for a list, and if nothing is.
    pub fn bounds(&self) -> Option<Aabb> {
        match self {
            Self::List(_) => None,
            Self::Bsp(bsp, _) => bsp.bounds(),
            Self::Compact(tree) => tree.bounds(),
            Self::Grid(grid) => grid.bounds(),
            Self::Bvh(bvh) => bvh.nodes.first().map(|root| root.volume.bounds()),
            Self::Bvh8(bvh8) => bvh8.bounds(),
        }
    }

    /// What bounds a node by itself; `None` in a tree of planes, where the planes above the node do.
    pub fn volume(&self, shapes: &[Shape], id: u32) -> Option<Volume> {
        match self {
            Self::List(_) | Self::Bsp(..) | Self::Compact(_) => None,
            Self::Grid(grid) => grid.cell(id).map(Volume::Box),
            Self::Bvh(bvh) => bvh.nodes.get(id as usize).map(|node| node.volume),
            Self::Bvh8(bvh8) => bvh8.node_bounds(shapes, id).map(Volume::Box),
        }
    }

    /// The children of a node; none of a leaf.
    pub fn children(&self, id: u32) -> Vec<u32> {
        match self {
            Self::List(_) | Self::Grid(_) => Vec::new(),
            Self::Bsp(..) | Self::Compact(_) => self
                .node(id)
                .and_then(|node| node.children)
                .map_or_else(Vec::new, |children| children.to_vec()),
            Self::Bvh(bvh) => match bvh.nodes.get(id as usize) {
                Some(node) if !node.leaf => (node.first..node.first + node.count).collect(),
                _ => Vec::new(),
            },
            Self::Bvh8(bvh8) => bvh8.children(id),
        }
    }

    /// The shapes without a sharp bound, in order, which every ray is tested against before it enters the structure.
    pub fn unbounded(&self) -> &[u32] {
        match self {
            Self::List(_) => &[],
            Self::Bsp(bsp, _) => &bsp.unbounded,
            Self::Compact(tree) => tree.unbounded(),
            Self::Grid(grid) => grid.unbounded(),
            Self::Bvh(bvh) => &bvh.unbounded,
            Self::Bvh8(bvh8) => bvh8.unbounded(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::AccelKind;
    use crate::scene::load;

    /// Each node but the root is the child of exactly one node, and the shapes of a leaf reach its volume.
    #[test]
    fn children_make_a_tree_and_volumes_hold_their_shapes() {
        for scene in ["teapot", "whitted"] {
            let shapes = load(scene).expect(scene).shapes;
            for kind in AccelKind::ALL {
                let accel = Accel::build(kind, &shapes);
                let nodes = accel.stats().nodes as u32;
                let mut parents = vec![0; nodes as usize];
                for id in 0..nodes {
                    for child in accel.children(id) {
                        parents[child as usize] += 1;
                    }
                    let inside = accel.node(id).map_or(&[][..], |node| node.primitives);
                    let Some(volume) = accel.volume(&shapes, id) else {
                        continue;
                    };
                    // A grid puts shapes also into cells that they nearly reach.
                    let bounds = volume.bounds();
                    let grown = bounds.padded(bounds.size() * 2e-3 + 1e-5);
                    for primitive in inside {
                        let bounds = shapes[*primitive as usize].bounds().expect("bounded");
                        let met = bounds.min.cmple(grown.max) & bounds.max.cmpge(grown.min);
                        assert!(met.all(), "{scene} {kind:?} node {id}");
                    }
                }
                let expected = u32::from(!matches!(kind, AccelKind::Grid));
                assert!(
                    parents.iter().skip(1).all(|count| *count == expected),
                    "{scene} {kind:?}"
                );
                assert_eq!(parents.first().copied().unwrap_or(0), 0);
                assert_eq!(accel.bounds().is_none(), kind == AccelKind::List);
            }
        }
    }
}
