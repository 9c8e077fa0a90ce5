//! Classification against a plane: on which side an item lies, and cutting what lies on both.

use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;

/// A primitive, or the part of it that reaches into one cell of the tree.
#[derive(Clone, Debug)]
pub struct Item {
    /// The whole primitive.
    pub primitive: u32,
    /// A box around the part.
    pub bounds: Aabb,
    /// The corners of a triangle's part, which is convex. Empty for shapes that go by their bounds.
    pub corners: Vec<DVec3>,
}

/// Where something lies, as seen from a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneSide {
    /// On it, within its tolerance.
    On,
    /// Where its normal points, or on it.
    Front,
    /// The other side, or on it.
    Back,
    /// On both sides, or it cannot be told.
    Both,
}

/// A plane that may part a cell: the points p with n.p = d.
#[derive(Clone, Copy, Debug)]
pub struct Splitter {
    /// Its unit normal.
    pub normal: DVec3,
    /// Its axis, if it is along one.
    pub axis: Option<usize>,
    /// Its distance from the world's origin.
    pub d: f64,
    /// Points closer than this are on it. Along an axis nothing is rounded, and it is 0.
    pub tolerance: f64,
    /// The primitive that it is the plane of: on it, whatever was rounded.
    pub source: Option<u32>,
}

impl Item {
    /// A whole primitive; `None` if it has no end.
    pub fn whole(primitive: u32, shape: &Shape) -> Option<Self> {
        let bounds = shape.bounds()?;
        let corners = match shape {
            Shape::Triangle(triangle) => triangle.corners.to_vec(),
            _ => Vec::new(),
        };
        Some(Self {
            primitive,
            bounds,
            corners,
        })
    }

    /// The part with these corners.
    fn part(&self, corners: Vec<DVec3>) -> Self {
        Self {
            primitive: self.primitive,
            bounds: Aabb::around(corners.iter().copied()),
            corners,
        }
    }
}

impl Splitter {
    /// The plane where the coordinate of `axis` is `d`.
    pub fn along(axis: usize, d: f64) -> Self {
        Self {
            normal: DVec3::AXES[axis],
            axis: Some(axis),
            d,
            tolerance: 0.0,
            source: None,
        }
    }

    /// The plane of a triangle; `None` if its corners do not give one that they all lie on.
    pub fn of_triangle(primitive: u32, shape: &Shape, tolerance: f64) -> Option<Self> {
        let Shape::Triangle(triangle) = shape else {
            return None;
        };
        let normal = triangle.normal()?;
        let plane = Self {
            normal,
            axis: None,
            d: normal.dot(triangle.corners[0]),
            tolerance,
            source: Some(primitive),
        };
        (plane.side_of(&triangle.corners) == PlaneSide::On).then_some(plane)
    }

    /// The distance of a point, with sign.
    pub fn distance(&self, p: DVec3) -> f64 {
        match self.axis {
            Some(axis) => p[axis] - self.d,
            None => self.normal.dot(p) - self.d,
        }
    }

    /// Where an item lies. By its bounds it may seem to be on both sides when it is not: that is allowed.
    pub fn side(&self, item: &Item) -> PlaneSide {
        if self.source == Some(item.primitive) {
            return PlaneSide::On;
        }
        match (self.axis, item.corners.is_empty()) {
            // The corners' extent along an axis is that of the bounds.
            (Some(axis), _) => {
                let (min, max) = (item.bounds.min[axis], item.bounds.max[axis]);
                Self::decide(min >= self.d, max <= self.d)
            }
            (None, false) => self.side_of(&item.corners),
            (None, true) => self.side_of(&item.bounds.corners()),
        }
    }

    /// Where the hull of some points lies. NaN is on both sides.
    fn side_of(&self, points: &[DVec3]) -> PlaneSide {
        let (mut front, mut back) = (true, true);
        for &p in points {
            let s = self.distance(p);
            front &= s >= -self.tolerance;
            back &= s <= self.tolerance;
        }
        Self::decide(front, back)
    }

    fn decide(front: bool, back: bool) -> PlaneSide {
        match (front, back) {
            (true, true) => PlaneSide::On,
            (true, false) => PlaneSide::Front,
            (false, true) => PlaneSide::Back,
            (false, false) => PlaneSide::Both,
        }
    }

    /// The parts of an item in front of the plane and behind it.
    pub fn cut(&self, item: Item) -> [Item; 2] {
        if item.corners.is_empty() {
            return self.cut_box(item);
        }
        let [front, back] = self.cut_polygon(&item.corners);
        [item.part(front), item.part(back)]
    }

