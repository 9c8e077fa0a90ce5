//! The settings in JSON: every knob that changes the picture.

use schemars::JsonSchema;
use serde::Serialize;

use crate::geometry::Arithmetic;
use crate::math::{Filter, LightSampling, Sampler};
use crate::scene::{Effect, Pilot, Sampling, Scene, Settings};
use crate::shading::Fresnel;

/// Every knob that changes the picture, and the accelerator, which never does.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Settings")]
pub struct Knobs {
    samples: u32,
    /// Into how many sets the samples are parted, each spread evenly by itself; absent for one.
    #[serde(skip_serializing_if = "Option::is_none")]
    sets: Option<u32>,
    sampling: Sampling,
    filter: Filter,
    /// In pixels.
    filter_radius: f64,
    /// If samples decide how many there are; then `samples` is how many there are at first.
    #[serde(skip_serializing_if = "Option::is_none")]
    adaptive: Option<AdaptiveKnobs>,
    light_samples: u32,
    sampler: Sampler,
    light_sampling: LightSampling,
    depth: u32,
    min_weight: f64,
    seed: u64,
    fresnel: Fresnel,
    /// Effects that the user left out: the picture is not that of the whole scene.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    without: Vec<&'static str>,
    exposure: f64,
    max_rays: u64,
    accel: &'static str,
    /// Where the arithmetic is not raytree's own: the picture shows what goes wrong with it.
    #[serde(skip_serializing_if = "Option::is_none")]
    arithmetic: Option<ArithmeticKnobs>,
}

/// When a pixel has enough samples.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Adaptive")]
struct AdaptiveKnobs {
    /// When the estimated standard error of its luminance is not above this. With "around" it has as many samples as their
    /// standard deviation is times this, to the nearest doubling of the first ones.
    threshold: f64,
    max_samples: u32,
    /// "kept": all samples count. "apart": the first ones decide how many others there are, and have the weight 0.
    /// "around": all count; the first ones of the pixels around decided how many there are.
    pilot: Pilot,
}

/// What shapes were tested with.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Arithmetic")]
struct ArithmeticKnobs {
    /// "plane-edges", "moller-trumbore" or "watertight".
    triangle: &'static str,
    /// "none", "fixed:" and a number of metres, or "bounded".
    offset: String,
    /// "naive" or "stable".
    quadratic: &'static str,
    /// "single" or "double".
    precision: &'static str,
}

/// The knobs of these settings.
pub fn knobs(settings: &Settings, scene: &Scene) -> Knobs {
    let arithmetic = settings.arithmetic;
    Knobs {
        samples: settings.pixel.samples,
        sets: (settings.pixel.sets > 1).then_some(settings.pixel.sets),
        sampling: Sampling::of(settings.pixel.sampler),
        filter: settings.pixel.filter,
        filter_radius: settings.pixel.filter_radius,
        adaptive: settings.pixel.adaptive.map(|adaptive| AdaptiveKnobs {
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
        without: settings.left_out(scene).map(Effect::name).collect(),
        exposure: settings.image.exposure,
        max_rays: settings.recursion.max_rays,
        accel: settings.accel.name(),
        arithmetic: (arithmetic != Arithmetic::default()).then(|| ArithmeticKnobs {
            triangle: arithmetic.triangle.name(),
            offset: arithmetic.offset.to_string(),
            quadratic: arithmetic.quadratic.name(),
            precision: arithmetic.precision.name(),
        }),
    }
}
