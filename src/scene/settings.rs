//! The knobs that change the picture.

use super::Scene;
use super::effects::{Effect, Effects, effects};
use super::limits::DEFAULT_MAX_RAYS;
use super::sampling::{Adaptive, Pilot, Sampling};
use crate::accel::AccelKind;
use crate::geometry::Arithmetic;
use crate::math::{Filter, LightSampling, Sampler};
use crate::shading::Fresnel;

/// Everything that changes the picture but is not the scene itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Width of the picture in pixels.
    pub width: u32,
    /// Height of the picture in pixels.
    pub height: u32,
    /// Samples a pixel; the first of them if there are to be more where they are needed.
    pub samples: u32,
    /// The sets that they are made of, each spread evenly by itself.
    pub sets: u32,
    /// Where they lie.
    pub sampling: Sampling,
    /// How much they count, by their distance from the pixel's middle.
    pub filter: Filter,
    /// How far from the middle they lie at most, along x and y, in pixels.
    pub filter_radius: f64,
    /// More samples where they are needed.
    pub adaptive: Option<Adaptive>,
    /// Whether each pixel's standard error is estimated (it never changes the picture).
    pub errors: bool,
    /// Shadow rays to an area light, a hit.
    pub light_samples: u32,
    /// Where on the light they go.
    pub sampler: Sampler,
    /// In proportion to what: to the light's area, or to what each place of it brings.
    pub light_sampling: LightSampling,
    /// How many times a ray may bounce: 0 stops at what the eye sees directly.
    pub depth: u32,
    /// Rays that could add less than this to the pixel (largest channel of their throughput) are not sent.
    pub min_weight: f64,
    /// What is simulated: at most what the scene calls for, unless somebody wants to see that this is enough.
    pub effects: Effects,
    /// Seed of all random numbers.
    pub seed: u64,
    /// How transparent surfaces share light between R and T.
    pub fresnel: Fresnel,
    /// Factor on the picture before it is clamped.
    pub exposure: f64,
    /// Which acceleration structure finds the hits (it never changes the picture).
    pub accel: AccelKind,
    /// What shapes are tested with; the world is built of shapes that do (see [`Scene::computed_with`]).
    pub arithmetic: Arithmetic,
    /// Rays that a picture may cost; each pixel gets its even share.
    pub max_rays: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            width: 320,
            height: 240,
            samples: 1,
            sets: 1,
            sampling: Sampling::default(),
            filter: Filter::default(),
            filter_radius: Filter::default().usual_radius(),
            adaptive: None,
            errors: false,
            light_samples: 16,
            sampler: Sampler::default(),
            light_sampling: LightSampling::default(),
            depth: 5,
            min_weight: 1.0 / 512.0,
            effects: Effects::ALL,
            seed: 0,
            fresnel: Fresnel::default(),
            exposure: 1.0,
            accel: AccelKind::default(),
            arithmetic: Arithmetic::default(),
            max_rays: DEFAULT_MAX_RAYS,
        }
    }
}

/// What one pixel may spend: the same for each, whatever the others need.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Samples, at most.
    pub samples: u32,
    /// Rays besides the samples' eye rays.
    pub further_rays: u64,
}

impl Settings {
    /// Effects that the scene calls for and that are left out all the same.
    pub fn left_out(&self, scene: &Scene) -> impl Iterator<Item = Effect> {
        let (called_for, kept) = (effects(scene), self.effects);
        Effect::ALL
            .into_iter()
            .filter(move |effect| called_for.has(*effect) && !kept.has(*effect))
    }

    /// Samples of a set.
    pub fn set_size(&self) -> u32 {
        self.samples.div_ceil(self.sets.max(1))
    }

    /// Samples that do not count: they decide how many others there are.
    pub fn pilot(&self) -> u32 {
        match self.adaptive {
            Some(adaptive) if adaptive.pilot == Pilot::Apart => self.samples,
            _ => 0,
        }
    }

    /// Whether the pixels around a pixel decide how many samples it has.
    pub fn asks_around(&self) -> bool {
        self.adaptive.is_some_and(|a| a.pilot == Pilot::Around)
    }

    /// Shadow rays to an area light, a hit: one to its middle if soft shadows are left out.
    pub fn rays_to_area(&self) -> u32 {
        if self.effects.has(Effect::SoftShadows) {
            self.light_samples
        } else {
            1
        }
    }

    /// Width and height.
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Samples that a pixel has at most. After a pilot at least one counts.
    pub fn most_samples(&self) -> u32 {
        let adapted = self.adaptive.map(|a| a.most.max(self.pilot() + 1));
        adapted.unwrap_or(self.samples)
    }

    /// The same within its budget: it gets no more than that has eye rays for.
    pub fn samples_afforded(&self) -> u32 {
        let most = u32::try_from(self.rays_per_pixel()).unwrap_or(u32::MAX);
        self.most_samples().min(most)
    }

    /// What one pixel may spend.
    pub fn budget(&self) -> Budget {
        let samples = self.samples_afforded();
        let further_rays = self.rays_per_pixel() - u64::from(samples);
        Budget {
            samples,
            further_rays,
        }
    }

    /// How many rays one pixel may send. The same for each, whatever the others need: so that a pixel traced alone is
    /// the pixel of the picture.
    pub fn rays_per_pixel(&self) -> u64 {
        let pixels = u64::from(self.width) * u64::from(self.height);
        (self.max_rays / pixels.max(1)).max(1)
    }
}
