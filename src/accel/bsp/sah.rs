//! Surface area heuristic (SAH) for planes along the axes.
//!
//! A ray that meets a convex cell meets a convex part of it with probability (area of the part) / (area of the cell),
//! so the expected cost of a plane is C_step + (A_back n_back + A_front n_front) / A C_test.
//! Source: MacDonald and Booth 1990; counted in bins as by Wald 2007.

use super::classify::{Item, Splitter};
use crate::geometry::Aabb;

/// What a step to a child costs, in tests of one primitive.
const STEP: f64 = 1.0;

/// How many bins an axis is cut into.
const BINS: usize = 32;

/// The plane that promises least cost, if it promises less than testing all `items` in one leaf.
pub fn choose(items: &[Item], cell: &Aabb) -> Option<Splitter> {
    let extent = bounds_of(items);
    let (mut best, mut least) = (None, items.len() as f64);
    for axis in 0..3 {
        let (min, max) = (extent.min[axis], extent.max[axis]);
        let width = (max - min) / BINS as f64;
        if !(width > 0.0 && width.is_finite()) {
            continue;
        }
        // How many items begin and end in each bin.
        let (mut begins, mut ends) = ([0u32; BINS], [0u32; BINS]);
        let bin = |x: f64| (((x - min) / width) as usize).min(BINS - 1);
        for item in items {
            begins[bin(item.bounds.min[axis])] += 1;
            ends[bin(item.bounds.max[axis])] += 1;
        }
        // Sweep over the bins' borders. The first and the last cut off empty space.
        let (mut back, mut front) = (0, items.len() as u32);
        for border in 0..=BINS {
            let d = if border == BINS {
                max
            } else {
                min + border as f64 * width
            };
            let cost = STEP + expected(cell, axis, d, back, front);
            if cost < least {
                (best, least) = (Some(Splitter::along(axis, d)), cost);
            }
            if border < BINS {
                back += begins[border];
                front -= ends[border];
            }
        }
    }
    best
}

/// The tests to expect when the cell is split at `d`.
fn expected(cell: &Aabb, axis: usize, d: f64, back: u32, front: u32) -> f64 {
    let (mut low, mut high) = (*cell, *cell);
    low.max[axis] = d;
    high.min[axis] = d;
    (low.surface_area() * back as f64 + high.surface_area() * front as f64) / cell.surface_area()
}

/// The box around some items.
pub fn bounds_of(items: &[Item]) -> Aabb {
    items
        .iter()
        .fold(Aabb::EMPTY, |b, item| b.union(item.bounds))
}
