//! Lights with an area: their shadows are soft.
//!
//! A diffuse surface at p that sees a light of radiance Le sends back
//!
//! Kd/pi  x  integral over the light's area of  Le V cos cos' / |p - q|^2  dA(q)
//!
//! where cos is the cosine at p, cos' that at q, and V is 1 if nothing stands between them. Each sample is one point q:
//! a point light of intensity Le A cos' / (pi |p - q|^2), and the mean over the samples estimates the integral.
//! Source: Cook, Porter and Carpenter 1984, "Distributed ray tracing"; Shirley, Wang and Zimmerman 1996, "Monte Carlo
//! techniques for direct lighting calculations".

use std::f64::consts::{PI, TAU};

use super::light_sample::{LightSample, MAX_ATTENUATION};
use super::projected::Projected;
use crate::geometry::{Aabb, Disc, Shape, Sphere, Triangle};
use crate::math::rounding::{gamma, offset_origin};
use crate::math::{DVec3, Frame, Rgb};
use crate::probe::ProjectedShare;

/// An area that shines from both sides, everywhere and in all directions alike.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    /// Le: the radiance that it sends out.
    pub radiance: Rgb,
    /// A: its area in square metres.
    pub area: f64,
    /// Its form.
    pub form: Form,
    /// Its largest coordinate: where a ray meets it is known to a part of this.
    reach: f64,
}

/// What a point can be chosen on.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A parallelogram.
    Parallelogram(Parallelogram),
    /// A disc.
    Disc(Disc),
    /// A sphere.
    Sphere(Sphere),
    /// Triangles.
    Mesh(Vec<Piece>),
}

/// A corner, and the edges that leave it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parallelogram {
    corner: DVec3,
    edges: [DVec3; 2],
    /// Unit.
    normal: DVec3,
}

/// One of many triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    triangle: Triangle,
    /// Unit.
    normal: DVec3,
    /// The area of those before it and its own.
    sum: f64,
}

/// A point of a light.
struct Point {
    at: DVec3,
    /// The unit normal there.
    normal: DVec3,
    /// 1 / density: the area that it stands for. (For a sphere seen from outside less than the whole.)
    area: f64,
}

impl Point {
    /// The unit direction to it from `from`, and how far a shadow ray has to go. The ray's end must lie before the
    /// light, or the light would stand in its own way: it is as far off the surface as the next ray's origin would be,
    /// for the errors at both ends of the ray, and of the light's own corners, which may be far from both.
    #[inline]
    fn way_from(&self, from: DVec3, reach: f64) -> Option<(DVec3, f64)> {
        let reach = self.at.abs().max(from.abs()).max_element().max(reach);
        let error = DVec3::splat(gamma(128) * reach);
        let end = offset_origin(self.at, error, self.normal, from - self.at);
        let to_light = end - from;
        Some((to_light.try_normalize()?, to_light.length()))
    }
}

impl Area {
    /// The light that these shapes make together; `None` if one of them has no end or was stretched, or if they have
    /// no area.
    pub fn new(shapes: &[Shape], radiance: Rgb) -> Option<Self> {
        let (form, area) = match shapes {
            [Shape::Sphere(sphere)] => {
                let area = 4.0 * PI * sphere.radius * sphere.radius;
                (Form::Sphere(*sphere), area)
            }
            [Shape::Disc(disc)] => (Form::Disc(**disc), PI * disc.radius * disc.radius),
            [Shape::Triangle(s), Shape::Triangle(t)] if parallelogram(s, t) => {
                let [a, b, c] = s.corners;
                // The halves are a b c and a c d: the edges leave b.
                let edges = [a - b, c - b];
                let across = edges[0].cross(edges[1]);
                let form = Parallelogram {
                    corner: b,
                    edges,
                    normal: across.try_normalize()?,
                };
                (Form::Parallelogram(form), across.length())
            }
            _ => mesh(shapes)?,
        };
        let reach = shapes
            .iter()
            .filter_map(Shape::bounds)
            .fold(0.0, |reach: f64, bounds| {
                reach.max(bounds.min.abs().max(bounds.max.abs()).max_element())
            });
        (area > 0.0 && area.is_finite()).then_some(Self {
            radiance,
            area,
            form,
            reach,
        })
    }

