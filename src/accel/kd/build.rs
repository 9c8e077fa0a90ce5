//! Growing the tree: every cell is swept along each axis, and all bounds in it are candidates.

use super::{Kd, LEAF, MAX_DEPTH, Node};
use crate::accel::bsp::classify::{Item, Splitter};
use crate::accel::bsp::sah::bounds_of;
use crate::accel::slack::{Slack, conditioning};
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;

/// What a step to a child and a test of a primitive cost.
const STEP: f64 = 1.0;
const TEST: f64 = 1.5;

/// A plane that cuts off empty space is taken to cost this part of what it does. Source: Wald and Havran 2006.
const EMPTY_BONUS: f64 = 0.8;

/// How many references there are at most, for each primitive.
const MAX_REFERENCES: usize = 8;

/// Cells of so many items have their halves built side by side.
const PARALLEL: usize = 2048;

/// A plane, and the side that what lies on it goes to.
#[derive(Clone, Copy)]
struct Plane {
    axis: usize,
    d: f64,
    on_to_front: bool,
}

/// A cell's subtree, before the nodes are numbered.
enum Tree {
    Leaf(Vec<u32>),
    /// The plane, then what is in front of it and what is behind.
    Split(Plane, Box<[Tree; 2]>),
}

impl Kd {
    /// Builds the tree over `shapes`. No step depends on the number of threads.
    pub fn build(shapes: &[Shape]) -> Self {
        let (mut items, mut outside) = (Vec::with_capacity(shapes.len()), Vec::new());
        let (mut reach, mut condition) = (0.0f64, 0.0f64);
        for (id, shape) in shapes.iter().enumerate() {
            let (r, c) = conditioning(shape);
            let sharp = c <= Slack::MAX_CONDITION && r <= Slack::MAX_REACH;
            match Item::whole(id as u32, shape) {
                Some(item) if sharp => {
                    reach = reach.max(r);
                    condition = condition.max(c);
                    items.push(item);
                }
                _ => outside.push(id as u32),
            }
        }
        let mut kd = Self {
            bounds: bounds_of(&items),
            nodes: Vec::new(),
            references: Vec::with_capacity(items.len()),
            outside,
            slack: Slack::new(reach, condition),
            depth: 0,
        };
        let count = items.len();
        if count > 0 {
            let levels = (8 + 2 * count.ilog2()).min(MAX_DEPTH);
            let tree = grow(items, kd.bounds, levels, (MAX_REFERENCES - 1) * count);
            kd.append(tree, 0);
        }
        kd
    }

    /// Numbers a subtree's nodes, depth first.
    fn append(&mut self, tree: Tree, depth: u32) {
        self.depth = self.depth.max(depth);
        match tree {
            Tree::Leaf(primitives) => {
                self.nodes.push(Node {
                    d: 0.0,
                    kind: LEAF + primitives.len() as u32,
                    link: self.references.len() as u32,
                });
                self.references.extend(primitives);
            }
            Tree::Split(plane, children) => {
                let id = self.nodes.len();
                self.nodes.push(Node {
                    d: plane.d,
                    kind: plane.axis as u32,
                    link: 0,
                });
                let [front, back] = *children;
                self.append(front, depth + 1);
                self.nodes[id].link = self.nodes.len() as u32;
                self.append(back, depth + 1);
            }
        }
    }
}

/// The subtree of a cell, at most `levels` deep, in which cutting may add `spare` references.
fn grow(items: Vec<Item>, cell: Aabb, levels: u32, spare: usize) -> Tree {
    let whole = items.len();
    let plane = (levels > 0).then(|| choose(&items, &cell)).flatten();
    let cut = |p: &Plane| {
        let crosses = |i: &&Item| i.bounds.min[p.axis] < p.d && p.d < i.bounds.max[p.axis];
        items.iter().filter(crosses).count()
    };
    let Some(plane) = plane.filter(|p| cut(p) <= spare) else {
        return Tree::Leaf(items.iter().map(|item| item.primitive).collect());
    };
    let [front, back] = part(items, plane);
    // What may still be added is shared out by need.
    let total = front.len() + back.len();
    let spare = spare - (total - whole);
    let for_front = (spare as u128 * front.len() as u128 / total.max(1) as u128) as usize;
    let (mut high, mut low) = (cell, cell);
    high.min[plane.axis] = plane.d;
    low.max[plane.axis] = plane.d;
    let in_front = || grow(front, high, levels - 1, for_front);
    let behind = || grow(back, low, levels - 1, spare - for_front);
    let (front, back) = if whole > PARALLEL {
        rayon::join(in_front, behind)
    } else {
        (in_front(), behind())
    };
    Tree::Split(plane, Box::new([front, back]))
}

