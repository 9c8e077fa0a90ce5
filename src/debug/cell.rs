//! The part of space that a node of the accelerator stands for: a box, a sphere, or what the planes above it leave.

use super::outline::ObjectOutline;
use super::session::Session;
use crate::accel::Volume;
use crate::geometry::Aabb;
use crate::math::{DVec3, Frame};
use crate::probe::{Event, Visit};

/// Rounding, as a share of a cell's size: a point so near to a plane lies on it.
const ON: f64 = 1e-9;

/// One side of a plane: the points with n.p <= d, n unit.
#[derive(Clone, Copy, Debug, PartialEq)]
struct HalfSpace {
    n: DVec3,
    d: f64,
}

/// The part of space of a node.
#[derive(Clone, Debug)]
pub enum NodeCell {
    /// A convex polyhedron, maybe with sides that do not touch it.
    Convex(ConvexCell),
    /// A sphere with its inside: center and radius.
    Sphere(DVec3, f64),
}

/// What lies on the right side of all its planes, inside a box.
#[derive(Clone, Debug)]
pub struct ConvexCell {
    bounds: Aabb,
    sides: Vec<HalfSpace>,
}

impl NodeCell {
    /// The cell of the node that an event visits, or that it tests a shape of; `None` if there is no such node.
    pub fn of_event(session: &Session, event: usize) -> Option<Self> {
        let step = visit_at(session, event)?;
        let visit = visit_of(session, step)?;
        let (accel, shapes) = (&session.world.accel, &session.world.scene.shapes);
        match accel.volume(shapes, visit.node) {
            Some(Volume::Box(bounds)) => return Some(Self::Convex(ConvexCell::of(bounds)?)),
            Some(Volume::Sphere { center, radius }) => return Some(Self::Sphere(center, radius)),
            None => {}
        }
        let mut cell = ConvexCell::of(accel.bounds()?)?;
        let (mut node, mut at) = (visit.node, step);
        while let Some(parent) = session.step_tree.parent(at) {
            let above = visit_of(session, parent)?;
            let view = accel.node(above.node)?;
            if let (Some((n, d)), Some([front, _])) = (view.plane, view.children) {
                // In front of the plane n.p is not less than d.
                cell.sides.push(if node == front {
                    HalfSpace { n: -n, d: -d }
                } else {
                    HalfSpace { n, d }
                });
            }
            (node, at) = (above.node, parent);
        }
        Some(Self::Convex(cell))
    }

    /// True for points inside, or no further outside than `tolerance`.
    pub fn contains(&self, p: DVec3, tolerance: f64) -> bool {
        match self {
            Self::Convex(cell) => {
                let inside = |side: &HalfSpace| side.n.dot(p) <= side.d + tolerance;
                cell.sides.iter().all(inside)
            }
            Self::Sphere(center, radius) => p.distance(*center) <= radius + tolerance,
        }
    }

    /// Its outline.
    pub fn outline(&self) -> ObjectOutline {
        match self {
            Self::Convex(cell) => {
                let faces = cell.sides.iter().map(|side| cell.section(side.n, side.d));
                ObjectOutline::Edges(faces.flatten().collect())
            }
            Self::Sphere(center, radius) => ObjectOutline::Sphere(*center, *radius),
        }
    }
}

impl ConvexCell {
    /// A box; `None` if it is empty or has no end.
    fn of(bounds: Aabb) -> Option<Self> {
        if bounds.is_empty() || !(bounds.min.is_finite() && bounds.max.is_finite()) {
            return None;
        }
        let along = |n: DVec3| {
            let high = HalfSpace {
                n,
                d: n.dot(bounds.max),
            };
            let low = HalfSpace {
                n: -n,
                d: -n.dot(bounds.min),
            };
            [high, low]
        };
        Some(Self {
            bounds,
            sides: DVec3::AXES.into_iter().flat_map(along).collect(),
        })
    }

