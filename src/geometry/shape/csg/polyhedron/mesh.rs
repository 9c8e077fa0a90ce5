//! The mesh that a convex polyhedron is made of: what it must be, and its planes.

use std::collections::HashMap;

use super::Face;
use crate::geometry::{Aabb, Triangle};
use crate::math::DVec3;
use crate::math::rounding::gamma;

/// A closed mesh that has a volume, relative to its middle.
pub(super) struct ConvexMesh {
    /// The middle of the box around it.
    pub center: DVec3,
    /// The box around it.
    pub bounds: Aabb,
    /// The distance of the farthest corner from the middle.
    pub radius: f64,
    /// The largest coordinate: corners were rounded to u times this.
    pub reach: f64,
    /// All corners, relative to the middle.
    corners: Vec<DVec3>,
    /// Its triangles, counter-clockwise as seen from outside, the largest first.
    triangles: Vec<Triangle>,
}

impl ConvexMesh {
    /// A mesh that is closed and not flat. Errors: see [`super::Polyhedron::new`].
    pub fn new(points: &[DVec3], triangles: &[[u32; 3]]) -> Result<Self, String> {
        let used = corners_of(points, triangles)?;
        check_closed(triangles)?;
        let bounds = Aabb::around(used.iter().copied());
        let center = bounds.center();
        let reach = bounds.min.abs().max(bounds.max.abs()).max_element();
        let corner = |i: u32| points[i as usize] - center;
        let mut triangles: Vec<[DVec3; 3]> = triangles.iter().map(|t| t.map(corner)).collect();
        // Six times the volume, below 0 if all triangles are wound the other way round, and twice the surface.
        let volume: f64 = triangles.iter().map(|[a, b, c]| a.cross(*b).dot(*c)).sum();
        let surface: f64 = triangles.iter().map(twice_area).sum();
        if volume.is_nan() || volume.abs() <= gamma(64) * reach * surface {
            return Err("is flat: a solid needs a volume".to_owned());
        }
        if volume < 0.0 {
            for corners in &mut triangles {
                corners.swap(1, 2);
            }
        }
        // Of a flat face the largest triangle knows the plane best.
        triangles.sort_by(|a, b| twice_area(b).total_cmp(&twice_area(a)));
        let corners: Vec<DVec3> = used.iter().map(|p| *p - center).collect();
        Ok(Self {
            center,
            bounds,
            radius: corners.iter().map(|p| p.length()).fold(0.0, f64::max),
            reach,
            corners,
            triangles: triangles
                .into_iter()
                .map(|corners| Triangle { corners })
                .collect(),
        })
    }

    /// The planes, each once. Errors: it is not convex.
    pub fn faces(&self) -> Result<Vec<Face>, String> {
        let mut faces: Vec<Face> = Vec::new();
        for triangle in &self.triangles {
            if self.corners.iter().any(|p| self.is_in_front(triangle, *p)) {
                return Err("is not convex: only convex meshes can be cut".to_owned());
            }
            // A triangle without area has no plane, and its neighbours do not need it.
            let Some(n) = triangle.normal() else {
                continue;
            };
            if !faces.iter().any(|face| self.lies_in(triangle, n, face)) {
                // Through the outermost corner: so no plane cuts a corner off, however thin its triangle.
                let along = self.corners.iter().map(|p| n.dot(*p));
                let d = along.fold(f64::NEG_INFINITY, f64::max);
                faces.push(Face { n, d });
            }
        }
        Ok(faces)
    }

    /// Whether a triangle with the normal `n` is a piece of this flat face.
    fn lies_in(&self, triangle: &Triangle, n: DVec3, face: &Face) -> bool {
        let off = triangle.corners.map(|p| (face.n.dot(p) - face.d).abs());
        face.n.dot(n) > 0.0 && off.iter().all(|off| *off <= gamma(64) * self.reach)
    }

    /// True if a corner lies in front of a triangle. Corners were rounded, by u of the largest coordinate each; six times the
    /// volume that a triangle and a corner span changes by that times the products of the edges.
    fn is_in_front(&self, triangle: &Triangle, corner: DVec3) -> bool {
        let [a, b, c] = triangle.corners;
        let (e, f, g) = (b - a, c - a, corner - a);
        let (le, lf, lg) = (e.length(), f.length(), g.length());
        e.cross(f).dot(g) > gamma(64) * self.reach * (le * lf + lf * lg + lg * le)
    }
}

fn twice_area([a, b, c]: &[DVec3; 3]) -> f64 {
    (*b - *a).cross(*c - *a).length()
}

/// The corners that are used, each once.
fn corners_of(points: &[DVec3], triangles: &[[u32; 3]]) -> Result<Vec<DVec3>, String> {
    let mut numbers: Vec<u32> = triangles.iter().flatten().copied().collect();
    numbers.sort_unstable();
    numbers.dedup();
    let corner = |i: &u32| match points.get(*i as usize) {
        None => Err(format!(
            "has a triangle with corner {i}, but only {} points",
            points.len()
        )),
        Some(p) if !p.is_finite() => Err(format!("has a point, number {i}, that is not finite")),
        Some(p) => Ok(*p),
    };
    let corners: Vec<DVec3> = numbers.iter().map(corner).collect::<Result<_, _>>()?;
    if corners.is_empty() {
        return Err("has no triangles".to_owned());
    }
    Ok(corners)
}

/// Each edge must be walked once by one triangle, and once the other way by its neighbour.
fn check_closed(triangles: &[[u32; 3]]) -> Result<(), String> {
    let mut walked: HashMap<(u32, u32), u32> = HashMap::new();
    let edges = || {
        triangles
            .iter()
            .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)])
    };
    for edge in edges() {
        *walked.entry(edge).or_default() += 1;
    }
    let is_alone = |&(a, b): &(u32, u32)| walked[&(a, b)] != 1 || walked.get(&(b, a)) != Some(&1);
    match edges().find(is_alone) {
        Some((a, b)) => Err(format!(
            "is not closed: the edge from point {a} to point {b} must have exactly two triangles, wound the same way round"
        )),
        None => Ok(()),
    }
}
