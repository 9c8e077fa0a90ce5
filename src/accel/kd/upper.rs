//! The upper part of a large kd-tree, where a cell's plane is the best of few.
//!
//! Sorted lists of all bounds take several times the memory of the scene. In a large cell the cost changes little from
//! plane to plane, so bounds are only counted in bins there, and the planes between the bins are compared. Cells of at
//! most [`PART`] primitives are left to the exact search, as many at a time as there are threads to work side by side.
//! Source: Popov, Guenther, Seidel and Slusallek 2006, "Experiences with streaming construction of SAH kd-trees".

use rayon::prelude::*;

use super::events::{Best, Costs};
use super::part::Clip;
use super::{Bounds, Cell, Item, grow, share, worthwhile};
use crate::accel::fast::compact::{CompactNode, Tree};
use crate::accel::inspect::Progress;

/// Primitives of a cell whose plane is the best of all.
const PART: usize = 1 << 12;

/// How many bins an axis is cut into.
const BINS: usize = 256;

/// A cell that is still to be parted.
pub struct SubtreeTask {
    /// The primitives that reach into it. What part of each does is found out again and again: a number is all that is
    /// kept.
    pub primitives: Vec<u32>,
    pub bounds: Bounds,
    /// The node that it becomes.
    pub place: usize,
    /// How many levels are above it, and how many may follow.
    pub levels: [u32; 2],
    /// How many references cutting may still add.
    pub spare: usize,
}

/// The tree of a scene.
pub fn tree(clip: &Clip, whole: SubtreeTask, progress: Progress) -> Tree {
    let mut tree = Tree {
        nodes: vec![CompactNode::leaf(0, 0)],
        ..Tree::default()
    };
    if whole.primitives.len() > PART {
        // Enough for most scenes: memory that is never touched costs nothing, and lists that grow leave holes.
        tree.nodes.reserve(8 * whole.primitives.len());
        tree.references.reserve(8 * whole.primitives.len());
    }
    let mut parts = Vec::new();
    part(clip, &mut tree, whole, &mut parts);
    // Few at a time, so that few are there twice: by themselves and in the tree.
    let (total, few) = (parts.len(), 4 * rayon::current_num_threads());
    while !parts.is_empty() {
        let some: Vec<SubtreeTask> = parts.drain(..few.min(parts.len())).collect();
        let grown = some.into_par_iter().map(|task| {
            let [above, below] = task.levels;
            let cell = Cell::new(task.items(clip).collect(), task.bounds);
            let mut tree = grow(clip, cell, below, task.spare);
            tree.depth += above;
            (task.place, tree)
        });
        for (place, below) in grown.collect::<Vec<_>>() {
            tree.graft(place, below);
        }
        progress(1.0 - parts.len() as f64 / total as f64);
    }
    tree
}

/// Parts a cell until its parts are small.
fn part(clip: &Clip, tree: &mut Tree, task: SubtreeTask, parts: &mut Vec<SubtreeTask>) {
    let ([above, below], whole) = (task.levels, task.primitives.len());
    let large = whole > PART && below > 0;
    let plane = large.then(|| task.choose(clip)).flatten();
    let Some(plane) = plane.filter(|p| p.cut <= task.spare) else {
        parts.push(task);
        return;
    };
    let (axis, d) = (plane.axis, plane.d);
    let [mut behind, mut front] = [Vec::new(), Vec::new()];
    for Item { primitive, bounds } in task.items(clip) {
        // What is flat and lies on the plane goes behind it.
        if bounds[0][axis] < d || bounds[1][axis] <= d {
            behind.push(primitive);
        }
        if bounds[1][axis] > d {
            front.push(primitive);
        }
    }
    let spares = share(task.spare, whole, [behind.len(), front.len()]);
    let [mut low, mut high] = [task.bounds; 2];
    (low[1][axis], high[0][axis]) = (d, d);
    let children = tree.push_children();
    tree.nodes[task.place] = CompactNode::along(axis, d, children);
    drop(task);
    for (k, (primitives, bounds)) in [(behind, low), (front, high)].into_iter().enumerate() {
        let half = SubtreeTask {
            primitives,
            bounds,
            place: children + k,
            levels: [above + 1, below - 1],
            spare: spares[k],
        };
        part(clip, tree, half, parts);
    }
}

impl SubtreeTask {
    /// The parts of the primitives inside the cell.
    fn items(&self, clip: &Clip) -> impl Iterator<Item = Item> {
        self.primitives.iter().map(|primitive| {
            let mut item = clip.whole(*primitive);
            let ([min, max], [low, high]) = (item.bounds, self.bounds);
            if (0..3).any(|k| min[k] < low[k] || max[k] > high[k]) {
                let inside = [
                    std::array::from_fn(|k| min[k].clamp(low[k], high[k])),
                    std::array::from_fn(|k| max[k].clamp(low[k], high[k])),
                ];
                item.bounds = clip.inside(*primitive, &inside);
            }
            item
        })
    }

    /// The plane between bins that promises least cost, if any is worth it.
    fn choose(&self, clip: &Clip) -> Option<Best> {
        let [min, max] = self.bounds;
        let width: [f32; 3] = std::array::from_fn(|k| (max[k] - min[k]) / BINS as f32);
        let bin = |x: f32, k: usize| (((x - min[k]) / width[k]) as usize).min(BINS - 1);
        // How many begin and end in each bin.
        let mut bins = [[[0usize; 2]; BINS]; 3];
        for item in self.items(clip) {
            for (k, bins) in bins.iter_mut().enumerate() {
                bins[bin(item.bounds[0][k], k)][0] += 1;
                bins[bin(item.bounds[1][k], k)][1] += 1;
            }
        }
        let count = self.primitives.len();
        let planes = (0..3).flat_map(|axis| {
            let costs = Costs::new(axis, &self.bounds);
            let (mut behind, mut front) = (0, count);
            (1..BINS).map(move |border| {
                let [begun, ended] = bins[axis][border - 1];
                (behind, front) = (behind + begun, front - ended);
                let d = min[axis] + border as f32 * width[axis];
                Best {
                    axis,
                    d,
                    flat_to_front: false,
                    cost: costs.of(f64::from(d), behind, front),
                    cut: 0,
                }
            })
        });
        let mut best = worthwhile(
            planes.filter(|p| min[p.axis] < p.d && p.d < max[p.axis]),
            count,
        )?;
        let is_cut = |i: &Item| i.bounds[0][best.axis] < best.d && best.d < i.bounds[1][best.axis];
        best.cut = self.items(clip).filter(is_cut).count();
        Some(best)
    }
}
