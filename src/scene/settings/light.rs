//! Sampling of area lights.

use crate::sampling::{LightSampling, Sampler};

/// Shadow rays to area lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaLightSampling {
    /// Shadow rays to a light, a hit.
    pub samples: u32,
    /// Point set of the points on the light.
    pub sampler: Sampler,
    /// Density of the points: even on the light's area, or by what each point contributes.
    pub density: LightSampling,
}

impl Default for AreaLightSampling {
    fn default() -> Self {
        Self {
            samples: 16,
            sampler: Sampler::default(),
            density: LightSampling::default(),
        }
    }
}
