//! Kd-tree: a binary space partitioning tree whose planes are all along the axes, each the best of all that there
//! are by the surface area heuristic.
//!
//! Bounds are sorted once, for the root (of large scenes, for each of the parts that [`upper`] leaves). A plane parts the
//! sorted lists into two that are sorted as well; only the bounds of what it cuts, which are new, are sorted and merged
//! in. So the whole is done in O(n log n).
//! Source: Wald and Havran 2006, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)".
//!
//! All is in the space of [`super::fast::compact`], and bounds are rounded to single precision: its planes are thick enough.

mod events;
mod part;
mod upper;

use super::bounded::Primitives;
use super::fast::compact::{CompactNode, CompactTree, MAX_DEPTH, MAX_REFERENCES, Tree};
use super::fast::local_ray::{MAX_COORDINATE, UnitBox};
use super::inspect::Progress;
use crate::geometry::Shape;
use events::{Best, BoundEvent, sweep};
use part::{Clip, part};
use upper::SubtreeTask;

/// What a step to a child and a test of a primitive cost.
pub const STEP: f64 = 1.0;
pub const TEST: f64 = 1.5;

/// A plane that cuts off empty space is taken to cost this part of what it does. Source: Wald and Havran 2006.
pub const EMPTY_BONUS: f64 = 0.8;

/// Of a box, the smallest and the largest x, y and z.
pub type Bounds = [[f32; 3]; 2];

/// A primitive, or the part of it that reaches into a cell.
#[derive(Clone, Copy)]
pub struct Item {
    pub primitive: u32,
    /// Around the part.
    pub bounds: Bounds,
}

/// What a cell holds: items, and for each axis their bounds' events in order.
pub struct Cell {
    pub items: Vec<Item>,
    pub events: [Vec<BoundEvent>; 3],
    pub bounds: Bounds,
}

/// Builds the tree over `shapes`. No step depends on the number of threads.
pub fn build(shapes: &[Shape], progress: Progress) -> CompactTree {
    let primitives = Primitives::new(shapes, MAX_COORDINATE);
    let unit_box = UnitBox::new(primitives.bounds, primitives.tolerance);
    let clip = Clip {
        shapes,
        unit_box: &unit_box,
    };
    let bounds = around(primitives.bounded.iter().map(|id| clip.whole(*id)));
    let count = primitives.bounded.len();
    let mut tree = Tree::default();
    if count > 0 {
        let whole = SubtreeTask {
            primitives: primitives.bounded,
            bounds,
            place: 0,
            levels: [0, (8 + 2 * count.ilog2()).min(MAX_DEPTH)],
            spare: (MAX_REFERENCES - 1) * count,
        };
        tree = upper::tree(&clip, whole, progress);
    }
    CompactTree::new(unit_box, bounds, tree, primitives.unbounded, shapes)
}

impl Cell {
    /// A cell with the events of its items sorted.
    fn new(items: Vec<Item>, bounds: Bounds) -> Self {
        let events = [0, 1, 2].map(|axis| {
            let mut list = Vec::with_capacity(2 * items.len());
            for (i, item) in items.iter().enumerate() {
                BoundEvent::push(&mut list, i, &item.bounds, axis);
            }
            list.sort_unstable();
            list
        });
        Self {
            items,
            events,
            bounds,
        }
    }
}

/// The box around some items.
fn around(items: impl Iterator<Item = Item>) -> Bounds {
    let [mut min, mut max] = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    for item in items {
        let [low, high] = item.bounds;
        min = std::array::from_fn(|k| min[k].min(low[k]));
        max = std::array::from_fn(|k| max[k].max(high[k]));
    }
    [min, max]
}

/// The subtree of a cell, at most `levels` deep, in which cutting may add `spare` references.
fn grow(clip: &Clip, cell: Cell, levels: u32, spare: usize) -> Tree {
    let mut tree = Tree {
        nodes: vec![CompactNode::leaf(0, 0)],
        ..Tree::default()
    };
    grow_at(clip, &mut tree, 0, cell, [0, levels], spare);
    tree
}

/// Makes a node the root of a cell's subtree, `above` levels below the root and with at most `below` more.
fn grow_at(
    clip: &Clip,
    tree: &mut Tree,
    node: usize,
    cell: Cell,
    [above, below]: [u32; 2],
    spare: usize,
) {
    let whole = cell.items.len();
    tree.depth = tree.depth.max(above);
    let plane = (below > 0).then(|| choose(&cell)).flatten();
    let Some(plane) = plane.filter(|p| p.cut <= spare) else {
        return tree.make_leaf(node, cell.items.iter().map(|item| item.primitive));
    };
    let [behind, front] = part(clip, cell, &plane);
    let children = tree.push_children();
    tree.nodes[node] = CompactNode::along(plane.axis, plane.d, children);
    let [for_behind, for_front] = share(spare, whole, [behind.items.len(), front.items.len()]);
    let levels = [above + 1, below - 1];
    grow_at(clip, tree, children, behind, levels, for_behind);
    grow_at(clip, tree, children + 1, front, levels, for_front);
}

/// Of the references that cutting a cell of `whole` items may add, what may still be added in its halves: shared out by
/// need.
fn share(spare: usize, whole: usize, halves: [usize; 2]) -> [usize; 2] {
    let total = halves[0] + halves[1];
    let spare = spare - (total - whole);
    let for_front = (spare as u128 * halves[1] as u128 / total.max(1) as u128) as usize;
    [spare - for_front, for_front]
}

/// The plane that promises least cost, if it promises less than testing all items in one leaf.
fn choose(cell: &Cell) -> Option<Best> {
    let count = cell.items.len();
    let sweep = |axis: usize| sweep(&cell.events[axis], axis, count, &cell.bounds);
    worthwhile((0..3).filter_map(sweep), count)
}

/// The cheapest plane, if it promises less than testing `count` items in one leaf.
fn worthwhile(planes: impl Iterator<Item = Best>, count: usize) -> Option<Best> {
    let cheaper = |a: Best, b: Best| if b.cost < a.cost { b } else { a };
    let best = planes.reduce(cheaper)?;
    (best.cost < TEST * count as f64).then_some(best)
}
