//! Area lights: their shadows are soft.
//!
//! A diffuse surface at p that sees a light of radiance Le sends back
//!
//! Kd/pi  x  integral over the light's area of  Le V cos cos' / |p - q|^2  dA(q)
//!
//! where cos is the cosine at p, cos' that at q, and V is 1 if nothing stands between them. Each sample is one point q:
//! a point light of intensity Le A cos' / (pi |p - q|^2), and the mean over the samples estimates the integral.
//! Source: Cook, Porter and Carpenter 1984, "Distributed ray tracing"; Shirley, Wang and Zimmerman 1996, "Monte Carlo
//! techniques for direct lighting calculations".

mod shape;

use std::f64::consts::PI;

use super::light_sample::{LightSample, MAX_ATTENUATION};
use super::projected::ProjectedPolygon;
use crate::geometry::{Aabb, Shape};
use crate::math::{DVec3, Rgb};
use crate::probe::ProjectedShare;
use shape::LightPoint;

pub use shape::{AreaShape, CdfTriangle, Parallelogram};

/// An area that shines from both sides, everywhere and in all directions alike.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    /// Le: the radiance that it sends out.
    pub radiance: Rgb,
    /// A: its area in square metres.
    pub area: f64,
    /// Its shape.
    pub shape: AreaShape,
    /// A box around it.
    pub bounds: Aabb,
    /// Its largest coordinate: the error of a hit on it is proportional to this.
    max_coordinate: f64,
}

impl Area {
    /// The light that these shapes make together; `None` if one of them is unbounded or was stretched, or if
    /// they have no area.
    pub fn new(shapes: &[Shape], radiance: Rgb) -> Option<Self> {
        let (shape, area) = AreaShape::new(shapes)?;
        let boxes = shapes.iter().filter_map(Shape::bounds);
        let bounds = boxes.fold(Aabb::EMPTY, Aabb::union);
        (area > 0.0 && area.is_finite()).then_some(Self {
            radiance,
            area,
            shape,
            bounds,
            max_coordinate: bounds.min.abs().max(bounds.max.abs()).max_element(),
        })
    }

    /// The sample of the light that `u` in [0, 1)^2 chooses, as `point` sees it: direction and distance, and what
    /// arrives from there if nothing occludes it. `None` if the light is seen from its edge there.
    #[inline]
    pub fn sample(&self, point: DVec3, u: [f64; 2]) -> Option<LightSample> {
        let chosen = self.shape.point(self.area, point, u)?;
        let (direction, distance) = chosen.direction_from(point, self.max_coordinate)?;
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

    /// The light's projected solid angle, as a matt surface at `point` with the unit `normal` sees it; `None` if the
    /// light is not one flat polygon, or too small or too low for that.
    pub fn projected(&self, point: DVec3, normal: DVec3) -> Option<ProjectedPolygon> {
        match &self.shape {
            AreaShape::Parallelogram(Parallelogram { corner, edges, .. }) => {
                let ([u, v], a) = (edges, corner);
                ProjectedPolygon::new(point, normal, &[*a, a + u, a + u + v, a + v])
            }
            AreaShape::Mesh(triangles) if triangles.len() == 1 => {
                ProjectedPolygon::new(point, normal, &triangles[0].triangle.corners)
            }
            AreaShape::Mesh(_) | AreaShape::Disc(_) | AreaShape::Sphere(_) => None,
        }
    }

    /// The sample of the light that `u` chooses uniformly in its projected solid angle P (`seen`), for a matt surface at
    /// `point` with the unit `normal`: each brings Le P / pi. Else as [`Area::sample`].
    pub fn sample_projected(
        &self,
        (point, normal): (DVec3, DVec3),
        seen: &ProjectedPolygon,
        u: [f64; 2],
    ) -> Option<LightSample> {
        let (corner, across) = match &self.shape {
            AreaShape::Parallelogram(whole) => (whole.corner, whole.normal),
            AreaShape::Mesh(triangles) => {
                let first = triangles.first()?;
                (first.triangle.corners[0], first.normal)
            }
            AreaShape::Disc(_) | AreaShape::Sphere(_) => return None,
        };
        // Where the direction meets the light's plane.
        let toward = seen.direction(u);
        let t = across.dot(corner - point) / across.dot(toward);
        let chosen = LightPoint {
            at: point + t * toward,
            normal: across,
            area: self.area,
        };
        let (direction, distance) = chosen.direction_from(point, self.max_coordinate)?;
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
}
