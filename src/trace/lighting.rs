//! Samples of a light at a recorded hit point, computed again with the tracer's own functions.

use std::f64::consts::PI;

use super::View;
use crate::math::{DVec3, Rgb};
use crate::probe::RayKind;
use crate::shading::{LightSample, ShadingPoint};
use crate::tracer::light_sampler::{AreaSampler, LightSampler, PointSampler};
use crate::tracer::path_id::PathId;

/// The point of an area light that a shadow ray asks for, and what it would send: I = Le A cos' / (pi r^2 N).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AskedPoint {
    /// Where it is, in world space.
    pub point: DVec3,
    /// Le, the radiance of the light.
    pub radiance: Rgb,
    /// A, the area among whose points it was chosen, in square metres: that of the light, or of the part of a sphere that can be
    /// seen.
    pub area: f64,
    /// cos', the cosine between the light's normal and the way to the surface.
    pub cosine: f64,
    /// r, the distance from the surface, in metres.
    pub distance: f64,
    /// N, the number of points.
    pub samples: u32,
}

impl View<'_> {
    /// The point of an area light that sample number `sample` at the hit of a node asks for; none for other lights, and where points
    /// are chosen by what they bring.
    pub fn asked_point(self, node: u32, (light, sample): (u32, u32)) -> Option<AskedPoint> {
        let area = self.world.scene.lights.get(light as usize)?.kind.area()?;
        let seen = self.light_sample(node, (light, sample))?;
        if seen.projected.is_some() || seen.cos_angle <= 0.0 {
            return None;
        }
        let (r, hit) = (seen.distance, self.surface_hit(node)?);
        Some(AskedPoint {
            point: hit.at.point + r * seen.direction,
            radiance: area.radiance,
            // The sampler's factor is A cos' / (pi r^2).
            area: seen.attenuation * PI * r * r / seen.cos_angle,
            cosine: seen.cos_angle,
            distance: r,
            samples: self.settings.rays_to_area(),
        })
    }

    /// A sample of a light at the hit of a node; `None` if the light stands just there.
    pub fn light_sample(self, node: u32, (light, sample): (u32, u32)) -> Option<LightSample> {
        let scene = &self.world.scene;
        let kind = &scene.lights.get(light as usize)?.kind;
        let hit = self.surface_hit(node)?;
        let point = ShadingPoint::new(&hit.at, hit.material, self.settings.effects);
        let id = (self.path_id(node), light);
        match kind.area() {
            Some(area) => AreaSampler::new(self.settings, &point, area, id).light(sample),
            None => PointSampler::new(self.settings, &point, kind).light(sample),
        }
    }

    /// P, the projected solid angle of a light at the hit of a node, if its samples are chosen by that.
    pub fn projected_solid_angle(self, node: u32, light: u32) -> Option<f64> {
        let scene = &self.world.scene;
        let area = scene.lights.get(light as usize)?.kind.area()?;
        let hit = self.surface_hit(node)?;
        let point = ShadingPoint::new(&hit.at, hit.material, self.settings.effects);
        let id = (self.path_id(node), light);
        AreaSampler::new(self.settings, &point, area, id).projected_solid_angle()
    }

    /// The key of a node's points on area lights: its pixel, its sample and its path from the eye.
    pub(super) fn path_id(self, node: u32) -> PathId {
        let tree = &self.trace.tree;
        let mut path = Vec::new();
        let mut here = tree.node(node);
        while let Some(parent) = here.parent {
            path.push(here.ray.kind == RayKind::Transmitted);
            here = tree.node(parent);
        }
        let sample = tree.sample_of_node(node).map_or(0, |s| s.index);
        let eye = PathId::eye((self.trace.x, self.trace.y), sample);
        path.into_iter().rev().fold(eye, PathId::then)
    }
}
