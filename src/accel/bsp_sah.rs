//! A BSP tree with planes along the axes or at any angle, chosen by the surface area heuristic.
//!
//! It is built as [`super::kd`] is, but cells are convex polyhedra and what is cut are polygons, so that planes at any
//! angle are judged as exactly as those along the axes. Near the leaves, where few triangles are left, it is the planes
//! of these triangles that set them apart. Source: Ize, Wald and Parker 2008, "Ray tracing with the BSP tree".
//!
//! All is in the space of [`super::fast::compact`], in double precision; the planes are rounded at last, and are thick enough.
//! Areas only serve to choose: an error there makes the tree slower, never wrong.

mod cell;
mod choose;

use super::bounded::{Primitives, bounds_of};
use super::bsp::classify::{Item, PlaneSide, Splitter};
use super::fast::compact::{
    CompactNode, CompactTree, MAX_DEPTH, MAX_REFERENCES, ObliquePlane, Tree,
};
use super::fast::local_ray::{MAX_COORDINATE, UnitBox};
use super::inspect::Progress;
use super::kd;
use crate::geometry::{Aabb, Shape, Triangle};
use cell::Cell;
use choose::{Split, choose};

/// Of more shapes the tree is [`kd`]'s: this one would take too long to build.
const MOST: usize = 20_000;

/// Builds the tree over `shapes`.
pub fn build(shapes: &[Shape], progress: Progress) -> CompactTree {
    if shapes.len() > MOST {
        return kd::build(shapes, progress);
    }
    let primitives = Primitives::new(shapes, MAX_COORDINATE);
    let unit_box = UnitBox::new(primitives.bounds, primitives.tolerance);
    let moved: Vec<Option<Triangle>> = shapes
        .iter()
        .map(|shape| inside(&unit_box, shape))
        .collect();
    let whole = |id: u32| {
        if let Some(triangle) = moved[id as usize] {
            return Item::whole(id, &Shape::Triangle(triangle));
        }
        let bounds = bounds_of(shapes, id);
        Some(Item {
            primitive: id,
            bounds: Aabb::around([bounds.min, bounds.max].map(|p| unit_box.to_local(p))),
            corners: Vec::new(),
        })
    };
    let items: Vec<Item> = primitives
        .bounded
        .iter()
        .copied()
        .filter_map(whole)
        .collect();
    let bounds = Aabb::around(items.iter().flat_map(|i| [i.bounds.min, i.bounds.max]));
    let mut builder = Builder {
        triangles: moved,
        tree: Tree::default(),
    };
    let count = items.len();
    if count > 0 {
        builder.tree.nodes.push(CompactNode::leaf(0, 0));
        let task = Task {
            items,
            cell: Cell::of(&bounds),
            place: 0,
            depth: 0,
            spare: (MAX_REFERENCES - 1) * count,
        };
        builder.grow(task, (8 + 2 * count.ilog2()).min(MAX_DEPTH));
    }
    let corners = [bounds.min, bounds.max].map(|p| p.to_array().map(|x| x as f32));
    CompactTree::new(
        unit_box,
        corners,
        builder.tree,
        primitives.unbounded,
        shapes,
    )
}

/// A triangle in the unit box's space; `None` for other shapes.
fn inside(unit_box: &UnitBox, shape: &Shape) -> Option<Triangle> {
    let Shape::Triangle(triangle) = shape else {
        return None;
    };
    Some(Triangle {
        corners: triangle.corners.map(|p| unit_box.to_local(p)),
    })
}

struct Builder {
    /// The scene's triangles in the unit box's space; `None` for other shapes.
    triangles: Vec<Option<Triangle>>,
    tree: Tree,
}

/// A cell that is still to be parted.
struct Task {
    items: Vec<Item>,
    cell: Cell,
    /// The node that it becomes.
    place: usize,
    depth: u32,
    /// How many references cutting may still add below.
    spare: usize,
}

impl Builder {
    /// The subtree of a cell, no deeper in the tree than `deepest`.
    fn grow(&mut self, task: Task, deepest: u32) {
        self.tree.depth = self.tree.depth.max(task.depth);
        let choice = if task.depth < deepest {
            choose(&task.items, &task.cell, &self.triangles)
        } else {
            None
        };
        if let Some(choice) = choice.filter(|choice| choice.cut <= task.spare) {
            let [behind, front] = self.split(task, &choice);
            self.grow(behind, deepest);
            self.grow(front, deepest);
        } else {
            let primitives = task.items.iter().map(|item| item.primitive);
            self.tree.make_leaf(task.place, primitives);
        }
    }

    /// Makes a node of the plane; what lies behind it and in front is left to do.
    fn split(&mut self, task: Task, choice: &Split) -> [Task; 2] {
        let (before, plane) = (task.items.len(), &choice.plane);
        let (mut behind, mut front) = (Vec::new(), Vec::new());
        for item in task.items {
            match plane.side(&item) {
                PlaneSide::On if choice.on_to_front => front.push(item),
                PlaneSide::On | PlaneSide::Back => behind.push(item),
                PlaneSide::Front => front.push(item),
                PlaneSide::Both => {
                    let [f, b] = plane.cut(item);
                    front.push(f);
                    behind.push(b);
                }
            }
        }
        let children = self.tree.push_children();
        self.tree.nodes[task.place] = self.name(plane, children);

        // What may still be added is shared out by need.
        let total = behind.len() + front.len();
        let spare = task.spare - (total - before);
        let for_front = (spare as u128 * front.len() as u128 / total.max(1) as u128) as usize;
        let [front_cell, behind_cell] = task.cell.cut(plane.normal, plane.d);
        let child = |items, cell, place, spare| Task {
            items,
            cell,
            place,
            depth: task.depth + 1,
            spare,
        };
        [
            child(behind, behind_cell, children, spare - for_front),
            child(front, front_cell, children + 1, for_front),
        ]
    }

    /// The node of a plane.
    fn name(&mut self, plane: &Splitter, children: usize) -> CompactNode {
        if let Some(axis) = plane.axis {
            return CompactNode::along(axis, plane.d as f32, children);
        }
        self.tree.oblique.push(ObliquePlane {
            normal: plane.normal.to_array().map(|x| x as f32),
            d: plane.d as f32,
        });
        CompactNode::oblique(self.tree.oblique.len() - 1, children)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn slats_side_by_side_are_parted_without_a_cut() {
        // Long triangles across the diagonal: no plane along an axis passes between two of them.
        let slats: Vec<Shape> = (0..16)
            .map(|i| {
                let root = 0.1 * f64::from(i) * DVec3::new(1.0, -1.0, 0.0);
                let corners = [root, root + DVec3::ONE, root + DVec3::new(1.0, 1.0, 0.8)];
                Shape::Triangle(Triangle { corners })
            })
            .collect();
        let (oblique, kd) = (
            build(&slats, &|_| ()).stats(),
            kd::build(&slats, &|_| ()).stats(),
        );
        assert!(oblique.polygon_planes > 0);
        assert_eq!(oblique.references, slats.len());
        assert!(kd.references > slats.len(), "{kd:?}");
    }
}
