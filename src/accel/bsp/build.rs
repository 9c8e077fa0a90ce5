//! BSP construction: one cell after the other gets a plane or becomes a leaf.

use super::classify::{Item, PlaneSide, Splitter};
use super::{Bsp, BspNode, MAX_DEPTH, sah};
use crate::accel::bounded::Primitives;
use crate::accel::tolerance::Tolerance;
use crate::geometry::{Aabb, Shape};
use crate::math::rounding::UNIT_ROUNDOFF;

/// How many references there are at most, for each primitive.
const MAX_REFERENCES: usize = 8;

/// Polygons whose planes are tried, and items that a plane is judged by.
const CANDIDATES: usize = 8;
const JURY: usize = 96;

/// A plane is worth it if the tests to expect fall to this part of what they were.
const WORTH: f64 = 0.9;

/// A cell that is still to be parted.
struct Task {
    items: Vec<Item>,
    /// A box around the cell.
    cell: Aabb,
    depth: u32,
    /// How many references cutting may still add below.
    spare: usize,
    /// The node that this becomes the back child of.
    parent: Option<usize>,
}

struct Builder<'a> {
    shapes: &'a [Shape],
    tree: Bsp,
    /// Whether the polygons' own planes are tried.
    polygons: bool,
    /// Points closer to a polygon's plane than this are on it: 32 u times the largest coordinate bounds the error of
    /// n.p - d.
    tolerance: f64,
    max_depth: u32,
}

/// Builds the tree over `shapes`, with the planes of the polygons or only with planes along the axes.
pub fn build(shapes: &[Shape], polygons: bool) -> Bsp {
    let (mut builder, root) = Builder::new(shapes, polygons);
    if !root.items.is_empty() {
        builder.grow(root);
    }
    builder.tree
}

impl<'a> Builder<'a> {
    /// A tree without nodes, and the cell of all that will be in it.
    fn new(shapes: &'a [Shape], polygons: bool) -> (Self, Task) {
        let Primitives {
            bounded,
            unbounded,
            bounds,
            tolerance,
        } = Primitives::new(shapes, Tolerance::MAX_COORDINATE);
        let whole = |id: u32| Item::whole(id, &shapes[id as usize]);
        let items: Vec<Item> = bounded.into_iter().filter_map(whole).collect();
        let count = items.len();
        let builder = Self {
            shapes,
            tree: Bsp {
                bounds,
                nodes: Vec::new(),
                normals: Vec::new(),
                references: Vec::with_capacity(count),
                unbounded,
                tolerance,
                depth: 0,
            },
            polygons,
            tolerance: 32.0 * UNIT_ROUNDOFF * tolerance.max_coordinate,
            max_depth: (8 + 2 * count.max(1).ilog2()).min(MAX_DEPTH),
        };
        let root = Task {
            items,
            cell: bounds,
            depth: 0,
            spare: (MAX_REFERENCES - 1) * count,
            parent: None,
        };
        (builder, root)
    }

    /// Works through the cells, front before back, so that nodes come to lie depth first.
    fn grow(&mut self, root: Task) {
        let mut work = vec![root];
        while let Some(task) = work.pop() {
            self.tree.depth = self.tree.depth.max(task.depth);
            if let Some(parent) = task.parent {
                self.tree.nodes[parent].back = self.tree.nodes.len() as u32;
            }
            match self.choose(&task) {
                Some((plane, sides)) => work.extend(self.split(task, &plane, &sides)),
                None => self.push(&task.items),
            }
        }
    }

    /// The next node, with its references; a leaf as yet.
    fn push(&mut self, items: &[Item]) {
        let (first, count) = (self.tree.references.len() as u32, items.len() as u32);
        self.tree.nodes.push(BspNode::leaf(first, count));
        self.tree
            .references
            .extend(items.iter().map(|item| item.primitive));
    }

    /// The plane for a cell, and where it puts the items. `None`: the cell stays whole.
    fn choose(&self, task: &Task) -> Option<(Splitter, Vec<PlaneSide>)> {
        if task.items.len() < 2 || task.depth >= self.max_depth {
            return None;
        }
        let plane = self
            .polygon_plane(&task.items)
            .or_else(|| sah::choose(&task.items, &task.cell))?;
        let sides: Vec<PlaneSide> = task.items.iter().map(|item| plane.side(item)).collect();
        let cut = sides
            .iter()
            .filter(|&&side| side == PlaneSide::Both)
            .count();
        (cut < sides.len() && cut <= task.spare).then_some((plane, sides))
    }

