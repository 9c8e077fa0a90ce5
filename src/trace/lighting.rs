//! Samples of a light at a recorded hit point, computed again with the tracer's own functions.

use super::View;
use crate::probe::RayKind;
use crate::shading::{LightSample, ShadingPoint};
use crate::tracer::light_sampler::LightSampler;
use crate::tracer::path_id::PathId;

impl View<'_> {
    /// A sample of a light at the hit of a node; `None` if the light stands just there.
    pub fn light_sample(self, node: u32, (light, sample): (u32, u32)) -> Option<LightSample> {
        self.with_sampler(node, light, |sampler| sampler.light(sample))
    }

    /// P, the projected solid angle of a light at the hit of a node, if its samples are chosen by that.
    #[allow(clippy::redundant_closure_for_method_calls)] // The method's lifetime is too narrow.
    pub fn projected_solid_angle(self, node: u32, light: u32) -> Option<f64> {
        self.with_sampler(node, light, |sampler| sampler.projected_solid_angle())
    }

    /// Asks the sampler of a light at the hit of a node.
    fn with_sampler<T>(
        self,
        node: u32,
        light: u32,
        ask: impl FnOnce(&LightSampler) -> Option<T>,
    ) -> Option<T> {
        let scene = &self.world.scene;
        scene.lights.get(light as usize)?;
        let hit = self.surface_hit(node)?;
        let point = ShadingPoint::new(&hit.at, hit.material, self.settings.effects);
        let id = (self.path_id(node), light);
        ask(&LightSampler::new(scene, self.settings, &point, id))
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