    /// The edges of the polygon in which the plane n.p = d cuts the cell: a square around all of the cell in the plane,
    /// cut by every side.
    fn section(&self, n: DVec3, d: f64) -> Vec<[DVec3; 2]> {
        let size = self.bounds.size().length();
        let middle = self.bounds.center();
        let middle = middle - n * (n.dot(middle) - d);
        let frame = Frame::around(n);
        let (u, v) = (frame.u * size, frame.v * size);
        let square = vec![
            middle + u + v,
            middle - u + v,
            middle - u - v,
            middle + u - v,
        ];
        let cut = |polygon: Vec<DVec3>, side: &HalfSpace| clip(&polygon, side, ON * size);
        let polygon = self.sides.iter().fold(square, cut);
        let next = polygon.iter().cycle().skip(1);
        polygon.iter().zip(next).map(|(a, b)| [*a, *b]).collect()
    }
}

/// The polygon in which the split plane of the node that an event visits cuts the node's cell: its edges.
pub fn split(session: &Session, event: usize) -> Vec<[DVec3; 2]> {
    let visit = visit_at(session, event).and_then(|step| visit_of(session, step));
    let entered = visit.filter(|visit| !visit.is_skipped());
    let plane = entered.and_then(|visit| session.world.accel.plane(visit.node));
    match (plane, NodeCell::of_event(session, event)) {
        (Some((n, d)), Some(NodeCell::Convex(cell))) => cell.section(n, d),
        _ => Vec::new(),
    }
}

/// The part of a convex polygon on one side of a plane. Source: Sutherland and Hodgman 1974.
fn clip(polygon: &[DVec3], side: &HalfSpace, on: f64) -> Vec<DVec3> {
    let height = |p: DVec3| side.n.dot(p) - side.d;
    let next = polygon.iter().cycle().skip(1);
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (a, b) in polygon.iter().zip(next) {
        let (from, to) = (height(*a), height(*b));
        if from <= on {
            part.push(*a);
        }
        if (from <= on) != (to <= on) {
            part.push(*a + (*b - *a) * ((on - from) / (to - from)));
        }
    }
    part
}

/// The step at which the node is visited that an event is about: its own, or the one that a test stands below.
fn visit_at(session: &Session, event: usize) -> Option<usize> {
    let step = session.step_number(event)?;
    match visit_of(session, step) {
        Some(_) => Some(step),
        None => session.step_tree.parent(step),
    }
}

fn visit_of(session: &Session, step: usize) -> Option<&Visit> {
    match session.tree().events.get(session.steps().start + step)? {
        Event::Visit(visit) => Some(visit),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box that is cut by a plane across its corner has a triangle more, and a plane beside it cuts nothing.
    #[test]
    fn planes_cut_a_box() {
        let unit = Aabb {
            min: DVec3::ZERO,
            max: DVec3::ONE,
        };
        let mut cell = ConvexCell::of(unit).expect("not empty");
        let edges = |cell: &ConvexCell| match NodeCell::Convex(cell.clone()).outline() {
            ObjectOutline::Edges(edges) => edges.len(),
            _ => 0,
        };
        assert_eq!(edges(&cell), 24, "each edge once for both its sides");
        let n = DVec3::ONE.normalize();
        let across = cell.section(n, 0.5 * n.x);
        assert_eq!(across.len(), 3);
        for [a, _] in &across {
            assert!((a.element_sum() - 0.5).abs() < 1e-6, "{a}");
        }
        // Through the middle, at right angles to the diagonal: a hexagon.
        assert_eq!(cell.section(n, 1.5 * n.x).len(), 6);
        assert!(cell.section(n, 3.5 * n.x).is_empty());
        cell.sides.push(HalfSpace { n, d: 2.5 * n.x });
        assert_eq!(edges(&cell), 30, "three more edges, each twice");
        let cell = NodeCell::Convex(cell);
        assert!(cell.contains(DVec3::splat(0.8), 0.0));
        assert!(!cell.contains(DVec3::splat(0.9), 0.0));
        assert!(ConvexCell::of(Aabb::EMPTY).is_none());
    }
}
