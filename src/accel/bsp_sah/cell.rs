//! Convex polyhedron as a list of faces: a cell, whose surface area the heuristic needs.

use crate::geometry::Aabb;
use crate::math::DVec3;

/// Coordinates are at most 1. What is thinner does not count as a part of a cell: planes are thicker than that.
const THIN: f64 = 1e-6;

/// A corner so close to a plane was made on it.
const ON: f64 = 1e-13;

/// A convex polyhedron.
#[derive(Clone, Debug)]
pub struct Cell {
    faces: Vec<Face>,
    area: f64,
}

/// A polygon whose corners run counter-clockwise seen from outside.
#[derive(Clone, Debug)]
struct Face {
    corners: Vec<DVec3>,
    /// Its area, as a vector along its normal.
    area: DVec3,
}

impl Cell {
    /// A box.
    pub fn of(bounds: &Aabb) -> Self {
        let corners = bounds.corners();
        let side = |ring: [usize; 4]| Face::new(ring.map(|i| corners[i]).to_vec());
        Self::new(Aabb::SIDES.map(side).to_vec())
    }

    fn new(faces: Vec<Face>) -> Self {
        let area = faces.iter().map(|face| face.area.length()).sum();
        Self { faces, area }
    }

    /// The areas of the parts in front of the plane n.p = d and behind it, as shares of the whole; `None` if the plane
    /// leaves the cell whole. The face that closes a part is not needed: the vector areas of a closed surface add up
    /// to zero, so it is what the others lack.
    pub fn shares(&self, n: DVec3, d: f64) -> Option<[f64; 2]> {
        let (mut areas, mut lacks) = ([0.0; 2], [DVec3::ZERO; 2]);
        let (mut lowest, mut highest) = (0.0f64, 0.0f64);
        for face in &self.faces {
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for corner in &face.corners {
                let height = n.dot(*corner) - d;
                (low, high) = (low.min(height), high.max(height));
            }
            (lowest, highest) = (lowest.min(low), highest.max(high));
            let front = if low >= 0.0 {
                face.area
            } else if high <= 0.0 {
                DVec3::ZERO
            } else {
                face.area_in_front(n, d)
            };
            for (side, part) in [front, face.area - front].into_iter().enumerate() {
                areas[side] += part.length();
                lacks[side] += part;
            }
        }
        let divides = lowest < -THIN && highest > THIN;
        divides.then(|| [0, 1].map(|side| (areas[side] + lacks[side].length()) / self.area))
    }

    /// The parts in front of the plane n.p = d and behind it.
    pub fn cut(&self, n: DVec3, d: f64) -> [Self; 2] {
        [(n, d), (-n, -d)].map(|(n, d)| {
            let cut = self.faces.iter().map(|face| face.in_front(n, d));
            let mut faces: Vec<Face> = cut.filter(|face| face.corners.len() > 2).collect();
            faces.extend(lid(&faces, n, d));
            Self::new(faces)
        })
    }
}

impl Face {
    fn new(corners: Vec<DVec3>) -> Self {
        let first = corners.first().copied().unwrap_or(DVec3::ZERO);
        let twice = |pair: &[DVec3]| (pair[0] - first).cross(pair[1] - first);
        let area = 0.5 * corners.windows(2).map(twice).sum::<DVec3>();
        Self { corners, area }
    }

    /// The part where n.p >= d.
    fn in_front(&self, n: DVec3, d: f64) -> Self {
        let mut corners = Vec::with_capacity(self.corners.len() + 1);
        self.clip(n, d, |corner| corners.push(corner));
        Self::new(corners)
    }

    /// The area of that part.
    fn area_in_front(&self, n: DVec3, d: f64) -> DVec3 {
        let (mut first, mut last, mut twice) = (None, DVec3::ZERO, DVec3::ZERO);
        self.clip(n, d, |corner| {
            let first = *first.get_or_insert(corner);
            twice += (last - first).cross(corner - first);
            last = corner;
        });
        0.5 * twice
    }