/// The items in front of a plane and behind it; those that cross it are clipped, so that their bounds stay exact.
fn part(items: Vec<Item>, plane: Plane) -> [Vec<Item>; 2] {
    let (mut front, mut back) = (Vec::new(), Vec::new());
    let splitter = Splitter::along(plane.axis, plane.d);
    for item in items {
        let (min, max) = (item.bounds.min[plane.axis], item.bounds.max[plane.axis]);
        match (min >= plane.d, max <= plane.d) {
            (true, true) if plane.on_to_front => front.push(item),
            (_, true) => back.push(item),
            (true, false) => front.push(item),
            (false, false) => {
                let [f, b] = splitter.cut(item);
                front.push(f);
                back.push(b);
            }
        }
    }
    [front, back]
}

/// The plane that promises least cost, if it promises less than testing all items in one leaf.
fn choose(items: &[Item], cell: &Aabb) -> Option<Plane> {
    let (mut best, mut least) = (None, TEST * items.len() as f64);
    for axis in 0..3 {
        let sorted = |pick: fn(&Aabb) -> DVec3| {
            let mut all: Vec<f64> = items.iter().map(|i| pick(&i.bounds)[axis]).collect();
            all.sort_unstable_by(f64::total_cmp);
            all
        };
        let (begins, ends) = (sorted(|b| b.min), sorted(|b| b.max));
        let mut flat: Vec<f64> = items
            .iter()
            .filter(|i| i.bounds.min[axis] == i.bounds.max[axis])
            .map(|i| i.bounds.min[axis])
            .collect();
        flat.sort_unstable_by(f64::total_cmp);
        // Sweep: how many begin before d, how many end at it or before, how many lie on it.
        let (mut begun, mut ended, mut passed) = (0, 0, 0);
        while ended < items.len() {
            let d = match begins.get(begun) {
                Some(&begin) if begin < ends[ended] => begin,
                _ => ends[ended],
            };
            while begun < begins.len() && begins[begun] < d {
                begun += 1;
            }
            let behind = begun;
            while ended < ends.len() && ends[ended] <= d {
                ended += 1;
            }
            let in_front = items.len() - ended;
            let before = passed;
            while passed < flat.len() && flat[passed] <= d {
                passed += 1;
            }
            let on = passed - before;
            if cell.min[axis] < d && d < cell.max[axis] {
                for on_to_front in [false, true] {
                    let (f, b) = if on_to_front { (on, 0) } else { (0, on) };
                    let cost = expected(cell, axis, d, behind + b, in_front + f);
                    if cost < least {
                        least = cost;
                        best = Some(Plane {
                            axis,
                            d,
                            on_to_front,
                        });
                    }
                }
            }
            while begun < begins.len() && begins[begun] <= d {
                begun += 1;
            }
        }
    }
    best
}

/// The cost to expect when the cell is split at `d`. Source: MacDonald and Booth 1990.
fn expected(cell: &Aabb, axis: usize, d: f64, back: usize, front: usize) -> f64 {
    let (mut low, mut high) = (*cell, *cell);
    low.max[axis] = d;
    high.min[axis] = d;
    let tests = low.surface_area() * back as f64 + high.surface_area() * front as f64;
    let bonus = if back == 0 || front == 0 {
        EMPTY_BONUS
    } else {
        1.0
    };
    bonus * (STEP + TEST * tests / cell.surface_area())
}
