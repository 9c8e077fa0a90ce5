//! The knobs that a scene really has: what may be turned to trade time for accuracy.

use super::effort::Effort;
use super::robust;
use crate::accel::AccelKind;
use crate::math::{LightSampling, Sampler};
use crate::scene::effects::effects;
use crate::scene::{Adaptive, Pilot, Sampling, Settings, limits};
use crate::shading::Effect;
use crate::world::World;

/// What is added to the seed of a reference, so that it shares no random number with what it judges.
const OTHER_SEED: u64 = 0x5eed_0f7e;

/// Shapes up to which testing all of them for every ray is worth showing.
const FEW_SHAPES: usize = 300;

/// The group of all that is about samples of a pixel.
const PIXEL_SAMPLES: &str = "pixel samples";

/// The group of all that is about rays to area lights.
pub const LIGHT_SAMPLES: &str = "light samples";

/// The first samples of a pixel that may have more.
const FIRST: u32 = 4;

/// Something that can be turned while all the rest stays, in one way of turning it.
#[derive(Clone, Debug)]
pub struct Knob {
    /// What is turned.
    pub group: &'static str,
    /// Which way, where there are several: they share a reference, and can be compared.
    pub way: Option<&'static str>,
    /// Its positions, the cheapest first.
    pub steps: Vec<Step>,
    /// The settings of the reference: this knob at its best, with another seed. `None` if turning it never changes the
    /// picture.
    pub reference: Option<Settings>,
    /// The slope of log error over log samples that theory tells, where there is one.
    pub theory: Option<&'static str>,
}

/// A position of a knob.
#[derive(Clone, Debug)]
pub struct Step {
    /// Its name.
    pub name: String,
    /// The samples that it takes, if it is about samples.
    pub samples: Option<u32>,
    /// The whole settings.
    pub settings: Settings,
    /// Whether shapes are tested one by one with the arithmetic of the settings, ours like any other: see
    /// `lab::robust`.
    pub one_by_one: bool,
}

impl Knob {
    /// What is turned, and which way.
    pub fn name(&self) -> String {
        match self.way {
            None => self.group.to_owned(),
            Some(way) => format!("{}, {way}", self.group),
        }
    }

    /// True if it turns the arithmetic that shapes are tested with, and nothing else.
    pub fn is_robust(&self) -> bool {
        self.steps.iter().any(|step| step.one_by_one)
    }

    /// True if a user means it by `name`: its group, or its whole name; with `-` for what is no letter.
    pub fn is_called(&self, name: &str) -> bool {
        let slug = |text: &str| text.replace(", ", "-").replace(' ', "-");
        [slug(self.group), slug(&self.name())].contains(&slug(name))
    }
}

/// The knobs of a scene, those of one group side by side. All else is as `base` asks.
pub fn knobs(world: &World, base: &Settings, effort: Effort) -> Vec<Knob> {
    let called_for = effects(&world.scene);
    let uses = |effect| called_for.has(effect) && base.effects.has(effect);
    let mut knobs: Vec<Knob> = Sampler::ALL
        .map(|sampler| pixel_samples(base, sampler, effort))
        .into();
    knobs.push(thresholds(base, Pilot::Kept, effort));
    knobs.push(thresholds(base, Pilot::Around, effort));
    if uses(Effect::Shadows) && uses(Effect::SoftShadows) {
        let by_area = LightSampling::Area;
        knobs.extend(Sampler::ALL.map(|sampler| light_samples(base, (sampler, by_area), effort)));
        let by_what_it_brings = (Sampler::Sobol, LightSampling::Projected);
        knobs.push(light_samples(base, by_what_it_brings, effort));
    }
    if uses(Effect::Reflection) || uses(Effect::Refraction) {
        knobs.push(depth(base));
        knobs.push(min_weight(base));
    }
    knobs.push(accelerators(world, base));
    let leaves = uses(Effect::Shadows) || uses(Effect::Reflection) || uses(Effect::Refraction);
    knobs.extend(robust::knobs(&world.scene.shapes, base, leaves));
    knobs
}

