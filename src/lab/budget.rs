//! How much can be afforded: from three small renders, how many samples fit into a time.

use std::ops::ControlFlow;
use std::time::Instant;

use super::effort::{EFFORTS, Effort};
use super::parameter::Parameter;
use super::parameters::parameters;
use crate::probe::Silent;
use crate::sampling::Sampler;
use crate::scene::Settings;
use crate::trace::Counts;
use crate::tracer::render;
use crate::world::World;

/// How many times slower than the fastest an accelerator may be; a tree deeper than what was asked for; and so on.
const OTHER: f64 = 3.0;

/// How many times slower it is to test shapes one by one.
const ONE_BY_ONE: f64 = 1.5;

/// The part of the time that is planned with: other work may slow down what follows.
const CAREFUL: f64 = 0.7;

/// Seconds that renders take.
#[derive(Clone, Copy, Debug)]
pub struct CostModel {
    /// A sample of every pixel, without its rays to area lights.
    sample: f64,
    /// A ray to each area light from where these arrive.
    light: f64,
    /// How many times longer it takes to count.
    counting: f64,
}

impl CostModel {
    /// Found out by rendering; of large pictures only smaller ones, since that takes time as well.
    pub fn of(world: &World, base: &Settings, threads: usize) -> Self {
        const MANY: u32 = 16;
        const EDGE: u32 = 120;
        let shrink = base
            .image
            .width
            .max(base.image.height)
            .div_ceil(EDGE)
            .max(1);
        let [width, height] =
            [base.image.width, base.image.height].map(|edge| edge.div_ceil(shrink));
        let pixels = |w: u32, h: u32| f64::from(w) * f64::from(h);
        let larger = pixels(base.image.width, base.image.height) / pixels(width, height);
        let one = base.with(|s| {
            s.pixel.samples = 1;
            s.light.samples = 1;
            s.light.sampler = Sampler::Sobol;
            s.image.width = width;
            s.image.height = height;
        });
        let many = one.with(|s| s.light.samples = MANY);
        let clock = |settings: &Settings, count: bool| {
            let start = Instant::now();
            let go_on = |_, _| ControlFlow::Continue(());
            if count {
                render::<Counts>(world, settings, threads, &go_on);
            } else {
                render::<Silent>(world, settings, threads, &go_on);
            }
            start.elapsed().as_secs_f64()
        };
        clock(&one, false); // to warm up
        let (counted, few, more) = (clock(&one, true), clock(&one, false), clock(&many, false));
        let light = ((more - few) / f64::from(MANY - 1)).max(0.0);
        Self {
            sample: (few - light).max(1e-6) * larger,
            light: light * larger,
            counting: (counted / few).max(1.0),
        }
    }

    /// What a picture takes.
    pub fn picture(self, settings: &Settings) -> f64 {
        let lights = self.light * f64::from(settings.light.samples);
        f64::from(settings.pixel.samples) * (self.sample + lights)
    }

    /// What the knobs of a group take, with their positions rendered `runs` times and counted once, and the reference.
    pub fn group(self, parameters: &[Parameter], runs: usize) -> f64 {
        let each = self.counting + runs as f64;
        let steps: f64 = parameters
            .iter()
            .flat_map(|parameter| parameter.steps.iter().map(move |step| (parameter, step)))
            .map(|(parameter, step)| {
                let factor = match parameter.theory {
                    Some(_) => 1.0,
                    None if parameter.is_arithmetic() => ONE_BY_ONE,
                    None => OTHER,
                };
                self.picture(&step.settings) * each * factor
            })
            .sum();
        let reference = parameters.first().and_then(|parameter| parameter.reference);
        steps + reference.map_or(0.0, |settings| self.picture(&settings))
    }
}

/// The largest effort with which what is asked for fits into `seconds`; the least one if none does.
pub fn affordable(
    world: &World,
    base: &Settings,
    model: CostModel,
    (seconds, runs): (f64, usize),
    asked: &dyn Fn(&Parameter) -> bool,
) -> Effort {
    let fits = |effort: &Effort| {
        let mut parameters = parameters(world, base, *effort);
        parameters.retain(|parameter| asked(parameter));
        let groups = parameters.chunk_by(|a, b| a.group == b.group);
        groups.map(|group| model.group(group, runs)).sum::<f64>() <= CAREFUL * seconds
    };
    let found = EFFORTS.into_iter().find(fits);
    found.unwrap_or(Effort::LEAST)
}
