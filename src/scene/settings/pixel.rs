//! Sampling of pixels: where the samples lie, and how many there are.

use serde::{Deserialize, Serialize};

use crate::sampling::{Filter, Sampler};

/// Samples of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSampling {
    /// Samples a pixel; the first of them if there are to be more where they are needed.
    pub samples: u32,
    /// Sets that the samples are parted into, each spread evenly by itself.
    pub sets: u32,
    /// Point set of the samples on the film.
    pub sampler: Sampler,
    /// Reconstruction filter: how much samples count by their distance from the pixel's middle.
    pub filter: Filter,
    /// Radius of the filter along x and y, in pixels.
    pub filter_radius: f64,
    /// Adaptive sampling, if any.
    pub adaptive: Option<Adaptive>,
    /// Whether each pixel's standard error is estimated; it never changes the picture.
    pub errors: bool,
}

impl Default for PixelSampling {
    fn default() -> Self {
        Self {
            samples: 1,
            sets: 1,
            sampler: Sampler::Grid,
            filter: Filter::default(),
            filter_radius: Filter::default().usual_radius(),
            adaptive: None,
            errors: false,
        }
    }
}

impl PixelSampling {
    /// Samples of a set.
    pub fn set_size(&self) -> u32 {
        self.samples.div_ceil(self.sets.max(1))
    }

    /// The set that a sample belongs to, and its number in the set. A single set goes on for ever.
    #[inline]
    pub fn set_of(&self, sample: u32) -> (u32, u32) {
        if self.sets > 1 {
            (sample / self.set_size(), sample % self.set_size())
        } else {
            (0, sample)
        }
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

    /// Samples that a pixel has at most. After a pilot at least one counts.
    pub fn most_samples(&self) -> u32 {
        let adapted = self.adaptive.map(|a| a.most.max(self.pilot() + 1));
        adapted.unwrap_or(self.samples)
    }
}

/// Where the samples of a pixel lie.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Sampling {
    /// In the middles of a grid of cells.
    #[default]
    Regular,
    /// Anywhere, each independent of all others.
    Random,
    /// Anywhere in each cell of the grid, by chance.
    Jittered,
    /// At the points of Sobol's sequence, scrambled as by Owen.
    Sobol,
}

impl Sampling {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Regular, Self::Random, Self::Jittered, Self::Sobol];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Regular => "regular",
            Self::Random => "random",
            Self::Jittered => "jittered",
            Self::Sobol => "sobol",
        }
    }

    /// The word for a sampler.
    pub fn of(sampler: Sampler) -> Self {
        match sampler {
            Sampler::Grid => Self::Regular,
            Sampler::Random => Self::Random,
            Sampler::Stratified => Self::Jittered,
            Sampler::Sobol => Self::Sobol,
        }
    }

    /// Whose points they are.
    pub fn sampler(self) -> Sampler {
        match self {
            Self::Regular => Sampler::Grid,
            Self::Random => Sampler::Random,
            Self::Jittered => Sampler::Stratified,
            Self::Sobol => Sampler::Sobol,
        }
    }
}

/// Adaptive sampling: more samples where they are needed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adaptive {
    /// A pixel has enough samples when its estimated standard error is not above this, in luminance; with
    /// [`Pilot::Around`] it has as many samples as their standard deviation is times this.
    pub threshold: f64,
    /// The most samples of a pixel.
    pub most: u32,
    /// What becomes of the first samples.
    pub pilot: Pilot,
}

/// What becomes of the samples that decide how many there are to be.
///
/// To stop when the samples so far look right is to prefer samples that look alike: a bias (Kirk and Arvo 1991,
/// "Unbiased sampling techniques for image synthesis"). It is gone if those that decide do not count.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Pilot {
    /// They count, and decide again and again: fewer rays, a small bias.
    #[default]
    Kept,
    /// They decide once and do not count: no bias.
    Apart,
    /// They count, and decide once how many the pixels around have: no bias, since a pixel's own have no say.
    Around,
}

impl Pilot {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Kept, Self::Apart, Self::Around];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kept => "kept",
            Self::Apart => "apart",
            Self::Around => "around",
        }
    }
}
