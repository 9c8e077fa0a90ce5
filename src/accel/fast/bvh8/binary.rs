//! Binary BVHs, from which nodes of eight are collapsed.

use std::time::Duration;

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb as Box32;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::bvh2::node::Bvh2Node;

use super::LEAF_SIZE;
use super::partition::{Parts, partition};
use crate::accel::fast::local_ray::UnitBox;
use crate::geometry::{Aabb, Shape};

/// A binary tree whose leaves hold at most [`LEAF_SIZE`] items.
pub struct Binary {
    /// Siblings stand next to each other; the root is 0.
    pub nodes: Vec<Bvh2Node>,
    /// Indices into the boxes that the tree was built over, leaf by leaf.
    pub order: Vec<u32>,
}

/// A primitive's box in the unit box's space, rounded outwards.
///
/// It is grown by at most 2^-18, which is as thick as planes are taken anyway, and at random. Boxes that are all equal
/// would all choose the same neighbour, and clustering would take time that grows with their square.
pub fn outwards(unit_box: &UnitBox, bounds: Aabb, primitive: u32) -> Box32 {
    let bits = (u64::from(primitive) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 32)).wrapping_mul(0xd6e8_feb8_6659_fd93);
    let grow = [0, 21, 42].map(|shift| {
        let part = (bits ^ (bits >> 32)) >> shift & 0x1f_ffff;
        part as f32 / (1u64 << 39) as f32
    });
    let (min, max) = unit_box.outwards(bounds);
    let min = std::array::from_fn(|k| min[k] - grow[k]);
    let max = std::array::from_fn(|k| max[k] + grow[k]);
    Box32::new(Vec3A::from_array(min), Vec3A::from_array(max))
}

/// The good tree.
pub fn clustered(boxes: &[Box32]) -> Binary {
    let params = BvhBuildParams {
        max_prims_per_leaf: LEAF_SIZE as u32,
        ..BvhBuildParams::medium_build()
    };
    let tree = build_bvh2(boxes, params, &mut Duration::default());
    Binary {
        nodes: tree.nodes,
        order: tree.primitive_indices,
    }
}

/// The tree that halves `ids` again and again, and puts them in its order: built in bounded time whatever the boxes are, and
/// not deeper than `sah_depth` and the logarithm of their number.
pub fn halved(unit_box: &UnitBox, shapes: &[Shape], ids: &mut [u32], sah_depth: u32) -> Binary {
    let Parts { mut nodes, ranges } = partition(unit_box, shapes, ids, LEAF_SIZE, sah_depth);
    for leaf in nodes.iter_mut().filter(|node| node.is_leaf()) {
        let range = &ranges[leaf.first_index as usize];
        (leaf.first_index, leaf.prim_count) = (range.start as u32, range.len() as u32);
    }
    Binary {
        nodes,
        order: (0..ids.len() as u32).collect(),
    }
}
