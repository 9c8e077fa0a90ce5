//! A kd-tree: a binary space partitioning tree whose planes are all along the axes, each the best of all that there
//! are by the surface area heuristic.
//!
//! Bounds are sorted once, for the root. A plane parts the sorted lists into two that are sorted as well; only the
//! bounds of what it cuts, which are new, are sorted and merged in. So the whole is done in O(n log n).
//! Source: Wald and Havran 2006, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)".
//!
//! All is in the space of [`super::planes`], and bounds are rounded to single precision: its planes are thick enough.

mod events;
mod part;

use rayon::join;

use super::local::Frame;
use super::planes::{MAX_DEPTH, MAX_REACH, MAX_REFERENCES, Node, Planes, Tree};
use super::sift::sift;
use crate::geometry::Shape;
use events::{Best, Event, sweep};
use part::{Clip, part};

/// What a step to a child and a test of a primitive cost.
pub const STEP: f64 = 1.0;
pub const TEST: f64 = 1.5;

/// A plane that cuts off empty space is taken to cost this part of what it does. Source: Wald and Havran 2006.
pub const EMPTY_BONUS: f64 = 0.8;

/// Cells of so many items have their halves built side by side.
const PARALLEL: usize = 4096;

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
    pub events: [Vec<Event>; 3],
    pub bounds: Bounds,
}

/// Builds the tree over `shapes`. No step depends on the number of threads.
pub fn build(shapes: &[Shape]) -> Planes {
    let sifted = sift(shapes, MAX_REACH);
    let frame = Frame::new(sifted.bounds, sifted.slack);
    let clip = Clip {
        shapes,
        frame: &frame,
    };
    let items: Vec<Item> = sifted
        .inside
        .iter()
        .map(|(id, _)| clip.whole(*id))
        .collect();
    let bounds = around(&items);
    let count = items.len();
    let mut tree = Tree::default();
    if count > 0 {
        let list = |axis| {
            let mut list = Vec::with_capacity(2 * count);
            for (i, item) in items.iter().enumerate() {
                Event::push(&mut list, i, &item.bounds, axis);
            }
            list.sort_unstable();
            list
        };
        let (x, (y, z)) = join(|| list(0), || join(|| list(1), || list(2)));
        let cell = Cell {
            items,
            events: [x, y, z],
            bounds,
        };
        let levels = (8 + 2 * count.ilog2()).min(MAX_DEPTH);
        tree = grow(&clip, cell, levels, (MAX_REFERENCES - 1) * count);
    }
    Planes::new(frame, bounds, tree, sifted.outside, shapes)
}

/// The box around some items.
pub fn around(items: &[Item]) -> Bounds {
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
        nodes: vec![Node::leaf(0, 0)],
        ..Tree::default()
    };
    grow_at(clip, &mut tree, 0, cell, [0, levels], spare);
    tree
}

/// The same, in a place of a tree: so many levels are above it, and so many may follow.
fn grow_at(
    clip: &Clip,
    tree: &mut Tree,
    place: usize,
    cell: Cell,
    [above, below]: [u32; 2],
    spare: usize,
) {
    let whole = cell.items.len();
    tree.depth = tree.depth.max(above);
    let plane = (below > 0).then(|| choose(&cell)).flatten();
    let Some(plane) = plane.filter(|p| p.cut <= spare) else {
        return tree.fill(place, cell.items.iter().map(|item| item.primitive));
    };
    let [behind, front] = part(clip, cell, &plane);
    let children = tree.pair();
    tree.nodes[place] = Node::along(plane.axis, plane.d, children);

    // What may still be added is shared out by need.
    let total = behind.items.len() + front.items.len();
    let spare = spare - (total - whole);
    let for_front = (spare as u128 * front.items.len() as u128 / total.max(1) as u128) as usize;
    let for_behind = spare - for_front;
    let levels = [above + 1, below - 1];
    if whole < PARALLEL {
        grow_at(clip, tree, children, behind, levels, for_behind);
        grow_at(clip, tree, children + 1, front, levels, for_front);
    } else {
        let (mut behind, mut front) = join(
            || grow(clip, behind, below - 1, for_behind),
            || grow(clip, front, below - 1, for_front),
        );
        behind.depth += above + 1;
        front.depth += above + 1;
        tree.graft(children, behind);
        tree.graft(children + 1, front);
    }
}

/// The plane that promises least cost, if it promises less than testing all items in one leaf.
fn choose(cell: &Cell) -> Option<Best> {
    let count = cell.items.len();
    let sweep = |axis: usize| sweep(&cell.events[axis], axis, count, &cell.bounds);
    let all = if count < PARALLEL {
        [sweep(0), sweep(1), sweep(2)]
    } else {
        let (x, (y, z)) = join(|| sweep(0), || join(|| sweep(1), || sweep(2)));
        [x, y, z]
    };
    let cheaper = |a: Best, b: Best| if b.cost < a.cost { b } else { a };
    let best = all.into_iter().flatten().reduce(cheaper)?;
    (best.cost < TEST * count as f64).then_some(best)
}
