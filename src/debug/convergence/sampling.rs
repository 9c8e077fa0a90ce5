//! Settings of a point of the convergence curve.

use crate::sampling::Sampler;
use crate::scene::{Effect, PixelSampling, Settings};
use crate::world::World;

/// Sets that jittered samples are put into.
const SETS: u32 = 8;

/// The settings with so many samples a pixel, such that their spread tells the standard error: the samples of a grid
/// are not random, so Sobol's points replace them; jittered ones come in sets (see [`crate::sampling::batch_means`]).
pub fn with_samples(settings: &Settings, samples: u32) -> Settings {
    let PixelSampling { sampler, sets, .. } = settings.pixel;
    settings.with(|s| {
        s.pixel.samples = samples;
        s.pixel.sets = match sampler {
            Sampler::Stratified if samples >= 2 * SETS => sets.max(SETS).min(samples),
            _ => sets.min(samples),
        };
        s.pixel.sampler = match sampler {
            Sampler::Grid => Sampler::Sobol,
            other => other,
        };
        s.pixel.adaptive = None;
        s.pixel.errors = true;
    })
}

/// True if anything in a pixel is left to chance.
pub fn has_chance(world: &World, settings: &Settings) -> bool {
    let lights = &world.scene.lights;
    let soft = lights.iter().any(|l| l.kind.is_area());
    settings.pixel.samples > 1
        || settings.pixel.adaptive.is_some()
        || (soft
            && settings.effects.has(Effect::SoftShadows)
            && settings.effects.has(Effect::Shadows))
}
