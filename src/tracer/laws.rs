//! Laws of ray tracing: each step of the recursion as a function that can be exchanged.
//!
//! [`Ours`] are the laws that this tracer follows; the provided methods of [`Laws`] are they. [`Bent`] exchanges one or two of them
//! for a mistake that students make ([`crate::scene::Bend`]), to show what it does and to recognise it. A wrong tracer is so the right one with
//! one function exchanged, and never a second tracer. `Ours` has no size: the picture pays nothing.

mod bent;
mod camera;
mod closest;
mod illumination;
mod lobes;
mod secondary;
mod solids;
mod surface;
#[cfg(test)]
mod tests;

pub use bent::Bent;

use super::light_sampler::{LightSampler, SampledRay, ShadowRay};
use super::path_id::PathId;
use crate::geometry::Hit;
use crate::math::{DVec3, Ray, Rgb};
use crate::probe::{Absence, Probe, Term};
use crate::scene::{Camera, Scene, Settings};
use crate::shading::{Fresnel, FresnelSplit, Interaction, LightKind, Secondary, ShadingPoint};
use crate::world::World;

/// The laws that a tracer follows.
pub trait Laws: Copy {
    /// Whether they may differ from ours, so that nothing may be traced before its turn.
    const BENT: bool = false;

    /// Eye ray through a point of the film, in pixels from the top left corner.
    #[inline(always)]
    fn eye_ray(self, camera: &Camera, film: [f64; 2], size: (u32, u32)) -> Ray {
        camera.ray(film, size)
    }

    /// Closest hit of a ray.
    #[inline(always)]
    fn closest<P: Probe>(self, world: &World, ray: &Ray, probe: &mut P) -> Option<Hit> {
        world.closest(ray, 0.0, probe)
    }

    /// Hit point with its normals, as shading asks for it.
    #[inline(always)]
    fn interaction(self, scene: &Scene, ray: &Ray, hit: &Hit) -> Interaction {
        scene.interaction_for_shading(ray, hit)
    }

    /// Secondary ray from a hit point along a direction.
    #[inline(always)]
    fn start(self, at: &Interaction, direction: DVec3) -> Ray {
        Ray::new(at.origin_towards(direction), direction)
    }

    /// Ambient term in a scene with so many lights.
    #[inline(always)]
    fn ambient(self, point: &ShadingPoint, ia: Rgb, lights: usize) -> Option<Term> {
        let _ = lights;
        point.ambient(ia)
    }

    /// Shadow ray to a sample of a light, or why none is sent.
    #[inline(always)]
    fn shadow_ray<S: LightSampler>(
        self,
        sampler: &S,
        sample: u32,
        point: &ShadingPoint,
        kind: &LightKind,
    ) -> SampledRay {
        let _ = (point, kind);
        sampler.shadow_ray(sample)
    }

    /// Key of the points on area lights.
    #[inline(always)]
    fn light_points(self, id: PathId) -> PathId {
        id
    }

    /// What is in the way of a shadow ray to a light, by number.
    #[inline(always)]
    fn occluder<P: Probe>(
        self,
        (world, settings): (&World, &Settings),
        (point, light): (&ShadingPoint, u32),
        shadow: &ShadowRay,
        probe: &mut P,
    ) -> Option<Hit> {
        let _ = (settings, point, light);
        world.occluder(&shadow.ray, shadow.light.distance, probe)
    }

    /// Terms of a sample of a light.
    #[inline(always)]
    fn eval(self, point: &ShadingPoint, ray: &ShadowRay, occluded: bool, add: impl FnMut(Term)) {
        if !occluded {
            point.eval(&ray.light, ray.n_dot_l, add);
        }
    }

    /// Split of the light at the boundary of two media of these indices of refraction.
    #[inline(always)]
    fn split(self, point: &ShadingPoint, model: Fresnel, ior: [f64; 2]) -> FresnelSplit {
        point.split(model, ior)
    }

    /// Direction and weight of the reflected ray, or why there is none.
    #[inline(always)]
    fn reflected(
        self,
        point: &ShadingPoint,
        split: Option<&FresnelSplit>,
    ) -> Result<Secondary, Absence> {
        point.reflected(split)
    }

    /// Direction and weight of the transmitted ray, or why there is none.
    #[inline(always)]
    fn transmitted(self, point: &ShadingPoint, split: &FresnelSplit) -> Result<Secondary, Absence> {
        point.transmitted(split)
    }

    /// Bounces at most, given what the settings say.
    #[inline(always)]
    fn depth(self, limit: u32) -> u32 {
        limit
    }

    /// What a ray brings back, given the sum of its terms and rays.
    #[inline(always)]
    fn returned(self, sum: Rgb) -> Rgb {
        sum
    }
}

/// The laws of this tracer.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ours;

impl Laws for Ours {}
