//! Rendering until the picture is near enough: with more and more samples, until its estimated error is small enough.
//!
//! The error of a picture is the root of the mean square of its pixels' standard errors (of linear luminance): what
//! the RMSE against the true picture is expected to be. Each pass is a picture with so many samples for all pixels, from
//! the start, so that the last one can be had again by asking for its number of samples. The samples are parted into
//! sets, from whose differences the error is estimated (see [`crate::sampling::batch_means`]).

use std::ops::ControlFlow;

use std::time::Instant;

use crate::probe::Silent;
use crate::sampling::Sampler;
use crate::scene::{Settings, limits};
use crate::tracer::{Film, render};
use crate::world::World;

/// Sets of a pass: enough to tell how much they differ, and few, since samples of one set complete each other.
pub const SETS: u32 = 8;

/// How many times as many samples the next pass has, at least and at most: an estimate from a few samples is uncertain.
const GROWTH: [f64; 2] = [1.25, 4.0];

/// One picture of the series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// Samples a pixel.
    pub samples: u32,
    /// The estimated error.
    pub error: f64,
    /// Rays that it cost.
    pub rays: u64,
    /// Seconds that it took.
    pub seconds: f64,
}

/// Reason why there was no further pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The error is small enough.
    Reached,
    /// The next pass would need more rays than all passes together may cost.
    Rays,
    /// The next pass would need more samples than a pixel can have.
    Samples,
    /// It was stopped, or a pixel met its limit of rays.
    Cut,
}

/// Outcome of rendering until the error is small enough.
#[derive(Clone, Debug)]
pub struct Convergence {
    /// The last whole picture.
    pub film: Film,
    /// The settings that it can be had again with.
    pub settings: Settings,
    /// All passes, in order.
    pub passes: Vec<Pass>,
    /// Why there was no further one.
    pub stop: StopReason,
}

/// Renders until the error is at most `wanted`. The first pass has the samples of `settings`, rounded up to whole sets;
/// all together may cost `settings.recursion.max_rays`.
pub fn converge(
    world: &World,
    settings: &Settings,
    wanted: f64,
    threads: usize,
    watch: &(dyn Fn(u64, u64) -> ControlFlow<()> + Sync),
) -> Convergence {
    let mut now = settings.with(|s| {
        s.pixel.samples = whole_sets(f64::from(settings.pixel.samples));
        s.pixel.sets = SETS;
        s.pixel.adaptive = None;
        s.pixel.errors = true;
    });
    let mut passes: Vec<Pass> = Vec::new();
    let mut spent = 0;
    loop {
        let start = Instant::now();
        let (film, _) = render::<Silent>(world, &now, threads, watch);
        let error = film.error().unwrap_or(f64::INFINITY);
        let (samples, rays) = (now.pixel.samples, film.rays);
        passes.push(Pass {
            samples,
            error,
            rays,
            seconds: start.elapsed().as_secs_f64(),
        });
        spent += rays;
        let next = whole_sets(f64::from(samples) * growth(&now, error / wanted));
        let cost = rays as f64 * f64::from(next) / f64::from(samples);
        let stop = if film.truncated {
            StopReason::Cut
        } else if error <= wanted {
            StopReason::Reached
        } else if next > limits::MAX_SAMPLES {
            StopReason::Samples
        } else if spent as f64 + cost > settings.recursion.max_rays as f64 {
            StopReason::Rays
        } else {
            now.pixel.samples = next;
            continue;
        };
        return Convergence {
            film,
            settings: now,
            passes,
            stop,
        };
    }
}

/// How many times as many samples bring the error down by `factor`: it falls as n^-1/2 if the samples are independent,
/// and at least as n^-3/4 if they are evenly spread (Mitchell 1996).
fn growth(settings: &Settings, factor: f64) -> f64 {
    let power = if settings.pixel.sampler == Sampler::Random {
        2.0
    } else {
        4.0 / 3.0
    };
    let [least, most] = GROWTH;
    libm::pow(factor, power).clamp(least, most)
}

/// The next number of samples that can be parted into sets of one size.
fn whole_sets(samples: f64) -> u32 {
    (samples / f64::from(SETS)).ceil().max(1.0) as u32 * SETS
}