    /// The light as `point` sees it at the place that `u` in [0, 1)^2 chooses: direction and distance to that place,
    /// and what arrives from there if nothing stands between, as a share of the mean. `None` if the light is seen from
    /// its edge there.
    #[inline]
    pub fn sample(&self, point: DVec3, u: [f64; 2]) -> Option<LightSample> {
        let chosen = self.point(point, u)?;
        let (direction, distance) = chosen.way_from(point, self.reach)?;
        let cos_angle = chosen.normal.dot(direction).abs();
        let squared = (point - chosen.at).length_squared();
        let attenuation = chosen.area * cos_angle / (PI * squared);
        (cos_angle > 0.0 && attenuation <= MAX_ATTENUATION).then_some(LightSample {
            direction,
            distance,
            attenuation,
            cos_angle,
            intensity: self.radiance * attenuation,
            projected: None,
        })
    }

    /// The light as a matt surface at `point` with the unit `normal` sees it, if it is one flat polygon and neither
    /// too small nor too low for that.
    pub fn projected(&self, point: DVec3, normal: DVec3) -> Option<Projected> {
        match &self.form {
            Form::Parallelogram(Parallelogram { corner, edges, .. }) => {
                let ([u, v], a) = (edges, corner);
                Projected::new(point, normal, &[*a, a + u, a + u + v, a + v])
            }
            Form::Mesh(pieces) if pieces.len() == 1 => {
                Projected::new(point, normal, &pieces[0].triangle.corners)
            }
            Form::Mesh(_) | Form::Disc(_) | Form::Sphere(_) => None,
        }
    }

    /// The same as [`Area::sample`], but with a place that is chosen in proportion to what it brings to a matt surface
    /// at `point` with the unit `normal`: Le P / pi in all, with the projected solid angle P.
    pub fn sample_projected(
        &self,
        (point, normal): (DVec3, DVec3),
        seen: &Projected,
        u: [f64; 2],
    ) -> Option<LightSample> {
        let (corner, across) = match &self.form {
            Form::Parallelogram(whole) => (whole.corner, whole.normal),
            Form::Mesh(pieces) => {
                let piece = pieces.first()?;
                (piece.triangle.corners[0], piece.normal)
            }
            Form::Disc(_) | Form::Sphere(_) => return None,
        };
        // Where the way meets the light's plane.
        let way = seen.direction(u);
        let t = across.dot(corner - point) / across.dot(way);
        let chosen = Point {
            at: point + t * way,
            normal: across,
            area: self.area,
        };
        let (direction, distance) = chosen.way_from(point, self.reach)?;
        let n_dot_l = normal.dot(direction);
        let attenuation = seen.area / (PI * n_dot_l);
        (t > 0.0 && n_dot_l > 0.0 && attenuation.is_finite()).then_some(LightSample {
            direction,
            distance,
            attenuation,
            cos_angle: across.dot(direction).abs(),
            intensity: self.radiance * attenuation,
            projected: Some(ProjectedShare {
                radiance: self.radiance,
                solid_angle: seen.area,
                share: 1.0,
            }),
        })
    }

    /// A point of the light.
    #[inline]
    fn point(&self, from: DVec3, [u, v]: [f64; 2]) -> Option<Point> {
        match &self.form {
            Form::Parallelogram(whole) => Some(Point {
                at: whole.corner + u * whole.edges[0] + v * whole.edges[1],
                normal: whole.normal,
                area: self.area,
            }),
            Form::Disc(disc) => Some(Point {
                at: on_disc(disc, [u, v]),
                normal: disc.frame.w,
                area: self.area,
            }),
            Form::Mesh(pieces) => {
                // u chooses the triangle, by area, and then what is left of it a place in the triangle.
                let target = u * self.area;
                let number = pieces.partition_point(|piece| piece.sum <= target);
                let number = number.min(pieces.len() - 1);
                let before = number.checked_sub(1).map_or(0.0, |n| pieces[n].sum);
                let piece = &pieces[number];
                let rest = ((target - before) / (piece.sum - before)).clamp(0.0, 1.0);
                Some(Point {
                    at: in_triangle(&piece.triangle, rest, v),
                    normal: piece.normal,
                    area: self.area,
                })
            }
            Form::Sphere(sphere) => on_sphere(sphere, self.area, from, [u, v]),
        }
    }
}

/// Even in the triangle: the root spreads what would crowd at corner a.
/// Source: Turk 1990, "Generating random points in triangles", Graphics Gems.
fn in_triangle(triangle: &Triangle, u: f64, v: f64) -> DVec3 {
    let [a, b, c] = triangle.corners;
    let root = u.sqrt();
    a * (1.0 - root) + b * (root * (1.0 - v)) + c * (root * v)
}

