//! Parameters that a scene really has: what may be varied to trade time for accuracy.

use super::arithmetic_sweep;
use super::effort::Effort;
use super::parameter::{LIGHT_SAMPLES, PIXEL_SAMPLES, Parameter, ParameterStep, swept};
use crate::accel::AccelKind;
use crate::sampling::{LightSampling, Sampler};
use crate::scene::effects::effects;
use crate::scene::{Adaptive, Pilot, Sampling, Settings, limits};
use crate::shading::Effect;
use crate::world::World;

/// What is added to the seed of a reference, so that it shares no random number with what it judges.
const OTHER_SEED: u64 = 0x5eed_0f7e;

/// Shapes up to which testing all of them for every ray is worth showing.
const FEW_SHAPES: usize = 300;

/// The first samples of a pixel that may have more.
const FIRST: u32 = 4;

/// Parameters of a scene, those of one group side by side. All else is as `base` asks.
pub fn parameters(world: &World, base: &Settings, effort: Effort) -> Vec<Parameter> {
    let called_for = effects(&world.scene);
    let uses = |effect| called_for.has(effect) && base.effects.has(effect);
    let mut parameters: Vec<Parameter> = Sampler::ALL
        .map(|sampler| pixel_samples(base, sampler, effort))
        .into();
    parameters.push(thresholds(base, Pilot::Kept, effort));
    parameters.push(thresholds(base, Pilot::Around, effort));
    if uses(Effect::Shadows) && uses(Effect::SoftShadows) {
        let by_area = LightSampling::Area;
        parameters
            .extend(Sampler::ALL.map(|sampler| light_samples(base, (sampler, by_area), effort)));
        let by_what_it_brings = (Sampler::Sobol, LightSampling::Projected);
        parameters.push(light_samples(base, by_what_it_brings, effort));
    }
    if uses(Effect::Reflection) || uses(Effect::Refraction) {
        parameters.push(depth(base));
        parameters.push(min_weight(base));
    }
    parameters.push(accelerators(world, base));
    let leaves = uses(Effect::Shadows) || uses(Effect::Reflection) || uses(Effect::Refraction);
    parameters.extend(arithmetic_sweep::parameters(
        &world.scene.shapes,
        base,
        leaves,
    ));
    parameters
}

fn by_samples(effort: Effort, with: impl Fn(u32) -> Settings) -> Vec<ParameterStep> {
    let step = |n: u32| ParameterStep {
        samples: Some(n),
        ..ParameterStep::new(n.to_string(), with(n))
    };
    effort.samples().map(step).collect()
}

/// Samples a pixel.
fn pixel_samples(base: &Settings, sampler: Sampler, effort: Effort) -> Parameter {
    let theory = match sampler {
        Sampler::Grid => "-1 or less: it stalls at edges along its cells",
        Sampler::Random => "-0.5",
        Sampler::Stratified => "-0.75 at edges, -1 where it is smooth",
        Sampler::Sobol => "-0.75 at edges, -1.5 where it is smooth",
    };
    Parameter {
        group: PIXEL_SAMPLES,
        variant: Some(Sampling::of(sampler).name()),
        steps: by_samples(effort, |n| sampled(base, n, sampler)),
        reference: Some(best_sampled(base, effort)),
        theory: Some(theory),
    }
}

/// Adaptive sampling, by how small a pixel's standard error is to be: another way to the same picture.
fn thresholds(base: &Settings, pilot: Pilot, effort: Effort) -> Parameter {
    // What is an error with one is a part of a standard deviation with the other.
    let (variant, thresholds) = match pilot {
        Pilot::Around => ("around", [0.03, 0.01, 0.003, 0.001]),
        _ => ("adaptive", [0.1, 0.03, 0.01, 0.003]),
    };
    let step = |threshold: f64| {
        let adaptive = Some(Adaptive {
            threshold,
            most: effort.most.max(4 * FIRST),
            pilot,
        });
        let sampled = sampled(base, FIRST, Sampler::Sobol);
        ParameterStep::new(
            threshold.to_string(),
            sampled.with(|s| s.pixel.adaptive = adaptive),
        )
    };
    Parameter {
        group: PIXEL_SAMPLES,
        variant: Some(variant),
        steps: thresholds.map(step).to_vec(),
        reference: Some(best_sampled(base, effort)),
        theory: None,
    }
}

/// So many samples a pixel, in one set.
fn sampled(base: &Settings, samples: u32, sampler: Sampler) -> Settings {
    base.with(|s| {
        s.pixel.samples = samples;
        s.pixel.sets = 1;
        s.pixel.sampler = sampler;
        s.pixel.adaptive = None;
    })
}

/// The reference of all that is about samples of a pixel.
fn best_sampled(base: &Settings, effort: Effort) -> Settings {
    let samples = effort.reference.min(limits::MAX_SAMPLES);
    sampled(base, samples, Sampler::Sobol).with(|s| s.seed = base.seed ^ OTHER_SEED)
}

/// Rays to area lights. Always from the same places on the film, so that nothing else is by chance.
fn light_samples(
    base: &Settings,
    (sampler, light_sampling): (Sampler, LightSampling),
    effort: Effort,
) -> Parameter {
    let with = |light_samples, sampler, light_sampling| {
        sampled(base, base.pixel.samples, Sampler::Grid).with(|s| {
            s.light.samples = light_samples;
            s.light.sampler = sampler;
            s.light.density = light_sampling;
        })
    };
    let most = effort.reference.min(limits::MAX_LIGHT_SAMPLES);
    Parameter {
        group: LIGHT_SAMPLES,
        variant: Some(match light_sampling {
            LightSampling::Area => sampler.name(),
            LightSampling::Projected => light_sampling.name(),
        }),
        steps: by_samples(effort, |n| with(n, sampler, light_sampling)),
        reference: Some(
            with(most, Sampler::Sobol, LightSampling::Area)
                .with(|s| s.seed = base.seed ^ OTHER_SEED),
        ),
        theory: Some(match sampler {
            Sampler::Grid => "none: it stalls at edges along its cells",
            Sampler::Random => "-0.5",
            Sampler::Stratified => "-0.75 at edges, -1 where it is smooth",
            Sampler::Sobol => "-0.75 at edges, -1.5 where it is smooth",
        }),
    }
}

/// Bounces.
fn depth(base: &Settings) -> Parameter {
    Parameter {
        reference: Some(base.with(|s| s.recursion.depth = 16)),
        ..swept("depth", "depth", base)
    }
}

/// Rays that are not sent, with so many bounces that they would be many.
fn min_weight(base: &Settings) -> Parameter {
    let base = base.with(|s| s.recursion.depth = s.recursion.depth.max(12));
    Parameter {
        reference: Some(base.with(|s| s.recursion.min_weight = 0.0)),
        ..swept("min weight", "min-weight", &base)
    }
}

/// Accelerators, which all give the same picture.
fn accelerators(world: &World, base: &Settings) -> Parameter {
    let few = world.scene.shapes.len() <= FEW_SHAPES;
    let mut accelerators = swept("accelerator", "accel", base);
    let is_worth_it = |step: &ParameterStep| few || step.settings.accel != AccelKind::List;
    accelerators.steps.retain(is_worth_it);
    accelerators
}
