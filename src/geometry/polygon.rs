//! The flat polygon: convex or not, with holes.
//!
//! Walk from the ray to infinity and count the edges on the way: an odd number of them means inside. The edges are asked as
//! those of triangles are, so polygons and triangles that share an edge meet without gap and without overlap.

use super::edge::edge;
use super::{Aabb, Intersection, Shear, SurfacePoint};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Frame, Interval, Ray};

/// The part of a plane inside of loops of corners: what an odd number of them is around. Outwards is the side from which the
/// first loop runs counter-clockwise.
///
/// u and v are metres along two axes of the plane, counted from the first corner.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// The corners of all loops, one after the other.
    corners: Vec<DVec3>,
    /// Where each loop ends in `corners`. The first is the rim, the others are holes.
    ends: Vec<u32>,
    /// The mean of the corners, and two axes and the unit normal of the plane.
    center: DVec3,
    frame: Frame,
    /// The largest coordinate of a corner.
    max_coordinate: f64,
}

/// What a ray meets on its walk to infinity through the plane of a polygon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EdgeWalk {
    /// Edges that are crossed: inside if it is odd.
    pub crossed: u32,
    /// How often the loops run around the ray, counter-clockwise as the ray sees them.
    pub winding: i32,
}

impl EdgeWalk {
    /// True if the ray passes inside.
    pub fn is_inside(self) -> bool {
        self.crossed % 2 == 1
    }
}

impl Polygon {
    /// The polygon of some loops, the rim first. `None` if the rim has no area, so that it has no normal.
    pub fn new(loops: &[Vec<DVec3>]) -> Option<Self> {
        let normal = newell(loops.first()?)?;
        let corners: Vec<DVec3> = loops.iter().flatten().copied().collect();
        let ends = loops.iter().scan(0, |end, corners| {
            *end += corners.len() as u32;
            Some(*end)
        });
        Some(Self {
            ends: ends.collect(),
            center: corners.iter().sum::<DVec3>() / corners.len() as f64,
            frame: Frame::around(normal),
            max_coordinate: corners
                .iter()
                .fold(0.0, |most, c| c.abs().max_element().max(most)),
            corners,
        })
    }