/// Even on the disc: the square's rings of equal area become rings of equal area, and neighbours stay neighbours, so that
/// what was spread evenly stays so. Source: Shirley and Chiu 1997, "A low distortion map between disk and square".
fn on_disc(disc: &Disc, [u, v]: [f64; 2]) -> DVec3 {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    // The ring is told by the larger coordinate, the place on it by the smaller one: an eighth turn a triangle.
    let (r, turn) = if x == 0.0 && y == 0.0 {
        (0.0, 0.0)
    } else if x.abs() > y.abs() {
        (x, y / x / 8.0)
    } else {
        (y, 0.25 - x / y / 8.0)
    };
    let (sin, cos) = libm::sincos(TAU * turn);
    disc.center + disc.radius * r * (cos * disc.frame.u + sin * disc.frame.v)
}

/// From outside, even in the cone that the sphere fills, so that no sample falls on its far side; from inside, even on
/// its surface. Source: Shirley, Wang and Zimmerman 1996; the cone near its axis without cancellation: PBR, 4th
/// edition, section 6.2.4.
fn on_sphere(sphere: &Sphere, area: f64, from: DVec3, [u, v]: [f64; 2]) -> Option<Point> {
    let Sphere { center, radius } = *sphere;
    let (sin_turn, cos_turn) = libm::sincos(TAU * v);
    let to_center = center - from;
    let distance = to_center.length();
    if distance <= radius {
        let z = 1.0 - 2.0 * u;
        let r = (1.0 - z * z).max(0.0).sqrt();
        let normal = DVec3::new(r * cos_turn, r * sin_turn, z);
        let at = center + radius * normal;
        return Some(Point { at, normal, area });
    }
    // cos of the cone's half angle, and one minus it: sin^2 / (1 + cos) keeps its digits for small spheres.
    let sin2_max = (radius / distance) * (radius / distance);
    let cos_max = (1.0 - sin2_max).sqrt();
    let one_minus_cos_max = sin2_max / (1.0 + cos_max);
    // The direction's angle from the axis, even in solid angle.
    let one_minus_cos = u * one_minus_cos_max;
    let sin2 = (one_minus_cos * (2.0 - one_minus_cos)).min(sin2_max);
    let cos = 1.0 - one_minus_cos;
    // Where it meets the sphere, as an angle seen from the centre (law of sines).
    let cos_alpha = sin2 / (sin2_max.sqrt()) + cos * (1.0 - sin2 / sin2_max).max(0.0).sqrt();
    let sin_alpha = (1.0 - cos_alpha * cos_alpha).max(0.0).sqrt();
    let frame = Frame::around(-to_center / distance);
    let normal = (frame.u * cos_turn + frame.v * sin_turn) * sin_alpha + frame.w * cos_alpha;
    let at = center + radius * normal;
    // The solid angle, as the area that this point stands for: dA = dw |p - q|^2 / cos'.
    let solid_angle = TAU * one_minus_cos_max;
    let to_point = from - at;
    let cos_angle = normal.dot(to_point.try_normalize()?);
    let area = solid_angle * to_point.length_squared() / cos_angle;
    (cos_angle > 0.0).then_some(Point { at, normal, area })
}

/// True if b c d makes one parallelogram of a b c and a c d, as far as rounding lets one say.
fn parallelogram(s: &Triangle, t: &Triangle) -> bool {
    let ([a, b, c], [a2, c2, d]) = (s.corners, t.corners);
    let off = ((b - a) - (c - d)).abs().max_element();
    let reach = [a, b, c, d].map(|p| p.abs().max_element());
    a == a2 && c == c2 && off <= gamma(8) * reach.into_iter().fold(0.0, f64::max)
}

/// The triangles of a mesh and the sides of a box, with the sum of their areas.
fn mesh(shapes: &[Shape]) -> Option<(Form, f64)> {
    let (mut pieces, mut sum) = (Vec::with_capacity(shapes.len()), 0.0);
    let mut add = |corners: [DVec3; 3]| {
        let [a, b, c] = corners;
        let triangle = Triangle { corners };
        let area = (b - a).cross(c - a).length() / 2.0;
        if area > 0.0
            && let Some(normal) = triangle.normal()
        {
            sum += area;
            pieces.push(Piece {
                triangle,
                normal,
                sum,
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
    Some((Form::Mesh(pieces), sum))
}
