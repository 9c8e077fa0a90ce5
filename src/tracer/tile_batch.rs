//! Tile batch: the eye rays of a tile's pixels, and the shadow rays from their hit points, traced in packets.
//!
//! Neighbouring eye rays, and the shadow rays from where they hit to one light, run through the same part of the scene; an
//! accelerator that traces them together is several times as fast. The tracer stays one recursive function: it takes what was
//! prefetched instead of asking the accelerator, and the answer is the same to the last bit.

use super::light_sampler::{self, AreaSampler, PointSampler};
use super::pixel::{CameraSample, CameraSamples};
use super::shadow_batch::{Prefetched, ShadowBatch};
use crate::geometry::Hit;
use crate::math::{Interval, Ray};
use crate::scene::{Effect, Settings};
use crate::shading::{Area, Interaction, ShadingPoint};
use crate::world::World;

/// Shadow rays of a pixel that are prefetched at most; a light with more is sampled hit by hit. It bounds the memory.
const MOST_SHADOW_RAYS: u32 = 64;

/// Prefetched rays of one sample of each of some pixels; memory that is used again and again.
#[derive(Default)]
pub struct TileBatch {
    samples: Vec<CameraSample>,
    rays: Vec<(Ray, Interval)>,
    hits: Vec<Option<Hit>>,
    /// The hit points of `hits`.
    points: Vec<Option<Interaction>>,
    shadow: ShadowBatch,
    lights: Vec<PrefetchedLight>,
}

/// Shadow rays to one light, those of one pixel after those of another.
#[derive(Clone, Copy)]
struct PrefetchedLight {
    /// Index of the first.
    first: usize,
    /// Rays of each pixel; 0 if they are not prefetched.
    count: usize,
}

/// Prefetched rays of one pixel's sample.
#[derive(Clone, Copy)]
pub struct PixelBatch<'a> {
    batch: &'a TileBatch,
    index: usize,
}

impl TileBatch {
    /// Traces one sample of each of the `pixels`.
    pub fn trace(
        &mut self,
        world: &World,
        settings: &Settings,
        samples: &CameraSamples,
        pixels: impl Iterator<Item = (u32, u32)>,
    ) {
        let (scene, camera) = (&world.scene, &world.scene.camera);
        self.samples.clear();
        self.samples.extend(pixels.map(|pixel| samples.of(pixel)));
        self.rays.clear();
        self.rays.extend(self.samples.iter().map(|sample| {
            let ray = camera.ray(sample.film, settings.size());
            (ray, Interval::FORWARD)
        }));
        self.hits.clear();
        self.hits.resize(self.rays.len(), None);
        world
            .accel
            .closest_many(&scene.shapes, &self.rays, &mut self.hits);
        let rays_and_hits = self.rays.iter().zip(&self.hits);
        self.points.clear();
        self.points.extend(
            rays_and_hits
                .map(|((ray, _), hit)| Some(scene.interaction_for_shading(ray, hit.as_ref()?))),
        );
        self.trace_shadow_rays(world, settings);
    }

    /// Traces the shadow rays of all hit points, light by light.
    fn trace_shadow_rays(&mut self, world: &World, settings: &Settings) {
        self.shadow.clear();
        self.lights.clear();
        // Where a model is named N at a hit is not all that decides on its shadow rays.
        if !settings.effects.has(Effect::Shadows) || world.shades_by_model(settings) {
            return;
        }
        let (scene, mut left) = (&world.scene, MOST_SHADOW_RAYS);
        for (light, number) in scene.lights.iter().zip(0..) {
            let wanted = light_sampler::count(scene, settings, number);
            let count = if wanted <= left { wanted } else { 0 };
            left -= count;
            self.lights.push(PrefetchedLight {
                first: self.shadow.prefetched().len(),
                count: count as usize,
            });
            if count > 0 {
                self.sample_light(world, settings, number, count);
                self.shadow.trace(world, light.kind.is_area());
            }
        }
    }

    /// Samples a light at all hit points.
    fn sample_light(&mut self, world: &World, settings: &Settings, light: u32, count: u32) {
        match world.scene.lights[light as usize].kind.area() {
            Some(area) => self.sample_area(world, settings, (light, area), count),
            None => self.sample_point(world, settings, light),
        }
    }

    /// Samples a light without area: one ray from each hit point.
    fn sample_point(&mut self, world: &World, settings: &Settings, light: u32) {
        let scene = &world.scene;
        let kind = &scene.lights[light as usize].kind;
        for (hit, at) in self.hits.iter().zip(&self.points) {
            if let (Some(hit), Some(at)) = (hit, at) {
                let material = scene.material_at(hit);
                let (effects, mut flat) = (settings.effects, None);
                let at = scene.shaded((hit, at), effects, &mut flat);
                let point = ShadingPoint::new(at, material, effects);
                let sampler = PointSampler::new(settings, &point, kind);
                self.shadow.sample(&sampler, 1);
            } else {
                self.shadow.skip(1);
            }
        }
    }

    /// Samples a light with an area. (Never inlined, so that scenes without such lights pay nothing for it.)
    #[inline(never)]
    fn sample_area(
        &mut self,
        world: &World,
        settings: &Settings,
        (light, area): (u32, &Area),
        count: u32,
    ) {
        let scene = &world.scene;
        for ((sample, hit), at) in self.samples.iter().zip(&self.hits).zip(&self.points) {
            if let (Some(hit), Some(at)) = (hit, at) {
                let material = scene.material_at(hit);
                let (effects, mut flat) = (settings.effects, None);
                let at = scene.shaded((hit, at), effects, &mut flat);
                let point = ShadingPoint::new(at, material, effects);
                let sampler = AreaSampler::new(settings, &point, area, (sample.path, light));
                self.shadow.sample(&sampler, count);
            } else {
                self.shadow.skip(count);
            }
        }
    }

    /// The pixels' samples in their order, each with its eye ray and what is prefetched of it.
    pub fn pixels(&self) -> impl Iterator<Item = (&CameraSample, Ray, PixelBatch<'_>)> {
        (0..self.samples.len()).map(|index| {
            let batch = PixelBatch { batch: self, index };
            (&self.samples[index], self.rays[index].0, batch)
        })
    }
}

impl<'a> PixelBatch<'a> {
    /// Closest hit of the eye ray, and its point.
    #[inline]
    pub fn hit(self) -> Option<(&'a Hit, &'a Interaction)> {
        let hit = self.batch.hits[self.index].as_ref();
        hit.zip(self.batch.points[self.index].as_ref())
    }

    /// Shadow rays to a light, if they are prefetched.
    #[inline]
    pub fn shadow_rays(self, light: u32) -> Option<&'a [Prefetched]> {
        let light = self.batch.lights.get(light as usize)?;
        let first = light.first + self.index * light.count;
        (light.count > 0).then(|| &self.batch.shadow.prefetched()[first..first + light.count])
    }
}