    /// A box is cut by planes along the axes, and left whole by others.
    fn cut_box(&self, item: Item) -> [Item; 2] {
        let (mut front, mut back) = (item.clone(), item);
        if let Some(axis) = self.axis {
            front.bounds.min[axis] = self.d;
            back.bounds.max[axis] = self.d;
        }
        [front, back]
    }

    /// The corners in front and behind. What lies on the plane belongs to both; where an edge crosses it there is a
    /// new corner, on the plane because it was made there. Source: Sutherland and Hodgman 1974.
    fn cut_polygon(&self, corners: &[DVec3]) -> [Vec<DVec3>; 2] {
        let room = corners.len() + 1;
        let (mut front, mut back) = (Vec::with_capacity(room), Vec::with_capacity(room));
        let Some(&last) = corners.last() else {
            return [front, back];
        };
        let (mut p, mut s) = (last, self.distance(last));
        for &q in corners {
            let r = self.distance(q);
            if s.min(r) < -self.tolerance && s.max(r) > self.tolerance {
                let crossing = self.crossing((p, s), (q, r));
                front.push(crossing);
                back.push(crossing);
            }
            if r >= -self.tolerance {
                front.push(q);
            }
            if r <= self.tolerance {
                back.push(q);
            }
            (p, s) = (q, r);
        }
        [front, back]
    }

    /// Where the edge between two points crosses, given their distances. Computed in an order that does not depend
    /// on the edge's direction, so that neighbours get the same corner.
    fn crossing(&self, a: (DVec3, f64), b: (DVec3, f64)) -> DVec3 {
        let ((p, s), (q, r)) = if a.1 < b.1 { (a, b) } else { (b, a) };
        let mut point = p + (s / (s - r)) * (q - p);
        if let Some(axis) = self.axis {
            point[axis] = self.d;
        }
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Triangle;

    fn shape(corners: [[f64; 3]; 3]) -> Shape {
        let corners = corners.map(DVec3::from);
        Shape::Triangle(Triangle { corners })
    }

    fn item(corners: [[f64; 3]; 3]) -> Item {
        Item::whole(0, &shape(corners)).expect("it has an end")
    }

    /// Twice the area of a convex polygon.
    fn area(corners: &[DVec3]) -> f64 {
        let from = |p: &DVec3| *p - corners[0];
        corners
            .windows(2)
            .map(|w| from(&w[0]).cross(from(&w[1])))
            .sum::<DVec3>()
            .length()
    }

    #[test]
    fn touching_is_not_crossing() {
        let plane = Splitter::along(0, 1.0);
        let at = |x: [f64; 3]| plane.side(&item([[x[0], 0., 0.], [x[1], 1., 0.], [x[2], 0., 1.]]));
        assert_eq!(at([1.0, 1.0, 1.0]), PlaneSide::On);
        assert_eq!(at([1.0, 1.0, 2.0]), PlaneSide::Front);
        assert_eq!(at([0.0, 0.5, 1.0]), PlaneSide::Back);
        assert_eq!(at([0.0, 1.0, 1.0f64.next_up()]), PlaneSide::Both);
    }

    #[test]
    fn a_triangle_lies_on_its_own_plane_and_its_neighbour_does_not_cross_it() {
        let own = [[0.1, 0.2, 0.3], [1.7, 0.4, 0.9], [0.3, 1.1, -0.7]];
        let plane = Splitter::of_triangle(7, &shape(own), 1e-15).expect("it has area");
        assert_eq!(plane.side(&item(own)), PlaneSide::On);
        let above = [own[0], own[1], [0.1, 0.2, 5.0]];
        assert_ne!(plane.side(&item(above)), PlaneSide::Both);
        assert!(Splitter::of_triangle(7, &shape([own[0], own[0], own[1]]), 1e-15).is_none());
    }

    #[test]
    fn the_parts_have_the_area_of_the_whole_and_lie_on_their_sides() {
        let whole = item([[0.1, 0.2, 0.3], [1.7, 0.4, 0.9], [0.3, 1.1, -0.7]]);
        let normal = DVec3::new(2.0, -3.0, 1.0).normalize();
        let skew = Splitter {
            normal,
            axis: None,
            d: 0.1,
            tolerance: 1e-15,
            source: None,
        };
        for plane in [Splitter::along(0, 0.9), Splitter::along(2, 0.0), skew] {
            assert_eq!(plane.side(&whole), PlaneSide::Both);
            let [front, back] = plane.cut(whole.clone());
            assert_eq!(plane.side(&front), PlaneSide::Front);
            assert_eq!(plane.side(&back), PlaneSide::Back);
            let sum = area(&front.corners) + area(&back.corners);
            let expected = area(&whole.corners);
            assert!((sum - expected).abs() < 1e-12 * expected);
        }
    }
}
