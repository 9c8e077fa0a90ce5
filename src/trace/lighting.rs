//! Samples of a light at a recorded hit point, computed again with the tracer's own functions.

use super::View;
use crate::probe::RayKind;
use crate::shading::{LightSample, ShadingPoint};
use crate::tracer::light_sampler::{AreaSampler, LightSampler, PointSampler};
use crate::tracer::path_id::PathId;

impl View<'_> {
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
    fn path_id(self, node: u32) -> PathId {
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
