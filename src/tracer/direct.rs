//! Direct light: the sum over all lights, and all samples of a light, of f(L, V) I (N.L) where nothing is in the way.
//!
//! Source: Whitted 1980 for one shadow ray to each light; Cook, Porter and Carpenter 1984, "Distributed ray tracing", for many
//! to a light that has an area.

use super::by_laws::ByLaws;
use super::laws::Laws;
use super::light_sampler::{AreaSampler, LightSampler, PointSampler, ShadowRay};
use super::shadow_batch::ShadowRays;
use super::state::{Tracer, Vertex};
use crate::math::Rgb;
use crate::probe::{Absence, Event, Probe, RayKind, tell};
use crate::shading::{Area, Effect};

impl<P: Probe, L: Laws> Tracer<'_, P, L> {
    /// Adds the light that arrives at a vertex. `is_first`: it is the closest hit of its ray, of which something may be prefetched.
    /// (Never inlined, so that the recursion around it is compiled alike whatever lights there are.)
    #[inline(never)]
    pub(super) fn direct_light(&mut self, sum: &mut Rgb, vertex: &Vertex, is_first: bool) {
        let Vertex { path, point } = vertex;
        let prefetched = path.prefetched.filter(|_| is_first);
        for light in 0..self.world.scene.lights.len() as u32 {
            if let Some(rays) = prefetched.and_then(|pixel| pixel.shadow_rays(light)) {
                self.add_light(sum, vertex, light, rays);
                continue;
            }
            let kind = &self.world.scene.lights[light as usize].kind;
            if let Some(area) = kind.area() {
                self.add_area_light(sum, vertex, light, area);
            } else {
                let sampler = &PointSampler::new(self.settings, point, kind);
                self.add_sampled_light(sum, vertex, light, sampler);
            }
        }
    }

    /// Adds an area light. Many samples are traced together if the probe is silent. (Never inlined, so that scenes without area
    /// lights pay nothing for it.)
    #[inline(never)]
    fn add_area_light(&mut self, sum: &mut Rgb, at: &Vertex, light: u32, area: &Area) {
        let id = self.laws.light_points(at.path.id);
        let sampler = AreaSampler::new(self.settings, &at.point, area, (id, light));
        let samples = sampler.samples();
        if samples > 1 {
            tell!(self.probe, Event::LightSamples { light, samples });
        }
        if P::LISTENS || L::BENT || samples == 1 || !self.settings.effects.has(Effect::Shadows) {
            return self.add_sampled_light(sum, at, light, &sampler);
        }
        let mut batch = std::mem::take(&mut self.shadow_batch);
        let affordable = self.rays.left().min(u64::from(samples)) as u32;
        let rays = batch.trace_all(self.world, &sampler, affordable);
        self.add_light(sum, at, light, rays);
        self.rays.truncated |= affordable < samples;
        self.shadow_batch = batch;
    }

    /// Adds a light, sampled by the laws.
    #[inline(always)]
    fn add_sampled_light<S: LightSampler>(
        &mut self,
        sum: &mut Rgb,
        at: &Vertex,
        light: u32,
        sampler: &S,
    ) {
        let rays = ByLaws {
            sampler,
            laws: self.laws,
            point: &at.point,
            kind: &self.world.scene.lights[light as usize].kind,
        };
        self.add_light(sum, at, light, &rays);
    }

    /// Adds a light: for each of its samples whose shadow ray arrives, the diffuse and the specular term.
    #[inline(always)]
    fn add_light<R>(&mut self, sum: &mut Rgb, at: &Vertex, light: u32, rays: &R)
    where
        R: ShadowRays + ?Sized,
    {
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
                    let occluded =
                        known.unwrap_or_else(|| self.is_occluded(at, ray, (light, sample)));
                    self.laws.eval(&at.point, ray, occluded, |term| {
                        self.add_term(sum, term, (light, sample));
                    });
                }
            }
        }
    }

    /// Sends a shadow ray: true if anything is in its way. Transparent objects are, too.
    #[inline]
    pub(super) fn is_occluded(
        &mut self,
        at: &Vertex,
        shadow: &ShadowRay,
        light: (u32, u32),
    ) -> bool {
        if !self.settings.effects.has(Effect::Shadows) {
            self.absent(RayKind::Light, light.0, Absence::EffectOff);
            return false;
        }
        self.tell_shadow_ray(at.path, shadow, light);
        let (in_scene, asked) = ((self.world, self.settings), (&at.point, light.0));
        let occluder = self.laws.occluder(in_scene, asked, shadow, self.probe);
        self.tell_occluder(occluder);
        occluder.is_some()
    }
}
