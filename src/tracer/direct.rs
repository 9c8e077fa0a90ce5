//! Direct light: the sum over all lights, and all samples of a light, of f(L, V) I (N.L) where nothing is in the way.
//!
//! Source: Whitted 1980 for one shadow ray to each light; Cook, Porter and Carpenter 1984, "Distributed ray tracing", for many
//! to a light that has an area.

use super::light_sampler::{LightSampler, ShadowRay};
use super::shadow_batch::Prefetched;
use super::tile_batch::PixelBatch;
use super::whitted::{Path, Tracer};
use crate::math::Rgb;
use crate::probe::{Absence, Event, Probe, RayKind, RayRecord, tell};
use crate::shading::Effect;
use crate::shading::ShadingPoint;

/// Shadow rays from a point to a light.
enum ShadowRays<'a> {
    /// Sampled and traced one after the other.
    OneByOne(LightSampler<'a>),
    /// Sampled and traced together with others, before.
    Prefetched(&'a [Prefetched]),
}

impl<P: Probe> Tracer<'_, P> {
    /// Adds what all lights add at a point.
    pub(super) fn direct_light(
        &mut self,
        sum: &mut Rgb,
        point: &ShadingPoint,
        path: &Path,
        prefetched: Option<PixelBatch>,
    ) {
        for light in 0..self.world.scene.lights.len() as u32 {
            if let Some(rays) = prefetched.and_then(|pixel| pixel.shadow_rays(light)) {
                let count = rays.len() as u32;
                self.light(
                    sum,
                    point,
                    path,
                    (light, count),
                    &ShadowRays::Prefetched(rays),
                );
                continue;
            }
            let scene = &self.world.scene;
            let sampler = LightSampler::new(scene, self.settings, point, (path.id, light));
            let count = sampler.count;
            if count == 1 {
                self.light(
                    sum,
                    point,
                    path,
                    (light, count),
                    &ShadowRays::OneByOne(sampler),
                );
            } else {
                self.many_samples(sum, point, path, light, sampler);
            }
        }
    }

    /// Adds a light that has many samples: traced together if the probe is silent. (Never inlined, so that scenes without area
    /// lights pay nothing for it.)
    #[inline(never)]
    fn many_samples(
        &mut self,
        sum: &mut Rgb,
        point: &ShadingPoint,
        path: &Path,
        light: u32,
        sampler: LightSampler,
    ) {
        let samples = sampler.count;
        tell!(self.probe, Event::LightSamples { light, samples });
        if P::LISTENS || !self.settings.effects.has(Effect::Shadows) {
            let rays = ShadowRays::OneByOne(sampler);
            return self.light(sum, point, path, (light, samples), &rays);
        }
        let mut batch = std::mem::take(&mut self.shadow_batch);
        batch.clear();
        batch.sample(&sampler, self.rays.left().min(u64::from(samples)) as u32);
        batch.trace(self.world, true);
        let rays = ShadowRays::Prefetched(batch.prefetched());
        self.light(sum, point, path, (light, samples), &rays);
        self.shadow_batch = batch;
    }

    /// Adds one light: for each of its samples whose shadow ray arrives, the diffuse and the specular term.
    #[inline]
    fn light(
        &mut self,
        sum: &mut Rgb,
        point: &ShadingPoint,
        path: &Path,
        (light, count): (u32, u32),
        rays: &ShadowRays,
    ) {
        let casts_shadows = self.settings.effects.has(Effect::Shadows);
        for sample in 0..count {
            if self.rays.is_spent() {
                return self.absent(RayKind::Light, light, Absence::RayBudget);
            }
            let shadow_ray = match rays {
                ShadowRays::OneByOne(sampler) => &sampler.shadow_ray(sample),
                ShadowRays::Prefetched(rays) => &rays[sample as usize].ray,
            };
            self.rays.light_sample(casts_shadows && shadow_ray.is_ok());
            let ray = match shadow_ray {
                Ok(ray) => ray,
                Err(reason) => {
                    self.absent(RayKind::Light, light, *reason);
                    continue;
                }
            };
            let occluded = match rays {
                ShadowRays::OneByOne(_) => self.is_occluded(path, (light, sample), ray),
                ShadowRays::Prefetched(rays) => rays[sample as usize].occluded,
            };
            if !occluded {
                point.eval(&ray.light, ray.n_dot_l, |term| {
                    self.add_light(sum, term, (light, sample));
                });
            }
        }
    }

    /// Sends a shadow ray: true if anything is in its way. Transparent objects are, too.
    #[inline]
    fn is_occluded(
        &mut self,
        path: &Path,
        (light, sample): (u32, u32),
        shadow: &ShadowRay,
    ) -> bool {
        if !self.settings.effects.has(Effect::Shadows) {
            self.absent(RayKind::Light, light, Absence::EffectOff);
            return false;
        }
        let ShadowRay {
            ray, light: seen, ..
        } = shadow;
        tell!(
            self.probe,
            Event::Ray(RayRecord {
                kind: RayKind::Light,
                sample: sample as u16,
                depth: path.depth + 1,
                light,
                medium: path.medium,
                origin: ray.origin,
                direction: ray.direction,
                t_max: seen.distance,
                weight: Rgb::WHITE,
            })
        );
        let occluder = self.world.occluder(ray, seen.distance, self.probe);
        tell!(self.probe, occluder.map_or(Event::Lit, Event::Blocked));
        tell!(
            self.probe,
            Event::Return {
                radiance: Rgb::BLACK
            }
        );
        occluder.is_some()
    }
}
