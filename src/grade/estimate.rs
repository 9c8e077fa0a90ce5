//! Monte Carlo estimates: marked by a test that a right tracer passes with a known chance.
//!
//! An estimate has no right digits. Asked are single samples of what a light adds by the diffuse term at a pixel, in luminance.
//! The mean test is Bernstein's inequality: with n independent samples of variance v, none above M, the mean is farther from the
//! true one than e with a chance of at most alpha, where e = M L / 3n + sqrt((M L / 3n)^2 + 2 v L / n), L = ln(2 k / alpha), for
//! all of k pixels together. It holds for every n and however skewed the samples are.
//! Source: Bernstein 1924; Boucheron, Lugosi and Massart 2013, "Concentration inequalities", section 2.8.

use super::task::{EstimateFile, TaskScene};
use crate::probe::TermKind;
use crate::sampling::Sampler;
use crate::scene::{Bends, Settings};
use crate::trace::facts::FactName;

/// The chance that a check of a right tracer fails.
const ALPHA: f64 = 1e-6;

/// Shadow rays of a traced pixel, and pixels traced with different seeds: 2^18 samples.
const SAMPLES: u32 = 1 << 12;
const SEEDS: u64 = 1 << 6;

/// What is known of the samples of a light at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EstimateReference {
    /// The pixel.
    pub pixel: (u32, u32),
    /// Their mean.
    pub mean: f64,
    /// Their variance.
    pub variance: f64,
    /// The largest of them.
    pub largest: f64,
}

impl EstimateReference {
    /// How far the mean of n samples may be off, for one of k pixels.
    pub fn allowed(&self, n: f64, k: usize) -> f64 {
        let l = libm::log(2.0 * k as f64 / ALPHA);
        let linear = self.largest * l / (3.0 * n);
        linear + (linear * linear + 2.0 * self.variance * l / n).sqrt()
    }
}

/// The references of a check.
pub fn references(
    scene: &TaskScene,
    pixels: &[(u32, u32)],
    asked: &EstimateFile,
    bends: Bends,
) -> Result<Vec<EstimateReference>, String> {
    let lights = &scene.world.scene.lights;
    let Some(light) = lights.iter().find(|light| light.name == asked.light) else {
        return Err(format!(
            "`estimate.light` names `{}`, and the scene has no such light",
            asked.light
        ));
    };
    if !light.kind.is_area() {
        return Err(format!(
            "`{}` has no area: there is nothing to estimate",
            asked.light
        ));
    }
    if asked.samples == 0 || asked.error.is_nan() || asked.error <= 0.0 {
        return Err("`estimate` needs `samples` and `error` above 0".to_owned());
    }
    let settings = sampled(&scene.settings, bends);
    let reference = |pixel: &(u32, u32)| {
        let mut values = Vec::new();
        for seed in 0..SEEDS {
            values.extend(samples_of(
                scene,
                &settings.with(|s| s.seed = seed),
                *pixel,
                &asked.light,
            ));
        }
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let squares = values.iter().map(|x| (x - mean) * (x - mean));
        EstimateReference {
            pixel: *pixel,
            mean,
            variance: squares.sum::<f64>() / values.len() as f64,
            largest: values.iter().copied().fold(0.0, f64::max),
        }
    };
    Ok(pixels.iter().map(reference).collect())
}

/// The settings with which single samples are drawn: anywhere on the light's area, by chance.
pub fn sampled(settings: &Settings, bends: Bends) -> Settings {
    settings.with(|s| {
        s.bends = bends;
        s.light.samples = SAMPLES;
        s.light.sampler = Sampler::Random;
        s.light.density = crate::sampling::LightSampling::Area;
        s.pixel.samples = 1;
    })
}

/// Single samples of a light's diffuse term at what the eye ray of a pixel hits, in luminance.
pub fn samples_of(
    scene: &TaskScene,
    settings: &Settings,
    pixel: (u32, u32),
    light: &str,
) -> Vec<f64> {
    let facts = super::task::reference(scene, settings, pixel);
    let count = settings.light.samples;
    let mut values = vec![0.0; count as usize];
    let Some(root) = facts.rays.first() else {
        return values;
    };
    for (name, fact) in &root.facts {
        if let FactName::Term(TermKind::Diffuse, Some(of), sample) = name
            && of == light
            && let crate::trace::facts::Fact::Color(color) = fact
            && let Some(value) = values.get_mut(*sample as usize)
        {
            *value = color.luminance() * f64::from(count);
        }
    }
    values
}
