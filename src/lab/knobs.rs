//! The knobs that a scene really has: what may be turned to trade time for accuracy.

use crate::accel::AccelKind;
use crate::math::Sampler;
use crate::scene::effects::{Effect, effects};
use crate::scene::{Sampling, Settings, World};

/// What is added to the seed of a reference, so that it shares no random number with what it judges.
const OTHER_SEED: u64 = 0x5eed_0f7e;

/// Shapes up to which testing all of them for every ray is worth showing.
const FEW_SHAPES: usize = 300;

/// Something that can be turned while all the rest stays.
#[derive(Clone, Debug)]
pub struct Knob {
    /// Its name.
    pub name: String,
    /// Its positions, the cheapest first: their names and the whole settings.
    pub steps: Vec<(String, Settings)>,
    /// The settings of the reference: this knob at its best, with another seed. `None` if turning it never changes the
    /// picture.
    pub reference: Option<Settings>,
    /// The slope of log error over log samples that theory tells, where there is one.
    pub theory: Option<&'static str>,
}

/// The knobs of a scene. All else is as `base` asks.
pub fn knobs(world: &World, base: &Settings) -> Vec<Knob> {
    let called_for = effects(&world.scene);
    let uses = |effect| called_for.has(effect) && base.effects.has(effect);
    let mut knobs = vec![pixel_samples(base)];
    if uses(Effect::Shadows) && uses(Effect::SoftShadows) {
        knobs.extend(Sampler::ALL.map(|sampler| light_samples(base, sampler)));
    }
    if uses(Effect::Reflection) || uses(Effect::Refraction) {
        knobs.push(depth(base));
        knobs.push(min_weight(base));
    }
    knobs.push(accelerators(world, base));
    knobs
}

/// Samples a pixel. One ray to each area light a sample: the samples of a pixel add up.
fn pixel_samples(base: &Settings) -> Knob {
    let with = |samples| Settings {
        samples,
        sampling: Sampling::Jittered,
        light_samples: 1,
        ..*base
    };
    Knob {
        name: "pixel samples, jittered".to_owned(),
        steps: [1, 4, 16, 64].map(|n| (n.to_string(), with(n))).to_vec(),
        reference: Some(Settings {
            seed: base.seed ^ OTHER_SEED,
            ..with(512)
        }),
        theory: Some("-0.5 where all is noise, -0.75 at edges, -1 where it is smooth"),
    }
}

/// Rays to area lights, one sampler. One sample in the middle of each pixel, so that nothing else is by chance.
fn light_samples(base: &Settings, sampler: Sampler) -> Knob {
    let with = |light_samples, sampler| Settings {
        samples: 1,
        sampling: Sampling::Regular,
        light_samples,
        sampler,
        ..*base
    };
    Knob {
        name: format!("light samples, {}", sampler.name()),
        steps: [1, 4, 16, 64]
            .map(|n| (n.to_string(), with(n, sampler)))
            .to_vec(),
        reference: Some(Settings {
            seed: base.seed ^ OTHER_SEED,
            ..with(1024, Sampler::Sobol)
        }),
        theory: Some(match sampler {
            Sampler::Grid => "none: it stalls at edges along its cells",
            Sampler::Random => "-0.5",
            Sampler::Stratified => "-0.75 at edges, -1 where it is smooth",
            Sampler::Sobol => "-0.75 at edges, -1.5 where it is smooth",
        }),
    }
}

/// Without what else is by chance.
fn plain(base: &Settings) -> Settings {
    Settings {
        samples: 1,
        sampling: Sampling::Regular,
        light_samples: 1,
        ..*base
    }
}

fn depth(base: &Settings) -> Knob {
    let with = |depth| Settings {
        depth,
        ..plain(base)
    };
    Knob {
        name: "depth".to_owned(),
        steps: (0..=6).map(|n| (n.to_string(), with(n))).collect(),
        reference: Some(with(16)),
        theory: None,
    }
}

fn min_weight(base: &Settings) -> Knob {
    let with = |min_weight| Settings {
        min_weight,
        depth: base.depth.max(12),
        ..plain(base)
    };
    Knob {
        name: "min weight".to_owned(),
        steps: [0.3, 0.1, 0.03, 0.01, 1.0 / 512.0]
            .map(|w| (format!("{w:.3}"), with(w)))
            .to_vec(),
        reference: Some(with(0.0)),
        theory: None,
    }
}

/// Every accelerator gives the same picture.
fn accelerators(world: &World, base: &Settings) -> Knob {
    let few = world.scene.shapes.len() <= FEW_SHAPES;
    let kinds = AccelKind::ALL
        .into_iter()
        .filter(|kind| few || *kind != AccelKind::List);
    Knob {
        name: "accelerator".to_owned(),
        steps: kinds
            .map(|accel| {
                let settings = Settings {
                    accel,
                    ..plain(base)
                };
                (accel.name().to_owned(), settings)
            })
            .collect(),
        reference: None,
        theory: None,
    }
}