    /// The loops of corners, the rim first.
    pub fn loops(&self) -> impl Iterator<Item = &[DVec3]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        let ends = starts.zip(&self.ends);
        ends.map(|(start, end)| &self.corners[start as usize..*end as usize])
    }

    /// The edges, each from a corner to the next of the same loop.
    pub fn edges(&self) -> impl Iterator<Item = [DVec3; 2]> {
        self.loops().flat_map(|corners| {
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).map(|(a, b)| [*a, *b])
        })
    }

    /// A point of the plane: the mean of the corners.
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// The unit normal.
    pub fn normal(&self) -> DVec3 {
        self.frame.w
    }

    /// The largest distance of a corner from the plane, in metres.
    pub fn deviation(&self) -> f64 {
        let off = |corner: &DVec3| self.normal().dot(*corner - self.center).abs();
        self.corners.iter().map(off).fold(0.0, f64::max)
    }

    /// True if all corners lie in the plane as far as rounding can tell: n.p is a sum of products within gamma_4, the normal one of
    /// products of differences, and the corners themselves may have been rounded when they were placed.
    pub fn is_planar(&self) -> bool {
        self.deviation() <= gamma(64) * self.normal().abs().dot(DVec3::splat(self.max_coordinate))
    }

    /// True if two edges of a loop cross each other between their ends.
    pub fn crosses_itself(&self) -> bool {
        let flat = |p: DVec3| {
            let local = p - self.center;
            DVec2::new(local.dot(self.frame.u), local.dot(self.frame.v))
        };
        let side = |a: DVec2, b: DVec2, p: DVec2| (b - a).perp_dot(p - a);
        let parts = |a, b, p, q| side(a, b, p) * side(a, b, q) < 0.0;
        self.loops().any(|corners| {
            let flat: Vec<DVec2> = corners.iter().map(|c| flat(*c)).collect();
            let edge = |i: usize| (flat[i], flat[(i + 1) % flat.len()]);
            let mut pairs = (0..flat.len()).flat_map(|i| (i + 2..flat.len()).map(move |j| (i, j)));
            pairs.any(|(i, j)| {
                let ((a, b), (p, q)) = (edge(i), edge(j));
                parts(a, b, p, q) && parts(p, q, a, b)
            })
        })
    }

    /// The area vector: the normal, as long as the rim's area less that of the holes.
    pub fn area_vector(&self) -> DVec3 {
        let n = self.normal();
        let mut areas = self.loops().map(|corners| n.dot(twice_area(corners)) / 2.0);
        let rim = areas.next().unwrap_or(0.0);
        // A hole takes away, whichever way it runs.
        n * areas.fold(rim, |area, hole| area - hole.abs())
    }

    /// The walk from the ray to infinity: along the plane's image in the ray's view, in the direction of x. The ray stands a hair
    /// below the x axis, as in the tie rule of [`edge`], so a corner on the axis is above it.
    pub fn walk(&self, shear: &Shear) -> EdgeWalk {
        let mut walk = EdgeWalk::default();
        for corners in self.loops() {
            let Some(last) = corners.last() else { continue };
            let mut p = shear.view(*last);
            for corner in corners {
                let q = shear.view(*corner);
                let (p_above, q_above) = (p.y >= 0.0, q.y >= 0.0);
                // The edge crosses the axis; beyond the ray if that is on the edge's left going up, on its right going down.
                if p_above != q_above && edge(p, q).1 == p_above {
                    walk.crossed += 1;
                    // The view is seen from its back: what runs clockwise in it runs counter-clockwise for the ray.
                    walk.winding += if q_above { -1 } else { 1 };
                }
                p = q;
            }
        }
        walk
    }

    /// The crossing t = n.(c - o) / (n.direction) with the plane, if the ray passes inside. A ray along the plane misses.
    #[inline(never)]
    pub fn intersect(&self, ray: &Ray, shear: &Shear, interval: Interval) -> Intersection {
        let n = self.normal();
        let t = n.dot(self.center - ray.origin) / n.dot(ray.direction);
        if t.is_finite() && self.walk(shear).is_inside() {
            Intersection::classify(t, [0.0; 3], interval)
        } else {
            Intersection::Miss
        }
    }

    /// Of a ray that crosses the polygon: true if it comes from the outside. As exact as the crossing itself.
    #[inline(never)]
    pub fn is_met_in_front(&self, shear: &Shear) -> bool {
        self.walk(shear).winding > 0
    }

    /// The point at `t`, pulled back into the plane. The bound covers what the next test may round, as of a disc.
    #[inline(never)]
    pub fn surface(&self, ray: &Ray, t: f64) -> SurfacePoint {
        let Frame { u, v, w } = self.frame;
        let at = ray.at(t);
        let point = at - w.dot(at - self.center) * w;
        let local = point - self.corners[0];
        SurfacePoint {
            point,
            error: DVec3::splat(gamma(64) * 2.0 * self.max_coordinate),
            normal: w,
            uv: DVec2::new(local.dot(u), local.dot(v)),
        }
    }

    /// The smallest box around the corners.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.corners.iter().copied())
    }
}

/// Twice the area vector of a loop: the sum of the cross products of neighbours, counted from the first corner so that no digits
/// are lost far from the origin.
fn twice_area(corners: &[DVec3]) -> DVec3 {
    let Some(&first) = corners.first() else {
        return DVec3::ZERO;
    };
    let pairs = corners.windows(2);
    pairs
        .map(|pair| (pair[0] - first).cross(pair[1] - first))
        .sum()
}

/// The unit normal of a loop, by Newell's sums: right for flat loops, convex or not, and defined for all others.
/// Source: Sutherland, Sproull and Schumacker 1974, "A characterization of ten hidden-surface algorithms".
pub fn newell(corners: &[DVec3]) -> Option<DVec3> {
    let size = Aabb::around(corners.iter().copied()).size().max_element();
    let scaled: Vec<DVec3> = corners.iter().map(|c| (*c - corners[0]) / size).collect();
    twice_area(&scaled).try_normalize()
}

#[cfg(test)]
mod tests;
