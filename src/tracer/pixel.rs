//! One pixel: its samples, and their weighted sum.

use super::around;
use super::sampled::Sampled;
use super::whitted::Tracer;
use crate::math::Rgb;
use crate::probe::{Probe, Silent};
use crate::scene::Settings;
use crate::world::World;

/// A traced pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Its linear colour: the weighted sum of its samples' radiances, added in their order.
    pub color: Rgb,
    /// Rays that it cost.
    pub rays: u64,
    /// What it spent of its budget besides eye rays: rays, and questions to lights that needed none.
    pub spent: u64,
    /// True if a limit cut it short, so that its colour is not all that was asked for.
    pub cut: bool,
    /// Samples that it has.
    pub samples: u32,
    /// The estimated standard error of its luminance (see [`super::spread`]); infinite if nothing is known of it.
    pub error: f64,
    /// Samples whose radiance was no finite number, and the first of them. They count as black.
    pub spoiled: u32,
    /// The number of the first of them.
    pub first_spoiled: Option<u32>,
}

/// What a sample that brought this radiance counts: a number that is none does not spread into the pixel.
pub fn counted(radiance: Rgb) -> Rgb {
    if radiance.is_finite() {
        radiance
    } else {
        Rgb::BLACK
    }
}

impl Default for Pixel {
    /// No sample yet.
    fn default() -> Self {
        Self {
            color: Rgb::BLACK,
            rays: 0,
            spent: 0,
            cut: false,
            samples: 0,
            error: f64::INFINITY,
            spoiled: 0,
            first_spoiled: None,
        }
    }
}

/// Traces pixel (x, y) and tells `probe` of everything that happens. With any probe, on any thread, its colour is the
/// same bit for bit.
pub fn pixel<P: Probe>(world: &World, settings: &Settings, at: (u32, u32), probe: &mut P) -> Pixel {
    sampled(&mut Tracer::new(world, settings, probe), at)
}

/// The same with a tracer that is there already.
///
/// Where samples decide how many there are to be, their weights are known only after the last. A probe that listens
/// is told the truth from the first on: the pixel is traced silently before.
#[inline]
pub fn sampled<P: Probe>(tracer: &mut Tracer<P>, at: (u32, u32)) -> Pixel {
    let settings = tracer.settings;
    let mut sampled = alone(tracer, at);
    if P::LISTENS && sampled.decides() {
        let mut silent = Silent;
        let mut ahead = Tracer::new(tracer.world, settings, &mut silent);
        let found = follow(&mut ahead, &mut sampled);
        let told = of_count(tracer, at, found.samples);
        return Pixel {
            error: found.error,
            ..told
        };
    }
    follow(tracer, &mut sampled)
}

/// The same of a pixel whose number of samples is known.
pub fn of_count<P: Probe>(tracer: &mut Tracer<P>, at: (u32, u32), count: u32) -> Pixel {
    let (settings, budget) = (tracer.settings, tracer.budget);
    follow(
        tracer,
        &mut Sampled::with(settings, budget, at, Some(count)),
    )
}

/// A pixel without samples that is traced alone: if those around it decide how many it is to have, they are asked.
#[inline]
fn alone<P>(tracer: &Tracer<P>, at: (u32, u32)) -> Sampled {
    let (world, settings, budget) = (tracer.world, tracer.settings, tracer.budget);
    if settings.pixel.asks_around() {
        let count = around::of_one(world, settings, at);
        return Sampled::with(settings, budget, at, Some(count));
    }
    Sampled::new(settings, budget, at)
}

/// The same in silence, given up between two samples as soon as `stopped` says so.
pub fn pixel_unless(
    world: &World,
    settings: &Settings,
    at: (u32, u32),
    stopped: &dyn Fn() -> bool,
) -> Option<Pixel> {
    let mut silent = Silent;
    let mut tracer = Tracer::new(world, settings, &mut silent);
    let mut sampled = alone(&tracer, at);
    while sampled.is_open(settings) {
        if stopped() {
            return None;
        }
        sampled.next(&mut tracer);
    }
    Some(*sampled.finish(settings))
}

/// Takes sample after sample, to the last.
fn follow<P: Probe>(tracer: &mut Tracer<P>, sampled: &mut Sampled) -> Pixel {
    sampled.follow(tracer);
    *sampled.finish(tracer.settings)
}
