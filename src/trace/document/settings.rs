//! The settings of a document: every knob that changes the picture.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::{Arithmetic, PatchMethod, QuarticMethod};
use crate::sampling::{Filter, LightSampling, Sampler};
use crate::scene::{Pilot, Sampling, Scene, Settings};
use crate::shading::{Fresnel, ShadingModel};

/// Every knob that changes the picture, and the accelerator, which never does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DocumentSettings {
    /// Samples a pixel.
    pub samples: u32,
    /// Into how many sets the samples are parted, each spread evenly by itself; absent for one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sets: Option<u32>,
    /// How samples lie on the film.
    pub sampling: Sampling,
    /// The reconstruction filter.
    pub filter: Filter,
    /// In pixels.
    pub filter_radius: f64,
    /// If samples decide how many there are; then `samples` is how many there are at first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub adaptive: Option<AdaptiveSettings>,
    /// Shadow rays to an area light, a hit.
    pub light_samples: u32,
    /// How points on area lights are chosen.
    pub sampler: Sampler,
    /// In proportion to what they are chosen.
    pub light_sampling: LightSampling,
    /// Bounces at most.
    pub depth: u32,
    /// Rays of less throughput are not sent.
    pub min_weight: f64,
    /// Of all random numbers.
    pub seed: u64,
    /// The model of reflectance.
    pub fresnel: Fresnel,
    /// The model by which all triangles were shaded; absent where each object decides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shading: Option<ShadingModel>,
    /// Effects that the user left out: the picture is not that of the whole scene.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub without: Vec<String>,
    /// Factor before the sRGB curve.
    pub exposure: f64,
    /// Rays of the picture at most.
    pub max_rays: u64,
    /// The accelerator; it changes no value but `traversal`.
    pub accel: String,
    /// Where the arithmetic is not raytree's own: the picture shows what goes wrong with it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub arithmetic: Option<ArithmeticSettings>,
    /// Laws that are exchanged for mistakes, by name: the tree is that of a wrong tracer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bent: Option<String>,
}

/// When a pixel has enough samples.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AdaptiveSettings {
    /// When the estimated standard error of its luminance is not above this. With "around" it has as many samples as their
    /// standard deviation is times this, to the nearest doubling of the first ones.
    pub threshold: f64,
    /// Samples at most.
    pub max_samples: u32,
    /// "kept": all samples count. "apart": the first ones decide how many others there are, and have the weight 0.
    /// "around": all count; the first ones of the pixels around decided how many there are.
    pub pilot: Pilot,
}

/// What shapes were tested with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ArithmeticSettings {
    /// "plane-edges", "moller-trumbore" or "watertight".
    pub triangle: String,
    /// "none", "fixed:" and a number of metres, or "bounded".
    pub offset: String,
    /// "naive" or "stable".
    pub quadratic: String,
    /// "plain", "moved" or "polished".
    #[serde(default = "ArithmeticSettings::polished")]
    pub quartic: String,
    /// "exact" or "triangles:N".
    #[serde(default = "ArithmeticSettings::exact")]
    pub patch_test: String,
    /// "single" or "double".
    pub precision: String,
}

impl ArithmeticSettings {
    /// What trees from before there were tori mean.
    fn polished() -> String {
        QuarticMethod::default().name().to_owned()
    }

    /// What trees from before there was a choice mean.
    fn exact() -> String {
        PatchMethod::default().to_string()
    }
}

/// The settings with which a scene is traced.
pub fn settings(settings: &Settings, scene: &Scene) -> DocumentSettings {
    let arithmetic = settings.arithmetic;
    DocumentSettings {
        samples: settings.pixel.samples,
        sets: (settings.pixel.sets > 1).then_some(settings.pixel.sets),
        sampling: Sampling::of(settings.pixel.sampler),
        filter: settings.pixel.filter,
        filter_radius: settings.pixel.filter_radius,
        adaptive: settings.pixel.adaptive.map(|adaptive| AdaptiveSettings {
            threshold: adaptive.threshold,
            max_samples: adaptive.most,
            pilot: adaptive.pilot,
        }),
        light_samples: settings.light.samples,
        sampler: settings.light.sampler,
        light_sampling: settings.light.density,
        depth: settings.recursion.depth,
        min_weight: settings.recursion.min_weight,
        seed: settings.seed,
        fresnel: settings.fresnel,
        shading: settings.shading,
        without: settings
            .left_out(scene)
            .map(|e| e.name().to_owned())
            .collect(),
        exposure: settings.image.exposure,
        max_rays: settings.recursion.max_rays,
        accel: settings.accel.name().to_owned(),
        arithmetic: (arithmetic != Arithmetic::default()).then(|| ArithmeticSettings {
            triangle: arithmetic.triangle.name().to_owned(),
            offset: arithmetic.offset.to_string(),
            quadratic: arithmetic.quadratic.name().to_owned(),
            quartic: arithmetic.quartic.name().to_owned(),
            patch_test: arithmetic.patch.to_string(),
            precision: arithmetic.precision.name().to_owned(),
        }),
        bent: (!settings.bends.is_empty()).then(|| settings.bends.to_string()),
    }
}
