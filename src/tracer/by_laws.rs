//! Samples of a light as the laws give them.

use super::laws::Laws;
use super::light_sampler::{LightSampler, SampledRay};
use crate::shading::{LightKind, LightSample, ShadingPoint};

/// Sampler of a light whose shadow rays are those that the laws give.
pub struct ByLaws<'a, S, L> {
    /// What samples the light.
    pub sampler: &'a S,
    /// The laws.
    pub laws: L,
    /// The point.
    pub point: &'a ShadingPoint<'a>,
    /// The light.
    pub kind: &'a LightKind,
}

impl<S: LightSampler, L: Laws> LightSampler for ByLaws<'_, S, L> {
    #[inline(always)]
    fn samples(&self) -> u32 {
        self.sampler.samples()
    }

    fn light(&self, sample: u32) -> Option<LightSample> {
        self.sampler.light(sample)
    }

    fn to_light(&self, light: Option<LightSample>) -> SampledRay {
        self.sampler.to_light(light)
    }

    #[inline(always)]
    fn shadow_ray(&self, sample: u32) -> SampledRay {
        self.laws
            .shadow_ray(self.sampler, sample, self.point, self.kind)
    }

    fn sight(&self, sample: u32) -> SampledRay {
        self.sampler.sight(sample)
    }
}
