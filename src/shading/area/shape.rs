//! The shape of an area light, and a uniform point on it.

use std::f64::consts::PI;

use crate::geometry::{Aabb, Disc, Shape, Sphere, Triangle};
use crate::math::rounding::{gamma, offset_origin};
use crate::math::{DVec3, Frame};
use crate::sampling::warp;

/// What a point can be sampled on.
#[derive(Clone, Debug, PartialEq)]
pub enum AreaShape {
    /// A parallelogram.
    Parallelogram(Parallelogram),
    /// A disc.
    Disc(Disc),
    /// A sphere.
    Sphere(Sphere),
    /// Triangles, one of which is chosen in proportion to its area.
    Mesh(Vec<CdfTriangle>),
}

/// A corner, and the edges that leave it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parallelogram {
    pub(super) corner: DVec3,
    pub(super) edges: [DVec3; 2],
    /// Unit.
    pub(super) normal: DVec3,
}

/// A triangle of a mesh, with the mesh's cumulative area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CdfTriangle {
    pub(super) triangle: Triangle,
    /// Unit.
    pub(super) normal: DVec3,
    /// The area of the triangles before it and its own.
    cumulative_area: f64,
}

/// A point of a light.
pub(super) struct LightPoint {
    pub(super) at: DVec3,
    /// The unit normal there.
    pub(super) normal: DVec3,
    /// 1 / density: the area that it stands for. (For a sphere seen from outside less than the whole.)
    pub(super) area: f64,
}

impl LightPoint {
    /// The unit direction to it from `from`, and the length of a shadow ray, which must end before the light, or the
    /// light would stand in its own way. It ends as far off the surface as the next ray's origin would be, for the
    /// errors at both ends of the ray, and of the light's own corners, whose largest coordinate is `max_coordinate`.
    #[inline]
    pub(super) fn direction_from(&self, from: DVec3, max_coordinate: f64) -> Option<(DVec3, f64)> {
        let largest = self.at.abs().max(from.abs()).max_element();
        let error = DVec3::splat(gamma(128) * largest.max(max_coordinate));
        let end = offset_origin(self.at, error, self.normal, from - self.at);
        let to_light = end - from;
        Some((to_light.try_normalize()?, to_light.length()))
    }
}

impl AreaShape {
    /// The shape that `shapes` make together, with its area in square metres; `None` if one of them is unbounded or was
    /// stretched.
    pub(super) fn new(shapes: &[Shape]) -> Option<(Self, f64)> {
        Some(match shapes {
            [Shape::Sphere(sphere)] => {
                let area = 4.0 * PI * sphere.radius * sphere.radius;
                (Self::Sphere(*sphere), area)
            }
            [Shape::Disc(disc)] => (Self::Disc(**disc), PI * disc.radius * disc.radius),
            [Shape::Triangle(s), Shape::Triangle(t)] if is_parallelogram(s, t) => {
                let [a, b, c] = s.corners;
                // The halves are a b c and a c d: the edges leave b.
                let edges = [a - b, c - b];
                let across = edges[0].cross(edges[1]);
                let shape = Parallelogram {
                    corner: b,
                    edges,
                    normal: across.try_normalize()?,
                };
                (Self::Parallelogram(shape), across.length())
            }
            _ => mesh(shapes)?,
        })
    }

