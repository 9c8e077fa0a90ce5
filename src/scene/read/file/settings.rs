//! Settings in a scene file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::math::{LightSampling, Sampler};
use crate::scene::Sampling;
use crate::shading::Fresnel;

/// How a scene is rendered if the user asks for nothing else. What is left out has the default of the program.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SettingsFile {
    /// What they are there for.
    pub note: Option<String>,
    /// Width and height of the picture in pixels.
    pub size: Option<[u32; 2]>,
    /// Samples a pixel.
    pub samples: Option<u32>,
    /// Where the samples of a pixel lie.
    pub sampling: Option<Sampling>,
    /// Shadow rays to an area light, a hit.
    pub light_samples: Option<u32>,
    /// Where on the light they go.
    pub sampler: Option<Sampler>,
    /// In proportion to what.
    pub light_sampling: Option<LightSampling>,
    /// How many times a ray may bounce.
    pub depth: Option<u32>,
    /// Rays that could add less than this to the pixel are not sent.
    pub min_weight: Option<f64>,
    /// Seed of all random numbers.
    pub seed: Option<u64>,
    /// How transparent surfaces share light between reflection and transmission.
    pub fresnel: Option<Fresnel>,
    /// Factor on the picture before it is clamped.
    pub exposure: Option<f64>,
}
