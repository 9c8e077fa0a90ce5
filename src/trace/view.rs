//! A recorded pixel together with the world and the settings that it was traced in.

use super::PixelTrace;
use crate::math::Rgb;
use crate::probe::RayKind;
use crate::scene::Settings;
use crate::tracer::laws::Bent;
use crate::world::World;

/// All that is needed to explain a recorded pixel.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// The scene and its accelerator.
    pub world: &'a World,
    /// The settings.
    pub settings: &'a Settings,
    /// The recording.
    pub trace: &'a PixelTrace,
}

impl<'a> View<'a> {
    /// The laws that the pixel was traced by.
    pub fn laws(self) -> Bent {
        Bent(self.settings.bends)
    }

    /// True if a light has an area, so that many rays are sent to it.
    pub fn is_area(self, light: u32) -> bool {
        let light = self.world.scene.lights.get(light as usize);
        light.is_some_and(|l| l.kind.is_area())
    }

    /// The name of a light.
    pub fn light_name(self, light: u32) -> &'a str {
        let lights = &self.world.scene.lights;
        lights.get(light as usize).map_or("", |l| l.name.as_str())
    }

    /// The name of a light; of an area light with the number of a sample.
    pub fn light_label(self, (light, sample): (u32, u32)) -> String {
        let name = self.light_name(light);
        if self.is_area(light) {
            return format!("{name}, sample {sample}");
        }
        name.to_owned()
    }

    /// The part of the pixel's brightness that a node's subtree brings, 0 to 1; for an L ray, that of the terms it let
    /// through.
    pub fn fraction(self, node: u32) -> f64 {
        let weight = self.sample_weight(node);
        (self.contribution(node) * weight).fraction_of(self.trace.pixel.color)
    }

    /// The weight in the pixel's sum of the sample that a node belongs to.
    pub fn sample_weight(self, node: u32) -> f64 {
        let sample = self.trace.tree.sample_of_node(node);
        sample.map_or(1.0, |sample| sample.weight)
    }

    /// What a node's subtree adds to its sample: throughput x radiance; for an L ray the light's terms at its parent.
    pub fn contribution(self, node: u32) -> Rgb {
        let tree = &self.trace.tree;
        let this = tree.node(node);
        let (RayKind::Light, Some(parent)) = (this.ray.kind, this.parent) else {
            return this.total();
        };
        tree.node(parent).throughput * tree.lit_by(node)
    }
}
