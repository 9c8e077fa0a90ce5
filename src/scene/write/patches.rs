//! Parametric surfaces in a scene file: their leaves as Bezier patches.

use super::fields::{Fields, row, rows};
use crate::geometry::{Shape, SurfacePatch};

/// An object of patches of one degree; `None` if there are other shapes. Each leaf is a patch, so that it is hit where it was.
pub fn patches(shapes: &[Shape], fields: Fields) -> Option<String> {
    let leaves: Option<Vec<&SurfacePatch>> = shapes
        .iter()
        .map(|shape| match shape.plain() {
            Shape::Patch(patch) => Some(&**patch),
            _ => None,
        })
        .collect();
    let leaves = leaves?;
    let degree = leaves.first()?.degree();
    let points = |leaf: &&SurfacePatch| {
        let points: Vec<[f64; 3]> = leaf.control_points().map(|(p, _)| p.to_array()).collect();
        listed(points.chunks(degree[0] + 1).map(rows))
    };
    let weights = |leaf: &&SurfacePatch| {
        let weights: Vec<f64> = leaf.control_points().map(|(_, w)| w).collect();
        listed(weights.chunks(degree[0] + 1).map(row))
    };
    let is_plain = |leaf: &&SurfacePatch| leaf.control_points().all(|(_, w)| w == 1.0);
    let fields = fields
        .row("degree", &degree.map(|d| d as f64))
        .raw("patches", &listed(leaves.iter().map(points)));
    let fields = if leaves.iter().all(is_plain) {
        fields
    } else {
        fields.raw("weights", &listed(leaves.iter().map(weights)))
    };
    let ranges = leaves.iter().map(|leaf| rows(&leaf.range()));
    let fields = fields.raw("ranges", &listed(ranges));
    Some(fields.kind("bezier"))
}

fn listed(parts: impl Iterator<Item = String>) -> String {
    format!("[{}]", parts.collect::<Vec<_>>().join(", "))
}