fn by_samples(effort: Effort, with: impl Fn(u32) -> Settings) -> Vec<Step> {
    let step = |n: u32| Step {
        name: n.to_string(),
        samples: Some(n),
        settings: with(n),
        one_by_one: false,
    };
    effort.samples().map(step).collect()
}

/// Samples a pixel.
fn pixel_samples(base: &Settings, sampler: Sampler, effort: Effort) -> Knob {
    let theory = match sampler {
        Sampler::Grid => "-1 or less: it stalls at edges along its cells",
        Sampler::Random => "-0.5",
        Sampler::Stratified => "-0.75 at edges, -1 where it is smooth",
        Sampler::Sobol => "-0.75 at edges, -1.5 where it is smooth",
    };
    Knob {
        group: PIXEL_SAMPLES,
        way: Some(Sampling::of(sampler).name()),
        steps: by_samples(effort, |n| sampled(base, n, sampler)),
        reference: Some(best_sampled(base, effort)),
        theory: Some(theory),
    }
}

/// Samples where they are needed, by how small a pixel's standard error is to be: another way to the same picture.
fn thresholds(base: &Settings, pilot: Pilot, effort: Effort) -> Knob {
    let with = |threshold| {
        sampled(base, FIRST, Sampler::Sobol).with(|s| {
            s.pixel.adaptive = Some(Adaptive {
                threshold,
                most: effort.most.max(4 * FIRST),
                pilot,
            })
        })
    };
    // What is an error with one is a part of a standard deviation with the other.
    let (way, thresholds) = match pilot {
        Pilot::Around => ("around", [0.03, 0.01, 0.003, 0.001]),
        _ => ("adaptive", [0.1, 0.03, 0.01, 0.003]),
    };
    Knob {
        way: Some(way),
        reference: Some(best_sampled(base, effort)),
        ..plain(PIXEL_SAMPLES, thresholds, f64::to_string, with)
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
) -> Knob {
    let with = |light_samples, sampler, light_sampling| {
        sampled(base, base.pixel.samples, Sampler::Grid).with(|s| {
            s.light.samples = light_samples;
            s.light.sampler = sampler;
            s.light.density = light_sampling;
        })
    };
    let most = effort.reference.min(limits::MAX_LIGHT_SAMPLES);
    Knob {
        group: LIGHT_SAMPLES,
        way: Some(match light_sampling {
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

/// A knob whose positions are not samples.
pub fn plain<T>(
    group: &'static str,
    positions: impl IntoIterator<Item = T>,
    name: impl Fn(&T) -> String,
    with: impl Fn(T) -> Settings,
) -> Knob {
    let step = |position: T| Step {
        name: name(&position),
        samples: None,
        settings: with(position),
        one_by_one: false,
    };
    Knob {
        group,
        way: None,
        steps: positions.into_iter().map(step).collect(),
        reference: None,
        theory: None,
    }
}

fn depth(base: &Settings) -> Knob {
    let with = |depth| base.with(|s| s.recursion.depth = depth);
    Knob {
        reference: Some(with(16)),
        ..plain("depth", 0..=6, u32::to_string, with)
    }
}

fn min_weight(base: &Settings) -> Knob {
    let with = |min_weight| {
        base.with(|s| {
            s.recursion.min_weight = min_weight;
            s.recursion.depth = base.recursion.depth.max(12);
        })
    };
    let weights = [0.3, 0.1, 0.03, 0.01, 1.0 / 512.0];
    Knob {
        reference: Some(with(0.0)),
        ..plain("min weight", weights, |w| format!("{w:.3}"), with)
    }
}

/// Every accelerator gives the same picture.
fn accelerators(world: &World, base: &Settings) -> Knob {
    let few = world.scene.shapes.len() <= FEW_SHAPES;
    let kinds = AccelKind::ALL
        .into_iter()
        .filter(|kind| few || *kind != AccelKind::List);
    let with = |accel| base.with(|s| s.accel = accel);
    plain("accelerator", kinds, |a| a.name().to_owned(), with)
}
