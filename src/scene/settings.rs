//! Settings: all that changes the picture but is not the scene itself.

pub mod knob;
pub mod knobs;
mod light;
mod pixel;

pub use knobs::flags;
pub use light::AreaLightSampling;
pub use pixel::{Adaptive, Pilot, PixelSampling, Sampling};

use super::effects::effects;
use super::limits::DEFAULT_MAX_RAYS;
use super::{Bends, Scene};
use crate::accel::AccelKind;
use crate::geometry::Arithmetic;
use crate::shading::{Effect, Effects, Fresnel, ShadingModel};

/// Settings of a render.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// Size and exposure of the picture.
    pub image: Image,
    /// Samples of a pixel.
    pub pixel: PixelSampling,
    /// Shadow rays to area lights.
    pub light: AreaLightSampling,
    /// Where recursion ends.
    pub recursion: Recursion,
    /// Effects that are simulated: by default those that the scene calls for.
    pub effects: Effects,
    /// Model by which all triangles are shaded, whatever their objects say.
    pub shading: Option<ShadingModel>,
    /// How transparent surfaces share light between R and T.
    pub fresnel: Fresnel,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Acceleration structure; it never changes the picture.
    pub accel: AccelKind,
    /// Arithmetic of shape tests; the world is built of shapes that use it (see [`Scene::computed_with`]).
    pub arithmetic: Arithmetic,
    /// Laws that are exchanged for mistakes, to show what these do.
    pub bends: Bends,
}

/// Size and exposure of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Image {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Factor on the picture before it is clamped.
    pub exposure: f64,
}

impl Default for Image {
    fn default() -> Self {
        Self {
            width: 320,
            height: 240,
            exposure: 1.0,
        }
    }
}

/// Limits of recursion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recursion {
    /// How many times a ray may bounce: 0 stops at what the camera sees directly.
    pub depth: u32,
    /// Rays that could add less than this to the pixel (largest channel of their throughput) are not sent.
    pub min_weight: f64,
    /// Rays that a picture may cost; each pixel gets its even share, and its first eye ray in any case.
    pub max_rays: u64,
}

impl Default for Recursion {
    fn default() -> Self {
        Self {
            depth: 5,
            min_weight: 1.0 / 512.0,
            max_rays: DEFAULT_MAX_RAYS,
        }
    }
}

/// Ray budget of one pixel: that of every pixel, whatever the others need.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Samples, at most.
    pub samples: u32,
    /// Rays besides the samples' camera rays.
    pub further_rays: u64,
}

impl Settings {
    /// Changed settings: a copy that `change` was applied to.
    #[must_use]
    pub fn with(mut self, change: impl FnOnce(&mut Self)) -> Self {
        change(&mut self);
        self
    }

    /// Width and height.
    pub fn size(&self) -> (u32, u32) {
        (self.image.width, self.image.height)
    }

    /// Effects that the scene calls for and that are left out all the same.
    pub fn left_out(&self, scene: &Scene) -> impl Iterator<Item = Effect> {
        let (called_for, kept) = (effects(scene), self.effects);
        Effect::ALL
            .into_iter()
            .filter(move |effect| called_for.has(*effect) && !kept.has(*effect))
    }

    /// Shadow rays to an area light, a hit: one to its middle if soft shadows are left out.
    pub fn rays_to_area(&self) -> u32 {
        if self.effects.has(Effect::SoftShadows) {
            self.light.samples
        } else {
            1
        }
    }

    /// Samples that a pixel has at most within its budget: no more than it has camera rays for.
    pub fn samples_afforded(&self) -> u32 {
        let most = u32::try_from(self.rays_per_pixel()).unwrap_or(u32::MAX);
        self.pixel.most_samples().min(most)
    }

    /// Ray budget of one pixel.
    pub fn budget(&self) -> Budget {
        let samples = self.samples_afforded();
        let further_rays = self.rays_per_pixel() - u64::from(samples);
        Budget {
            samples,
            further_rays,
        }
    }

    /// Rays that one pixel may send: that of every pixel, whatever the others need, so that a pixel traced alone is the
    /// pixel of the picture.
    pub fn rays_per_pixel(&self) -> u64 {
        let pixels = u64::from(self.image.width) * u64::from(self.image.height);
        (self.recursion.max_rays / pixels.max(1)).max(1)
    }
}
