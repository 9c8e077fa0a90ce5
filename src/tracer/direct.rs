//! Direct light: the sum over all lights, and all samples of a light, of f(L, V) I (N.L) where nothing is in the way.
//!
//! Source: Whitted 1980 for one shadow ray to each light; Cook, Porter and Carpenter 1984, "Distributed ray tracing", for many
//! to a light that has an area.

use super::light_sampler::{LightSampler, ShadowRay};
use super::shadow_batch::ShadowRays;
use super::state::{Path, Tracer};
use crate::math::Rgb;
use crate::probe::{Absence, Probe, RayKind};
use crate::shading::{Effect, ShadingPoint};

impl<P: Probe> Tracer<'_, P> {
    /// Adds the light that arrives at a point. `is_first`: it is the closest hit of its ray, of which something may be prefetched.
    #[inline]
    pub(super) fn direct_light(
        &mut self,
        sum: &mut Rgb,
        point: &ShadingPoint,
        path: &Path,
        is_first: bool,
    ) {
        let prefetched = path.prefetched.filter(|_| is_first);
        for light in 0..self.world.scene.lights.len() as u32 {
            if let Some(rays) = prefetched.and_then(|pixel| pixel.shadow_rays(light)) {
                self.add_light(sum, point, path, light, rays);
                continue;
            }
            let id = (path.id, light);
            let sampler = LightSampler::new(&self.world.scene, self.settings, point, id);
            if sampler.count == 1 {
                self.add_light(sum, point, path, light, &sampler);
            } else {
                self.add_area_light(sum, point, path, light, &sampler);
            }
        }
    }

    /// Adds a light: for each of its samples whose shadow ray arrives, the diffuse and the specular term.
    #[inline(always)]
    pub(super) fn add_light(
        &mut self,
        sum: &mut Rgb,
        point: &ShadingPoint,
        path: &Path,
        light: u32,
        rays: &(impl ShadowRays + ?Sized),
    ) {
        let casts_shadows = self.settings.effects.has(Effect::Shadows);
        for sample in 0..rays.count() {
            if self.rays.is_spent() {
                return self.absent(RayKind::Light, light, Absence::RayBudget);
            }
            let mut slot = None;
            let (ray, known) = rays.get(sample, &mut slot);
            self.rays.light_sample(casts_shadows && ray.is_ok());
            match ray {
                Err(reason) => self.absent(RayKind::Light, light, *reason),
                Ok(ray) => {
                    if !known.unwrap_or_else(|| self.is_occluded(path, ray, (light, sample))) {
                        point.eval(&ray.light, ray.n_dot_l, |term| {
                            self.add_term(sum, term, (light, sample));
                        });
                    }
                }
            }
        }
    }

    /// Sends a shadow ray: true if anything is in its way. Transparent objects are, too.
    #[inline]
    fn is_occluded(&mut self, path: &Path, shadow: &ShadowRay, light: (u32, u32)) -> bool {
        if !self.settings.effects.has(Effect::Shadows) {
            self.absent(RayKind::Light, light.0, Absence::EffectOff);
            return false;
        }
        self.tell_shadow_ray(path, shadow, light);
        let distance = shadow.light.distance;
        let occluder = self.world.occluder(&shadow.ray, distance, self.probe);
        self.tell_occluder(occluder);
        occluder.is_some()
    }
}