    /// The best plane among those of a few of the polygons; `None` if none is worth it, as inside a convex hull,
    /// where all planes have everything behind them.
    fn polygon_plane(&self, items: &[Item]) -> Option<Splitter> {
        if !self.polygons {
            return None;
        }
        let area = sah::bounds_of(items).surface_area();
        let worth = WORTH * items.len() as f64;
        every(items, CANDIDATES)
            .filter_map(|item| {
                let shape = &self.shapes[item.primitive as usize];
                Splitter::of_triangle(item.primitive, shape, self.tolerance)
            })
            .map(|plane| (judge(&plane, items, area), plane))
            .filter(|(cost, _)| *cost < worth)
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, plane)| plane)
    }

    /// Makes a node of the plane and of what lies on it; what lies behind and in front is left to do.
    fn split(&mut self, task: Task, plane: &Splitter, sides: &[PlaneSide]) -> [Task; 2] {
        let (before, mut on) = (task.items.len(), Vec::new());
        let (mut front, mut back) = (Vec::new(), Vec::new());
        for (item, side) in task.items.into_iter().zip(sides) {
            match side {
                PlaneSide::On => on.push(item),
                PlaneSide::Front => front.push(item),
                PlaneSide::Back => back.push(item),
                PlaneSide::Both => {
                    let [f, b] = plane.cut(item);
                    front.push(f);
                    back.push(b);
                }
            }
        }
        let id = self.tree.nodes.len();
        self.push(&on);
        self.tree.nodes[id].d = plane.d;
        self.tree.nodes[id].plane = self.name(plane);

        // What may still be added is shared out by need.
        let total = front.len() + back.len();
        let spare = task.spare - (total + on.len() - before);
        let for_front = (spare as u128 * front.len() as u128 / total.max(1) as u128) as usize;
        let child = |items, cell, spare, parent| Task {
            items,
            cell,
            depth: task.depth + 1,
            spare,
            parent,
        };
        let [front_cell, back_cell] = cells(plane, &task.cell, &front, &back);
        [
            child(back, back_cell, spare - for_front, Some(id)),
            child(front, front_cell, for_front, None),
        ]
    }

    /// How a node names its plane.
    fn name(&mut self, plane: &Splitter) -> u32 {
        if let Some(axis) = plane.axis {
            return axis as u32;
        }
        self.tree.normals.push(plane.normal);
        self.tree.normals.len() as u32 + 2
    }
}

/// The boxes in front of a plane and behind it.
fn cells(plane: &Splitter, cell: &Aabb, front: &[Item], back: &[Item]) -> [Aabb; 2] {
    let (mut high, mut low) = (*cell, *cell);
    if let Some(axis) = plane.axis {
        high.min[axis] = plane.d;
        low.max[axis] = plane.d;
        [high, low]
    } else {
        [sah::bounds_of(front), sah::bounds_of(back)]
    }
}

/// The tests to expect if `plane` parts the items, judged by some of them: as in [`sah`], with the boxes around what
/// is on either side for want of the cells' true areas. What lies on the plane is tested by every other ray.
fn judge(plane: &Splitter, items: &[Item], area: f64) -> f64 {
    let (mut front, mut back) = ((Aabb::EMPTY, 0.0), (Aabb::EMPTY, 0.0));
    let (mut on, mut asked) = (0.0, 0.0);
    let add = |to: &mut (Aabb, f64), item: &Item| *to = (to.0.union(item.bounds), to.1 + 1.0);
    for item in every(items, JURY) {
        asked += 1.0;
        match plane.side(item) {
            PlaneSide::On => on += 1.0,
            PlaneSide::Front => add(&mut front, item),
            PlaneSide::Back => add(&mut back, item),
            PlaneSide::Both => {
                add(&mut front, item);
                add(&mut back, item);
            }
        }
    }
    let sides = front.0.surface_area() * front.1 + back.0.surface_area() * back.1;
    (sides / area + 0.5 * on) * items.len() as f64 / asked
}

/// At most `count` of the items, evenly spread.
fn every(items: &[Item], count: usize) -> impl Iterator<Item = &Item> {
    let step = items.len().div_ceil(count).max(1);
    items.iter().skip(step / 2).step_by(step)
}

#[cfg(test)]
mod tests;
