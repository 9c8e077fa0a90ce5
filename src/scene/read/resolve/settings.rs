//! Settings of a scene file.

use super::checks::number;
use crate::scene::limits::{MAX_LIGHT_SAMPLES, MAX_RADIANCE, MAX_SAMPLES, size_problem};
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::SettingsFile;
use crate::scene::{AreaLightSampling, Image, PixelSampling, Recursion, Sampling, Settings};

/// Settings, with the program's default for each that the file does not give.
pub fn settings(file: &SettingsFile, path: &FieldPath) -> Result<Settings, SceneError> {
    let default = Settings::default();
    let [width, height] = file
        .size
        .unwrap_or([default.image.width, default.image.height]);
    if let Some(problem) = size_problem(width, height) {
        let path = path.key("size");
        return Err(path.error(problem, "write [width, height], such as [320, 240]"));
    }
    let samples = file.samples.unwrap_or(default.pixel.samples);
    if samples == 0 || samples > MAX_SAMPLES {
        return Err(path.key("samples").error(
            format!("{samples} samples a pixel are not possible"),
            format!("write a whole number from 1 to {MAX_SAMPLES}"),
        ));
    }
    let optional = |value: Option<f64>, default: f64, key: &str| {
        number(
            value.unwrap_or(default),
            [0.0, MAX_RADIANCE],
            &path.key(key),
        )
    };
    let light_samples = file.light_samples.unwrap_or(default.light.samples);
    if light_samples == 0 || light_samples > MAX_LIGHT_SAMPLES {
        return Err(path.key("light_samples").error(
            format!("{light_samples} shadow rays to a light are not possible"),
            format!("write a whole number from 1 to {MAX_LIGHT_SAMPLES}"),
        ));
    }
    Ok(Settings {
        image: Image {
            width,
            height,
            exposure: optional(file.exposure, default.image.exposure, "exposure")?,
        },
        pixel: PixelSampling {
            samples,
            sampler: file
                .sampling
                .map_or(default.pixel.sampler, Sampling::sampler),
            ..default.pixel
        },
        light: AreaLightSampling {
            samples: light_samples,
            sampler: file.sampler.unwrap_or(default.light.sampler),
            density: file.light_sampling.unwrap_or(default.light.density),
        },
        recursion: Recursion {
            depth: file.depth.unwrap_or(default.recursion.depth),
            min_weight: optional(file.min_weight, default.recursion.min_weight, "min_weight")?,
            ..default.recursion
        },
        seed: file.seed.unwrap_or(default.seed),
        fresnel: file.fresnel.unwrap_or(default.fresnel),
        ..default
    })
}
