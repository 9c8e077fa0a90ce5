//! Settings as the flags of a command line: what must be said to do the same again.

use super::{Sampling, Scene, Settings};

/// The settings that are not the scene's own, as names and values of flags.
pub fn flags(now: &Settings, scene: &Scene) -> Vec<(&'static str, String)> {
    let word = |name: &dyn std::fmt::Debug| format!("{name:?}").to_lowercase();
    let values = |s: &Settings| {
        [
            ("samples", s.pixel.samples.to_string()),
            ("sets", s.pixel.sets.to_string()),
            ("sampling", Sampling::of(s.pixel.sampler).name().to_owned()),
            ("filter", s.pixel.filter.name().to_owned()),
            ("filter-radius", s.pixel.filter_radius.to_string()),
            ("light-samples", s.light.samples.to_string()),
            ("sampler", s.light.sampler.name().to_owned()),
            ("light-sampling", s.light.density.name().to_owned()),
            ("depth", s.recursion.depth.to_string()),
            ("min-weight", s.recursion.min_weight.to_string()),
            ("fresnel", word(&s.fresnel)),
            ("exposure", s.image.exposure.to_string()),
            ("seed", s.seed.to_string()),
            ("accel", s.accel.name().to_owned()),
            ("max-rays", s.recursion.max_rays.to_string()),
        ]
    };
    let pairs = values(now).into_iter().zip(values(&scene.settings));
    let changed = pairs.filter(|(now, own)| now != own).map(|(now, _)| now);
    let adaptive = now.pixel.adaptive.into_iter().flat_map(|adaptive| {
        [
            ("adaptive", adaptive.threshold.to_string()),
            ("max-samples", adaptive.most.to_string()),
            ("pilot", adaptive.pilot.name().to_owned()),
        ]
    });
    let left_out: Vec<&str> = now.left_out(scene).map(super::Effect::name).collect();
    let without = (!left_out.is_empty()).then(|| ("without", left_out.join(",")));
    let arithmetic = now.arithmetic.deviations().into_iter();
    changed
        .chain(adaptive)
        .chain(without)
        .chain(arithmetic.map(|d| (d.choice, d.value)))
        .collect()
}