    /// Tells the corners of that part. Source: Sutherland and Hodgman 1974.
    fn clip(&self, n: DVec3, d: f64, mut tell: impl FnMut(DVec3)) {
        let height = |p: DVec3| n.dot(p) - d;
        let Some(&last) = self.corners.last() else {
            return;
        };
        let (mut p, mut s) = (last, height(last));
        for &q in &self.corners {
            let r = height(q);
            if s * r < 0.0 {
                tell(p + (s / (s - r)) * (q - p));
            }
            if r >= 0.0 {
                tell(q);
            }
            (p, s) = (q, r);
        }
    }
}

/// The face on the plane that closes the part in front of it: its corners are those of the other faces that lie on the
/// plane, in order around their middle.
fn lid(faces: &[Face], n: DVec3, d: f64) -> Option<Face> {
    let all = faces.iter().flat_map(|face| &face.corners);
    let on = |p: &&DVec3| (n.dot(**p) - d).abs() < ON;
    let corners: Vec<DVec3> = all.filter(on).copied().collect();
    if corners.len() < 3 {
        return None;
    }
    let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
    // Outwards is against the normal: around it from v to u.
    let (u, v) = n.any_orthonormal_pair();
    let right_handed = u.cross(v).dot(n) > 0.0;
    let (u, v) = if right_handed { (v, u) } else { (u, v) };
    let angle = |p: DVec3| libm::atan2((p - middle).dot(v), (p - middle).dot(u));
    let mut around: Vec<(f64, DVec3)> = corners.into_iter().map(|p| (angle(p), p)).collect();
    around.sort_by(|a, b| a.0.total_cmp(&b.0));
    Some(Face::new(around.into_iter().map(|(_, p)| p).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_of_a_cube_have_the_areas_known_on_paper() {
        let cube = Cell::of(&Aabb::around([DVec3::ZERO, DVec3::ONE]));
        assert!((cube.area - 6.0).abs() < 1e-15);
        let near = |a: Option<[f64; 2]>, b: [f64; 2]| {
            let a = a.expect("it is cut");
            assert!((a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-12, "{a:?}");
        };
        // A quarter off: boxes with 2 (3/4 + 3/4 + 1) and 2 (1/4 + 1/4 + 1).
        near(cube.shares(DVec3::X, 0.25), [5.0 / 6.0, 3.0 / 6.0]);
        // Along the diagonal of a face: each half has two triangles, two squares and the cut.
        let n = DVec3::new(1.0, 1.0, 0.0).normalize();
        let half = (3.0 + 2f64.sqrt()) / 6.0;
        near(cube.shares(n, 0.5f64.sqrt()), [half, half]);
        // A corner off: three half squares and an equilateral triangle with edges of sqrt 2.
        let n = DVec3::ONE.normalize();
        let corner = 1.5 + 3f64.sqrt() / 2.0;
        near(
            cube.shares(n, 1.0 / 3f64.sqrt()),
            [(4.5 + 3f64.sqrt() / 2.0) / 6.0, corner / 6.0],
        );
        assert!(cube.shares(DVec3::X, 0.0).is_none() && cube.shares(DVec3::X, 2.0).is_none());
    }

    #[test]
    fn cells_stay_closed_however_often_they_are_cut() {
        let mut cell = Cell::of(&Aabb::around([-DVec3::ONE, DVec3::ONE]));
        for i in 1..30 {
            let angle = 1.7 * f64::from(i);
            let n = DVec3::new(libm::cos(angle), libm::sin(angle), libm::sin(2.3 * angle));
            let n = n.normalize();
            let [front, back] = cell.cut(n, 0.8 / f64::from(i));
            for part in [&front, &back] {
                let sum: DVec3 = part.faces.iter().map(|f| f.area).sum();
                assert!(sum.length() < 1e-9, "{i}: {sum}");
            }
            cell = back;
        }
    }
}
