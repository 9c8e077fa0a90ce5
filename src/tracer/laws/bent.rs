//! Laws with one or two of them exchanged.

use super::{Laws, camera, closest, illumination, lobes, secondary, surface};
use crate::geometry::Hit;
use crate::math::{DVec3, Ray, Rgb};
use crate::probe::{Absence, Probe, Term};
use crate::scene::{Bend, Bends, Camera, Law, Scene, Settings};
use crate::shading::{Fresnel, FresnelSplit, Interaction, LightKind, Secondary, ShadingPoint};
use crate::tracer::light_sampler::{LightSampler, SampledRay, ShadowRay};
use crate::tracer::path_id::PathId;
use crate::world::World;

/// Our laws but for these bends.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bent(pub Bends);

impl Laws for Bent {
    const BENT: bool = true;

    fn eye_ray(self, camera: &Camera, film: [f64; 2], size: (u32, u32)) -> Ray {
        match self.0.of(Law::EyeRay) {
            Some(bend) => camera::eye_ray(bend, camera, film, size),
            None => camera.ray(film, size),
        }
    }

    fn closest<P: Probe>(self, world: &World, ray: &Ray, probe: &mut P) -> Option<Hit> {
        match self.0.of(Law::Closest) {
            Some(bend) => closest::closest(bend, world, ray),
            None => world.closest(ray, 0.0, probe),
        }
    }

    fn interaction(self, scene: &Scene, ray: &Ray, hit: &Hit) -> Interaction {
        match self.0.of(Law::Interaction) {
            Some(bend) => surface::interaction(bend, scene, ray, hit),
            None => scene.interaction(ray, hit),
        }
    }

    fn start(self, at: &Interaction, direction: DVec3) -> Ray {
        // Rays are sent with unit directions whatever a bend makes of them; those that are unit stay as they are.
        let unit = if (direction.length_squared() - 1.0).abs() < 1e-12 {
            direction
        } else {
            direction.normalize_or(direction)
        };
        Ray::new(surface::origin(self.0.of(Law::Start), at, unit), unit)
    }

    fn ambient(self, point: &ShadingPoint, ia: Rgb, lights: usize) -> Option<Term> {
        let per_light = self.0.has(Bend::AmbientPerLight);
        let times = if per_light { lights as f64 } else { 1.0 };
        point.ambient(ia * times)
    }

    fn shadow_ray<S: LightSampler>(
        self,
        sampler: &S,
        sample: u32,
        point: &ShadingPoint,
        kind: &LightKind,
    ) -> SampledRay {
        let is_bent = |bend: &Bend| {
            [Law::Illumination, Law::LightSamples].contains(&bend.law())
                || illumination::shines_from_behind(*bend)
        };
        let ray = match self.0.iter().find(is_bent) {
            Some(bend) => {
                let light = sampler.light(sample);
                illumination::shadow_ray(bend, sampler, light, point, kind)
            }
            None => sampler.shadow_ray(sample),
        };
        let start = self.0.of(Law::Start);
        ray.map(|shadow| match start {
            Some(_) => ShadowRay {
                ray: Ray {
                    origin: surface::origin(start, point.at, shadow.ray.direction),
                    ..shadow.ray
                },
                ..shadow
            },
            None => shadow,
        })
    }

    fn light_points(self, id: PathId) -> PathId {
        if self.0.has(Bend::SamePoints) {
            PathId {
                pixel: (0, 0),
                ..id
            }
        } else {
            id
        }
    }

    fn occluder<P: Probe>(
        self,
        (world, settings): (&World, &Settings),
        (point, light): (&ShadingPoint, u32),
        shadow: &ShadowRay,
        probe: &mut P,
    ) -> Option<Hit> {
        let blocked = |ray: &Ray, distance: f64, probe: &mut P| match self.0.of(Law::Closest) {
            Some(bend) => closest::occluder(bend, world, ray, distance),
            None => world.occluder(ray, distance, probe),
        };
        let (ray, distance) = (&shadow.ray, shadow.light.distance);
        match self.0.of(Law::Shadow) {
            Some(Bend::ShadowNone) => None,
            Some(Bend::ShadowEndless) => blocked(ray, f64::INFINITY, probe),
            Some(Bend::ShadowInverted) => match blocked(ray, distance, probe) {
                Some(_) => None,
                None => Some(illumination::nothing_hit()),
            },
            Some(Bend::FirstLightDecides) if light > 0 => {
                let first = illumination::to_first_light(world, settings, point);
                let (ray, distance) = first.unwrap_or((*ray, distance));
                blocked(&ray, distance, probe)
            }
            _ => blocked(ray, distance, probe),
        }
    }

    fn eval(
        self,
        point: &ShadingPoint,
        ray: &ShadowRay,
        occluded: bool,
        mut add: impl FnMut(Term),
    ) {
        let is_bent = |bend: &Bend| [Law::Diffuse, Law::Specular].contains(&bend.law());
        let bend = self.0.iter().find(is_bent);
        point.eval(&ray.light, ray.n_dot_l, |term| {
            let term = bend.map_or(Some(term), |bend| lobes::term(bend, term, point, ray));
            let shadowed =
                self.0.has(Bend::SpecularShadowed) && matches!(term, Some(Term::Specular { .. }));
            if let Some(term) = term.filter(|_| !occluded || shadowed) {
                add(term);
            }
        });
    }

    fn split(self, point: &ShadingPoint, model: Fresnel, ior: [f64; 2]) -> FresnelSplit {
        let bends = [Law::Refract, Law::Media, Law::Shares].map(|law| self.0.of(law));
        secondary::split(bends.into_iter().flatten(), point, model, ior)
    }

    fn reflected(
        self,
        point: &ShadingPoint,
        split: Option<&FresnelSplit>,
    ) -> Result<Secondary, Absence> {
        let bends = [Law::Reflect, Law::Shares].map(|law| self.0.of(law));
        secondary::reflected(bends.into_iter().flatten(), point, split)
    }

    fn depth(self, limit: u32) -> u32 {
        limit.saturating_sub(u32::from(self.0.has(Bend::DepthLessOne)))
    }

    fn returned(self, sum: Rgb) -> Rgb {
        if self.0.has(Bend::ClampEarly) {
            sum.map(|c| c.min(1.0))
        } else {
            sum
        }
    }
}
