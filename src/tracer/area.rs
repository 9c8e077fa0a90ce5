//! An area light as a place sees it: what is the same for all samples of it that the place takes.

use super::lights::{Asker, Start, Surface};
use crate::math::points::{Points, Run};
use crate::math::sampler::light_run;
use crate::math::{LightSampling, Rgb, Sampler};
use crate::probe::counting;
use crate::scene::{Effect, Scene, Settings};
use crate::shading::{Area, Illumination, Interaction, Projected, Source};

/// A light with an area, before a place is chosen on it.
#[derive(Debug)]
pub struct AreaView<'a> {
    area: &'a Area,
    /// Its polygon as the surface sees it, if places on the light are chosen by that. (Boxed: it is large, and nearly
    /// always none.)
    projected: Option<Box<Projected>>,
    /// Places on the light, and the number of the first that is taken here; none if its middle stands for all.
    places: Option<(Points, u32)>,
    /// What one sample counts in the mean.
    share: f64,
    /// Where the shadow rays start.
    pub start: Start,
}

impl<'a> AreaView<'a> {
    /// Light number `light` as `surface` sees it; `None` if it is no area.
    #[inline]
    pub fn new(
        scene: &'a Scene,
        settings: &Settings,
        asker: Asker,
        surface: &Surface,
        light: u32,
    ) -> Option<Self> {
        match &scene.lights[light as usize].source {
            Source::Area(area) if counting::AREAS => Some(Self {
                area,
                projected: projected(area, settings, surface),
                places: settings
                    .effects
                    .has(Effect::SoftShadows)
                    .then(|| places(settings, asker, light)),
                share: 1.0 / f64::from(settings.rays_to_area()),
                start: Start::before(surface.at),
            }),
            _ => None,
        }
    }

    /// P, the projected solid angle of the light, if its samples are chosen by that.
    pub fn projected(&self) -> Option<f64> {
        self.projected.as_ref().map(|polygon| polygon.area)
    }

    /// The light as `at` sees it from the place that sample number `sample` chooses, as a share of the mean. (On its own,
    /// so that scenes without areas pay nothing for it.)
    #[inline(never)]
    pub fn sample(&self, at: &Interaction, sample: u32) -> Option<Illumination> {
        let place = self.places.as_ref();
        let u = place.map_or([0.5; 2], |(points, first)| points.at(first + sample));
        let seen = match &self.projected {
            Some(polygon) => self
                .area
                .sample_projected((at.point, at.normal), polygon, u)?,
            None => self.area.sample(at.point, u)?,
        };
        Some(Illumination {
            intensity: seen.intensity * self.share,
            irradiance: seen.irradiance.map(|e: Rgb| e * self.share),
            ..seen
        })
    }
}

/// The places on a light that a pixel asks for, and the number of the first one that belongs to this sample of the pixel.
/// The places of all hits of a pixel at the end of the same path are one run; only a grid is a whole one at each hit.
fn places(settings: &Settings, asker: Asker, light: u32) -> (Points, u32) {
    let here = settings.light.samples;
    let run = Run {
        key: light_run(settings.seed, asker.pixel, asker.path, light),
        count: match settings.light.sampler {
            Sampler::Grid => here,
            _ => here * settings.pixel.set_size(),
        },
    };
    (
        Points::new(settings.light.sampler, run),
        asker.sample * here,
    )
}

/// The light's polygon as the surface sees it, if that is what places are chosen by.
///
/// Not for highlights, which do not fall with the cosine that the polygon is weighed by; nor for the grid, which is the
/// lecture's: points on the light, side by side.
fn projected(area: &Area, settings: &Settings, surface: &Surface) -> Option<Box<Projected>> {
    let by_what_it_brings = settings.light.density == LightSampling::Projected
        && settings.light.sampler != Sampler::Grid
        && settings.effects.has(Effect::SoftShadows)
        && surface.material.specular.is_black();
    if !by_what_it_brings || surface.diffuse.is_black() {
        return None;
    }
    let at = surface.at;
    area.projected(at.point, at.normal).map(Box::new)
}
