//! Surfaces of scenes in which a shading model is named: flat ones, and those whose light is blended between corners.

use super::super::by_laws::ByLaws;
use super::super::corners::{CornerPoints, HitCorners, asking_ray};
use super::super::laws::Laws;
use super::super::light_sampler::{AreaSampler, LightSampler, PointSampler};
use super::super::state::{Path, Tracer, Vertex};
use crate::math::Rgb;
use crate::probe::{Absence, Event, Probe, RayKind, tell};
use crate::scene::Effect;
use crate::shading::{Area, ShadingPoint};
use crate::world::NextHit;

/// A hit and the corners of its triangle.
struct Blend<'a> {
    vertex: &'a Vertex<'a>,
    corners: CornerPoints<'a>,
}

impl<P: Probe, L: Laws> Tracer<'_, P, L> {
    /// Radiance of a surface where a model may be named. (Never inlined, so that other scenes pay nothing for it.)
    #[inline(never)]
    pub(super) fn shade_by_model(&mut self, path: &Path, surface: &NextHit) -> Rgb {
        let of = (&self.world.scene, self.settings);
        let at = of.0.shaded_with((surface.hit, surface.at), of.1);
        match HitCorners::of(self.laws, of, path.ray.origin, surface.hit) {
            Some(corners) => {
                let material = of.0.material_at(surface.hit);
                let effects = of.1.effects;
                let point = ShadingPoint::new(&at, material, effects);
                let vertex = &Vertex { path, point };
                let corners = corners.points(material, effects);
                self.shade_blended(&Blend { vertex, corners }, surface)
            }
            None => self.shade_point(path, surface, &at),
        }
    }

    /// Radiance of a surface whose light is blended between corners. R and T leave the hit by its own N, which is blended, too.
    fn shade_blended(&mut self, blend: &Blend, surface: &NextHit) -> Rgb {
        let (scene, corners) = (&self.world.scene, &blend.corners);
        let mut sum = Rgb::BLACK;
        // The same at all corners.
        self.add(&mut sum, blend.vertex.point.emitted());
        let ambient = corners.ambient(self.laws, scene.ambient, scene.lights.len());
        self.add(&mut sum, ambient);
        for (light, number) in scene.lights.iter().zip(0..) {
            if let Some(area) = light.kind.area() {
                self.add_blended_area(&mut sum, blend, number, area);
            } else {
                let sampler = |point| PointSampler::new(self.settings, point, &light.kind);
                let own = sampler(&blend.vertex.point);
                let at_corners = corners.points.each_ref().map(sampler);
                self.add_blended_light(&mut sum, blend, number, (&own, &at_corners));
            }
        }
        self.add_secondary(&mut sum, blend.vertex, surface);
        self.done(self.laws.returned(sum))
    }

    /// Adds an area light. The same random numbers choose the point on it for the hit and for each corner.
    fn add_blended_area(&mut self, sum: &mut Rgb, blend: &Blend, light: u32, area: &Area) {
        let id = self.laws.light_points(blend.vertex.path.id);
        let sampler = |point| AreaSampler::new(self.settings, point, area, (id, light));
        let own = sampler(&blend.vertex.point);
        let samples = own.samples();
        if samples > 1 {
            tell!(self.probe, Event::LightSamples { light, samples });
        }
        let at_corners = blend.corners.points.each_ref().map(sampler);
        self.add_blended_light(sum, blend, light, (&own, &at_corners));
    }

    /// Adds a light: for each of its samples that is seen from the hit, what it brings to the corners.
    fn add_blended_light<S: LightSampler>(
        &mut self,
        sum: &mut Rgb,
        blend: &Blend,
        light: u32,
        (own, at_corners): (&S, &[S; 3]),
    ) {
        let Blend { vertex, corners } = blend;
        let kind = &self.world.scene.lights[light as usize].kind;
        let casts_shadows = self.settings.effects.has(Effect::Shadows);
        let own = ByLaws {
            sampler: own,
            laws: self.laws,
            point: &vertex.point,
            kind,
        };
        for sample in 0..own.samples() {
            if self.rays.is_spent() {
                return self.absent(RayKind::Light, light, Absence::RayBudget);
            }
            let arrivals = corners.arrivals(self.laws, at_corners, sample, kind);
            let ray = asking_ray(&arrivals, &own, sample);
            self.rays.light_sample(casts_shadows && ray.is_ok());
            match ray {
                Err(reason) => self.absent(RayKind::Light, light, reason),
                Ok(ray) => {
                    let occluded = self.is_occluded(vertex, &ray, (light, sample));
                    corners.terms(self.laws, &arrivals, occluded, |term| {
                        self.add_term(sum, term, (light, sample));
                    });
                }
            }
        }
    }
}