    /// The point that `u` and `v` choose, uniform on the shape's `area`; for a sphere, as it is seen from `from`.
    #[inline]
    pub(super) fn point(&self, area: f64, from: DVec3, [u, v]: [f64; 2]) -> Option<LightPoint> {
        let (at, normal) = match self {
            Self::Parallelogram(whole) => (
                whole.corner + u * whole.edges[0] + v * whole.edges[1],
                whole.normal,
            ),
            Self::Disc(disc) => {
                let warp::Polar { r, sin, cos } = warp::disc([u, v]);
                let at = disc.center + disc.radius * r * (cos * disc.frame.u + sin * disc.frame.v);
                (at, disc.frame.w)
            }
            Self::Mesh(triangles) => {
                // u chooses the triangle, by area, and what is left of it chooses the point in the triangle.
                let target = u * area;
                let number = triangles.partition_point(|t| t.cumulative_area <= target);
                let number = number.min(triangles.len() - 1);
                let before = number
                    .checked_sub(1)
                    .map_or(0.0, |n| triangles[n].cumulative_area);
                let chosen = &triangles[number];
                let rest = (target - before) / (chosen.cumulative_area - before);
                let [wa, wb, wc] = warp::triangle([rest.clamp(0.0, 1.0), v]);
                let [a, b, c] = chosen.triangle.corners;
                (a * wa + b * wb + c * wc, chosen.normal)
            }
            Self::Sphere(sphere) => return on_sphere(sphere, area, from, [u, v]),
        };
        Some(LightPoint { at, normal, area })
    }
}

/// A point that is uniform in the cone that the sphere fills, so that none falls on its far side; from inside, uniform on
/// its surface.
fn on_sphere(sphere: &Sphere, area: f64, from: DVec3, uv: [f64; 2]) -> Option<LightPoint> {
    let Sphere { center, radius } = *sphere;
    let to_center = center - from;
    let distance = to_center.length();
    if distance <= radius {
        let normal = warp::sphere(uv);
        let at = center + radius * normal;
        return Some(LightPoint { at, normal, area });
    }
    let sin2_max = (radius / distance) * (radius / distance);
    let seen = warp::visible_sphere(uv, sin2_max);
    let frame = Frame::around(-to_center / distance);
    let across = frame.u * seen.cos_turn + frame.v * seen.sin_turn;
    let normal = across * seen.sin_alpha + frame.w * seen.cos_alpha;
    let at = center + radius * normal;
    // The solid angle, as the area that this point stands for: dA = dw |p - q|^2 / cos'.
    let to_point = from - at;
    let cos_angle = normal.dot(to_point.try_normalize()?);
    let area = seen.solid_angle * to_point.length_squared() / cos_angle;
    (cos_angle > 0.0).then_some(LightPoint { at, normal, area })
}

/// True if b c d makes one parallelogram of a b c and a c d, as far as rounding lets one say.
fn is_parallelogram(s: &Triangle, t: &Triangle) -> bool {
    let ([a, b, c], [a2, c2, d]) = (s.corners, t.corners);
    let off = ((b - a) - (c - d)).abs().max_element();
    let coordinates = [a, b, c, d].map(|p| p.abs().max_element());
    a == a2 && c == c2 && off <= gamma(8) * coordinates.into_iter().fold(0.0, f64::max)
}

/// The triangles of a mesh and the sides of a box, with the sum of their areas.
fn mesh(shapes: &[Shape]) -> Option<(AreaShape, f64)> {
    let (mut triangles, mut sum) = (Vec::with_capacity(shapes.len()), 0.0);
    let mut add = |corners: [DVec3; 3]| {
        let [a, b, c] = corners;
        let triangle = Triangle { corners };
        let area = (b - a).cross(c - a).length() / 2.0;
        if area > 0.0
            && let Some(normal) = triangle.normal()
        {
            sum += area;
            triangles.push(CdfTriangle {
                triangle,
                normal,
                cumulative_area: sum,
            });
        }
    };
    for shape in shapes {
        match shape.plain() {
            Shape::Triangle(triangle) => add(triangle.corners),
            Shape::Cuboid(cuboid) => {
                let corners = cuboid.bounds.corners();
                for [a, b, c, d] in Aabb::SIDES {
                    add([corners[a], corners[b], corners[c]]);
                    add([corners[a], corners[c], corners[d]]);
                }
            }
            _ => return None,
        }
    }
    Some((AreaShape::Mesh(triangles), sum))
}
