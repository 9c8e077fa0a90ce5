//! The estimate of a pixel: its colour, what is known of its error, and what it cost.

use crate::math::Rgb;
use crate::world::RayCuts;

/// A traced pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Its linear colour: the weighted sum of its samples' radiances, added in their order.
    pub color: Rgb,
    /// Rays that it cost.
    pub rays: u64,
    /// What it used of its budget besides camera rays: secondary and shadow rays, and lights that needed no shadow ray.
    pub budget_used: u64,
    /// True if a limit cut it short, so that its colour is not all that was asked for.
    pub truncated: bool,
    /// Rays that the limits of recursion left out.
    pub cuts: RayCuts,
    /// The number of its samples.
    pub samples: u32,
    /// The estimated standard error of its luminance (see [`crate::sampling::batch_means`]); infinite if it is unknown.
    pub error: f64,
    /// The number of samples whose radiance was NaN or infinite; they count as black.
    pub non_finite: u32,
    /// The index of the first of them.
    pub first_non_finite: Option<u32>,
}

impl Default for Pixel {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl Pixel {
    /// A pixel without samples. (A constant: it is copied for every pixel of a picture.)
    pub const EMPTY: Self = Self {
        color: Rgb::BLACK,
        rays: 0,
        budget_used: 0,
        truncated: false,
        cuts: RayCuts::NONE,
        samples: 0,
        error: f64::INFINITY,
        non_finite: 0,
        first_non_finite: None,
    };

    /// The share of its light that it lost to the limits of recursion, if what was left out is as bright as the rest: the
    /// weight of the rays that were left out, over its samples.
    pub fn cut_share(&self) -> f64 {
        self.cuts.weight / f64::from(self.samples.max(1))
    }
}
