//! The samples of a pixel: where they lie, and how many there are.

use serde::{Deserialize, Serialize};

use crate::math::Sampler;

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

/// More samples where they are needed.
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
